#!/usr/bin/env python3
"""Checks the documentation: each relative link in a Markdown file leads somewhere, each folder of src/ has its
chapter docs/<folder>.md, named in docs/README.md and in src/README.md. Prints each breach, exits 1 if there is any."""
import pathlib
import re
import sys

root = pathlib.Path(__file__).parent.parent.resolve()
pages = [page for page in sorted(root.rglob("*.md"))
         if not {"build", "results", ".git"} & set(page.relative_to(root).parts)]
breaches = []
for page in pages:
    for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", page.read_text()):
        if "://" not in target and not (page.parent / target).exists():
            breaches.append(f"{page.relative_to(root)}: there is no {target}")
for folder in sorted(path.name for path in (root / "src").iterdir() if path.is_dir()):
    if not (root / "docs" / f"{folder}.md").exists():
        breaches.append(f"docs/{folder}.md is missing: src/{folder} has no chapter")
    if f"({folder}.md)" not in (root / "docs/README.md").read_text():
        breaches.append(f"docs/README.md does not list {folder}.md")
    if f"../docs/{folder}.md" not in (root / "src/README.md").read_text():
        breaches.append(f"src/README.md does not list {folder}")
print("\n".join(breaches) if breaches else f"documentation is whole: {len(pages)} pages; start with docs/README.md")
sys.exit(1 if breaches else 0)
