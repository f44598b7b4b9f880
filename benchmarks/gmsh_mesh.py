#!/usr/bin/env python3
"""Makes one of the domains of benchmarks/domain.hpp with Gmsh, transfinite, and prints what that took, as JSON:

    gmsh_mesh.py square|tube CELLS ORDER RATIO [--simplices] [--file FILE.msh]

CELLS along each edge of the blocks; RATIO of the sizes of the last and the first cell on the edges that lead away from
the hole or the inside of the tube. Quadrilaterals and hexahedra, or with --simplices triangles and tetrahedra. Only the
making of the mesh is timed (CPU seconds), not the description of the geometry."""
import argparse
import json
import math
import resource
import time

import gmsh

geometry = None


def grade(curves, cells, ratio):
    step = ratio ** (1 / (cells - 1)) if cells > 1 else 1.0
    for curve in curves:
        geometry.mesh.setTransfiniteCurve(curve, cells + 1, "Progression", step)


def divide(curves, cells):
    for curve in curves:
        geometry.mesh.setTransfiniteCurve(curve, cells + 1)


def add_face(curves, simplices, plane=True):
    loop = geometry.addCurveLoop(curves)
    surface = geometry.addPlaneSurface([loop]) if plane else geometry.addSurfaceFilling([loop])
    geometry.mesh.setTransfiniteSurface(surface)
    if not simplices:
        geometry.mesh.setRecombine(2, surface)
    return surface


def describe_square(cells, ratio, simplices):
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    middle = geometry.addPoint(0, 0, 0)
    inner = [geometry.addPoint(0.5 / math.sqrt(2) * x, 0.5 / math.sqrt(2) * y, 0) for x, y in corners]
    outer = [geometry.addPoint(x, y, 0) for x, y in corners]
    arcs = [geometry.addCircleArc(inner[i], middle, inner[(i + 1) % 4]) for i in range(4)]
    sides = [geometry.addLine(outer[i], outer[(i + 1) % 4]) for i in range(4)]
    spokes = [geometry.addLine(inner[i], outer[i]) for i in range(4)]
    divide(arcs + sides, cells)
    grade(spokes, cells, ratio)
    return [add_face([spokes[i], sides[i], -spokes[(i + 1) % 4], -arcs[i]], simplices) for i in range(4)]


def describe_tube(cells, ratio, simplices):
    at = [(0.5, 0), (1, 0), (0, 1), (0, 0.5)]
    low, high = ([geometry.addPoint(x, y, z) for x, y in at] for z in (0, 1))
    axis = [geometry.addPoint(0, 0, z) for z in (0, 1)]
    inner = [geometry.addCircleArc(end[0], axis[k], end[3]) for k, end in enumerate((low, high))]
    outer = [geometry.addCircleArc(end[1], axis[k], end[2]) for k, end in enumerate((low, high))]
    first = [geometry.addLine(end[0], end[1]) for end in (low, high)]
    last = [geometry.addLine(end[3], end[2]) for end in (low, high)]
    along = [geometry.addLine(low[i], high[i]) for i in range(4)]
    divide(inner + outer + along, cells)
    grade(first + last, cells, ratio)
    faces = [add_face([first[k], outer[k], -last[k], -inner[k]], simplices) for k in range(2)]
    faces += [add_face([first[0], along[1], -first[1], -along[0]], simplices),
              add_face([last[0], along[2], -last[1], -along[3]], simplices),
              add_face([inner[0], along[3], -inner[1], -along[0]], simplices, plane=False),
              add_face([outer[0], along[2], -outer[1], -along[1]], simplices, plane=False)]
    volume = geometry.addVolume([geometry.addSurfaceLoop(faces)])
    geometry.mesh.setTransfiniteVolume(volume, [low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3]])
    return [volume]


def main():
    global geometry
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("domain", choices=["square", "tube"])
    parser.add_argument("cells", type=int)
    parser.add_argument("order", type=int)
    parser.add_argument("ratio", type=float)
    parser.add_argument("--simplices", action="store_true")
    parser.add_argument("--file")
    wanted = parser.parse_args()
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    geometry = gmsh.model.geo
    describe, dim = (describe_square, 2) if wanted.domain == "square" else (describe_tube, 3)
    parts = describe(wanted.cells, wanted.ratio, wanted.simplices)
    geometry.synchronize()
    gmsh.model.addPhysicalGroup(dim, parts)
    start = time.process_time()
    gmsh.model.mesh.generate(dim)
    gmsh.model.mesh.setOrder(wanted.order)
    seconds = time.process_time() - start
    peak = 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    nodes = len(gmsh.model.mesh.getNodes()[0])
    if wanted.file:
        gmsh.write(wanted.file)
    print(json.dumps({"nodes": nodes, "seconds": seconds, "peak": peak,
                      "version": gmsh.option.getString("General.Version")}))
    gmsh.finalize()


if __name__ == "__main__":
    main()
