#!/usr/bin/env python3
"""Draws the cells of a mesh of the plane, curved as they are, as SVG:

    mesh_picture.py MESH.msh OUTPUT.svg

MESH is what `blockfsi mesh CASE -o MESH.msh` writes. Triangles are blue, quadrilaterals orange. Needs python3-gmsh, which
reads the mesh."""
import pathlib
import sys

import gmsh

WIDTH = 900  # of the picture
COLOURS = {3: "#dcebf5", 4: "#fbe3c8"}  # by number of corners


def outline(corner_count, order):
    """Nodes of a cell around its sides, in Gmsh's order: corners first, then the inner nodes of each side."""
    inner = order - 1
    nodes = []
    for side in range(corner_count):
        first = corner_count + side * inner
        nodes += [side, *range(first, first + inner)]
    return nodes


def read(path):
    """Outlines of all cells as (corner count, points), in the order of the file."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(str(path))
    tags, x, _ = gmsh.model.mesh.getNodes()
    at = {tag: (x[3 * i], x[3 * i + 1]) for i, tag in enumerate(tags)}
    cells = []
    for kind, _, nodes in zip(*gmsh.model.mesh.getElements(2)):
        _, _, order, node_count, _, corner_count = gmsh.model.mesh.getElementProperties(kind)
        around = outline(corner_count, order)
        cells += [(corner_count, [at[nodes[first + k]] for k in around]) for first in range(0, len(nodes), node_count)]
    gmsh.finalize()
    return cells


def main(mesh, output):
    cells = read(mesh)
    points = [point for _, outline_ in cells for point in outline_]
    low, high = ([pick(point[d] for point in points) for d in range(2)] for pick in (min, max))
    scale = (WIDTH - 8) / (high[0] - low[0])
    height = 8 + scale * (high[1] - low[1])
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height:.0f}" stroke="#35506b" '
             'stroke-width="0.7" stroke-linejoin="round">']
    for corner_count in sorted(COLOURS):
        path = "".join("M" + " ".join(f"{4 + scale * (x - low[0]):.1f},{4 + scale * (high[1] - y):.1f}"
                                      for x, y in outline_) + "Z" for count, outline_ in cells if count == corner_count)
        lines.append(f'<path fill="{COLOURS[corner_count]}" d="{path}"/>')
    output.write_text("\n".join([*lines, "</svg>", ""]))
    print(f"{output}: {len(cells)} cells")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
