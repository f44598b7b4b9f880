#!/usr/bin/env python3
"""tidy.py BUILD JOBS: clang-tidy over all sources of this repository in BUILD/compile_commands.json. A source is
checked again only if it, a header that it includes, or .clang-tidy has changed since it was found clean."""
import concurrent.futures
import hashlib
import json
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).parent.parent.resolve()


def dependencies(build):
    """Headers of this repository per object file, as the last build saw them."""
    result, headers = {}, []
    for line in subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True).stdout.splitlines():
        if line.startswith("    "):
            path = (build / line.strip()).resolve()
            if path.is_relative_to(root):
                headers.append(path)
        elif ": #deps" in line:
            headers = result.setdefault(line.split(":")[0], [])
    return result


def key(command, headers):
    digest = hashlib.sha256(command["command"].encode())
    for path in [root / ".clang-tidy", pathlib.Path(command["file"]), *sorted(headers)]:
        digest.update(path.read_bytes() if path.exists() else b"")
    return digest.hexdigest()


def tidy(build, command, stamp):
    call = ["clang-tidy", "--quiet", "-p", build, "--extra-arg=-Wno-unknown-warning-option", command["file"]]
    done = subprocess.run(call, capture_output=True, text=True)
    if done.returncode == 0 and "warning:" not in done.stdout:
        stamp.touch()
        return ""
    return done.stdout + ("" if done.stdout else done.stderr)


def main():
    build, jobs = pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2])
    stamps = build / "tidy"
    stamps.mkdir(exist_ok=True)
    headers = dependencies(build)
    todo = []
    for command in json.loads((build / "compile_commands.json").read_text()):
        source = pathlib.Path(command["file"])
        if source.is_relative_to(root) and not source.is_relative_to(build):
            object_file = re.search(r" -o (\S+)", command["command"]).group(1)
            stamp = stamps / key(command, headers.get(object_file, []))
            if not stamp.exists():
                todo.append((command, stamp))
    print(f"clang-tidy: {len(todo)} sources to check", flush=True)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        reports = [report for report in pool.map(lambda each: tidy(build, *each), todo) if report]
    print("".join(reports) if reports else "clang-tidy: clean")
    return 1 if reports else 0


if __name__ == "__main__":
    sys.exit(main())
