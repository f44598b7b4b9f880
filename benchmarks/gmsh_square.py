#!/usr/bin/env python3
"""Makes the domain of benchmarks/domain.hpp with Gmsh and prints the time that takes, as JSON:

    gmsh_square.py ORDER CELLS

Transfinite quadrilaterals, CELLS along each side of the four blocks. Only the making of the mesh is timed, not the
description of the geometry."""
import json
import math
import sys
import time

import gmsh


def growth(cells, length, first):
    """Ratio of geometric cells of which the first has the given size, by bisection."""
    low, high = 1.0, 2.0
    for _ in range(200):
        ratio = 0.5 * (low + high)
        total = first * math.expm1(cells * math.log(ratio)) / (ratio - 1.0) if ratio > 1.0 else first * cells
        low, high = (ratio, high) if total < length else (low, ratio)
    return low


def describe(cells):
    geometry = gmsh.model.geo
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    middle = geometry.addPoint(0, 0, 0)
    inner = [geometry.addPoint(0.5 / math.sqrt(2) * x, 0.5 / math.sqrt(2) * y, 0) for x, y in corners]
    outer = [geometry.addPoint(x, y, 0) for x, y in corners]
    arcs = [geometry.addCircleArc(inner[i], middle, inner[(i + 1) % 4]) for i in range(4)]
    sides = [geometry.addLine(outer[i], outer[(i + 1) % 4]) for i in range(4)]
    spokes = [geometry.addLine(inner[i], outer[i]) for i in range(4)]
    length = math.sqrt(2) - 0.5
    ratio = growth(cells, length, 0.05 * length / cells)
    for line in arcs + sides:
        geometry.mesh.setTransfiniteCurve(line, cells + 1)
    for line in spokes:
        geometry.mesh.setTransfiniteCurve(line, cells + 1, "Progression", ratio)
    for i in range(4):
        loop = geometry.addCurveLoop([spokes[i], sides[i], -spokes[(i + 1) % 4], -arcs[i]])
        surface = geometry.addPlaneSurface([loop])
        geometry.mesh.setTransfiniteSurface(surface)
        geometry.mesh.setRecombine(2, surface)
    geometry.synchronize()


def main(order, cells):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    describe(cells)
    start = time.process_time()
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(order)
    seconds = time.process_time() - start
    nodes = len(gmsh.model.mesh.getNodes()[0])
    print(json.dumps({"nodes": nodes, "seconds": seconds, "version": gmsh.option.getString("General.Version")}))
    gmsh.finalize()


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]))
