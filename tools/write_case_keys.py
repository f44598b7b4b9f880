#!/usr/bin/env python3
"""Writes docs/case-keys.md, the reference of all keys of a case file, from what `blockfsi describe` prints:

    write_case_keys.py BLOCKFSI [--check]

With --check it writes nothing and exits with 1 if the page is not what it should be."""
import pathlib
import subprocess
import sys

page = pathlib.Path(__file__).resolve().parent.parent / "docs/case-keys.md"
HEAD = """# All keys of a case file

Written by `tools/write_case_keys.py` from `blockfsi describe`: change the declarations in `src/case/`, not this page.
What the sections are for, and how a file is read: [the case file](case.md).

```
"""


def main(blockfsi, check):
    described = subprocess.run([blockfsi, "describe"], capture_output=True, text=True, check=True).stdout
    text = HEAD + described + "```\n"
    if not check:
        page.write_text(text)
    elif not page.exists() or page.read_text() != text:
        sys.exit(f"{page} is not what {blockfsi} describes; run tools/write_case_keys.py {blockfsi}")


if __name__ == "__main__":
    arguments = [argument for argument in sys.argv[1:] if argument != "--check"]
    if len(arguments) != 1:
        sys.exit(__doc__)
    main(arguments[0], "--check" in sys.argv)
