#!/usr/bin/env python3
"""Runs the short form of a case and compares it with its references:

    run_short.py BLOCKFSI CASE_FOLDER RESULT_FOLDER

The settings of the short form are in CASE_FOLDER/short.set, one assignment in a line as `blockfsi run --set` takes
it; lines that begin with # are comments. Exits with the code of the first command that fails: 1 if a reference is
missed, 2 for a mistake in the case, 3 if the numbers failed."""
import os
import pathlib
import shlex
import subprocess
import sys


def settings(path):
    lines = [line.strip() for line in path.read_text().splitlines()]
    return [argument for line in lines if line and not line.startswith("#") for argument in ("--set", line)]


def call(*command):
    print("+", shlex.join(command), flush=True)
    # More threads would only get into each other's way: the matrices are small, and tests run side by side.
    code = subprocess.run(command, env={"OPENBLAS_NUM_THREADS": "1", **os.environ}).returncode
    if code != 0:
        sys.exit(code if code > 0 else f"{command[0]} was ended by signal {-code}")


def main(blockfsi, case_folder, result_folder):
    case_file = str(pathlib.Path(case_folder) / "case.toml")
    call(blockfsi, "run", case_file, *settings(pathlib.Path(case_folder) / "short.set"), "--directory", result_folder)
    call(blockfsi, "verify", case_file, "--finished", "--directory", result_folder, "--level", "short")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
