#!/usr/bin/env python3
"""Checks the sources against layers.txt: a layer includes only what its line names, a line names only lines
above it, lines and folders of src/ match, each source includes its own header first, and PETSc and MPI are
seen in linalg alone. `check_layers.py [ROOT]` prints each breach and exits 1 if there is any."""
import pathlib
import re
import sys


def read_layers(root, breaches):
    uses = {}
    for line in (root / "layers.txt").read_text().splitlines():
        layer, _, names = line.partition(":")
        for name in names.split():
            if name not in uses:
                breaches.append(f"layers.txt: '{layer}' names '{name}', which is no line above it")
        uses[layer] = set(names.split()) | {layer}
    return uses


def check_file(root, path, uses, breaches):
    where = path.relative_to(root)
    layer = path.relative_to(root / "src").parts[0]
    included = re.findall(r'^\s*#\s*include\s*(["<])([^">]+)[">]', path.read_text(), re.MULTILINE)
    for kind, name in included:
        folder = name.split("/")[0]
        if kind == '"' and (folder not in uses or not (root / "src" / name).is_file()):
            breaches.append(f"{where}: \"{name}\" is no file of a layer below src/")
        elif folder in uses and kind == '"' and folder not in uses[layer]:
            breaches.append(f"{where}: '{layer}' may not include \"{name}\"")
        elif kind == "<" and re.match(r"petsc|mpi\.h", name) and layer != "linalg":
            breaches.append(f"{where}: <{name}> is for src/linalg alone")
    own = path.with_suffix(".hpp")
    if path.suffix == ".cpp" and own.exists():
        if not included or included[0][1] != str(own.relative_to(root / "src")):
            breaches.append(f"{where}: the first include must be its own header, which shows that it stands alone")


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    breaches = []
    uses = read_layers(root, breaches)
    folders = {path.name for path in (root / "src").iterdir() if path.is_dir()}
    breaches += [f"src/{name} has no line in layers.txt" for name in sorted(folders - uses.keys())]
    breaches += [f"layers.txt: '{name}' has no folder in src/" for name in sorted(uses.keys() - folders)]
    files = [path for path in sorted((root / "src").rglob("*")) if path.suffix in (".hpp", ".cpp", ".inl")]
    for path in files:
        if path.relative_to(root / "src").parts[0] in uses:
            check_file(root, path, uses, breaches)
    print("\n".join(breaches) if breaches else f"layers hold: {len(uses)} layers, {len(files)} files")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
