#!/usr/bin/env python3
"""Draws vorticity and mesh at one time of a run, as PNG:

    picture.py RESULTS TIME OUTPUT.png [X0 X1 Y0 Y1]

RESULTS is the folder of a finished run, TIME in seconds (the nearest fields are taken), X0 ... Y1 the part of the
domain to show [m]. Needs numpy and python3-vtk9, whose own drawing would need a display."""
import pathlib
import struct
import sys
import xml.etree.ElementTree
import zlib

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

WIDTH = 1000  # pixels
SAMPLES = 2   # along each side of a pixel


def lagrange(order, t):
    """Functions on equispaced nodes and their derivatives, shape (points, order + 1)."""
    nodes = numpy.arange(order + 1) / order
    value = numpy.ones((len(t), order + 1))
    slope = numpy.zeros((len(t), order + 1))
    for i in range(order + 1):
        others = [j for j in range(order + 1) if j != i]
        for j in others:
            value[:, i] *= (t - nodes[j]) / (nodes[i] - nodes[j])
            factor = numpy.ones(len(t)) / (nodes[i] - nodes[j])
            for k in others:
                if k != j:
                    factor *= (t - nodes[k]) / (nodes[i] - nodes[k])
            slope[:, i] += factor
    return value, slope


def positions(order):
    """Where node (i, j) stands in VTK's list: corners, then edges, then the inside; shape (order + 1, order + 1)."""
    inner = order - 1
    result = numpy.zeros((order + 1, order + 1), int)
    result[0, 0], result[order, 0], result[order, order], result[0, order] = 0, 1, 2, 3
    for k in range(inner):
        result[k + 1, 0] = 4 + k
        result[order, k + 1] = 4 + inner + k
        result[k + 1, order] = 4 + 2 * inner + k
        result[0, k + 1] = 4 + 3 * inner + k
        for l in range(inner):
            result[k + 1, l + 1] = 4 + 4 * inner + k + l * inner
    return result


def read(path):
    """Nodal x and velocity by cell, shape (cells, order + 1, order + 1, 2) each."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(grid.GetNumberOfCells(), -1)
    cells = cells[:, positions(int(round(cells.shape[1] ** 0.5)) - 1)]
    return tuple(vtk_to_numpy(array)[:, :2][cells]
                 for array in (grid.GetPoints().GetData(), grid.GetPointData().GetArray("velocity")))


class Canvas:
    def __init__(self, x0, x1, y0, y1):
        self.origin = numpy.array([x0, y1])
        self.scale = WIDTH * SAMPLES / (x1 - x0)
        height = int(round(WIDTH * (y1 - y0) / (x1 - x0)))
        self.colour = numpy.ones((height * SAMPLES, WIDTH * SAMPLES, 3))

    def pixels(self, x):
        """Rows and columns of points, and which of them are on the canvas."""
        at = numpy.floor((x - self.origin) * self.scale * [1, -1]).astype(int)
        inside = numpy.all((at >= 0) & (at < [self.colour.shape[1], self.colour.shape[0]]), axis=-1)
        return at[..., 1], at[..., 0], inside

    def points(self, x, axis):
        """Places along one direction of a cell such that no pixel is left out."""
        return numpy.linspace(0, 1, 2 + int(1.5 * self.scale * numpy.ptp(x, axis=axis).max()))

    def set(self, x, colour):
        rows, columns, inside = self.pixels(x)
        self.colour[rows[inside], columns[inside]] = colour[inside]

    def darken(self, x, factor):
        rows, columns, inside = self.pixels(x)
        marks = numpy.zeros(self.colour.shape[:2], bool)
        marks[rows[inside], columns[inside]] = True
        self.colour[marks] *= factor

    def write(self, path):
        height, width = self.colour.shape[0] // SAMPLES, self.colour.shape[1] // SAMPLES
        colour = self.colour.reshape(height, SAMPLES, width, SAMPLES, 3).mean(axis=(1, 3))
        bytes_ = numpy.round(numpy.round(colour * 42) / 42 * 255).astype(numpy.uint8)
        lines = b"".join(b"\0" + line.tobytes() for line in bytes_)

        def chunk(name, data):
            return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
                         + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


def diverging(value):
    """White at 0, red at 1, blue at -1."""
    v = numpy.clip(value, -1, 1)[..., None]
    red, blue = numpy.array([0.75, 0.12, 0.10]), numpy.array([0.10, 0.30, 0.70])
    return numpy.where(v > 0, 1 - v * (1 - red), 1 + v * (1 - blue))


def evaluate(first, second, nodal):
    """A nodal field of one cell by functions in its two directions, shape (points, points, components)."""
    return numpy.einsum("ai,bj,ijc->abc", first, second, nodal)


def vorticity(first, second, first_slope, second_slope, x, u):
    x_xi, x_eta = evaluate(first_slope, second, x), evaluate(first, second_slope, x)
    u_xi, u_eta = evaluate(first_slope, second, u), evaluate(first, second_slope, u)
    jacobian = x_xi[..., 0] * x_eta[..., 1] - x_xi[..., 1] * x_eta[..., 0]
    v_x = (u_xi[..., 1] * x_eta[..., 1] - u_eta[..., 1] * x_xi[..., 1]) / jacobian
    u_y = (u_eta[..., 0] * x_xi[..., 0] - u_xi[..., 0] * x_eta[..., 0]) / jacobian
    return v_x - u_y


def paint(canvas, x, u, largest):
    for cell_x, cell_u in zip(x, u):
        if not canvas.pixels(cell_x)[2].any():
            continue
        order = len(cell_x) - 1
        (first, first_slope), (second, second_slope) = (lagrange(order, canvas.points(cell_x, axis)) for axis in (0, 1))
        if largest is None:
            colour = numpy.broadcast_to(numpy.array([0.15, 0.15, 0.15]), (len(first), len(second), 3))
        else:
            colour = diverging(vorticity(first, second, first_slope, second_slope, cell_x, cell_u) / largest)
        canvas.set(evaluate(first, second, cell_x), colour)


def draw_lines(canvas, x):
    lines = []
    for cell in x:
        first, second = (lagrange(len(cell) - 1, canvas.points(cell, axis))[0] for axis in (0, 1))
        lines += [second @ cell[0], second @ cell[-1], first @ cell[:, 0], first @ cell[:, -1]]
    canvas.darken(numpy.concatenate(lines), 0.6)


def main(results, time, output, *view):
    series = xml.etree.ElementTree.parse(results / "fields.pvd").iter("DataSet")
    files = [(float(entry.get("timestep")), results / entry.get("file")) for entry in series]
    nearest = min((t for t, _ in files), key=lambda t: abs(t - time))
    regions = [(path, *read(path)) for t, path in files if t == nearest]
    everything = numpy.concatenate([x.reshape(-1, 2) for _, x, _ in regions])
    low, high = everything.min(axis=0), everything.max(axis=0)
    canvas = Canvas(*(view or (low[0], high[0], low[1], high[1])))
    fluid = next((x, u) for path, x, u in regions if path.name.startswith("fluid"))
    speed = numpy.percentile(numpy.hypot(fluid[1][..., 0], fluid[1][..., 1]), 99)
    for path, x, u in regions:
        is_fluid = path.name.startswith("fluid")
        # Colours are full where the velocity would change by its largest over a thirtieth of the picture.
        paint(canvas, x, u, 30 * speed * canvas.scale / canvas.colour.shape[1] if is_fluid else None)
        if is_fluid:
            draw_lines(canvas, x)
    canvas.write(output)
    print(f"{output}: t = {nearest:g} s")


if __name__ == "__main__":
    if len(sys.argv) not in (4, 8):
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), float(sys.argv[2]), pathlib.Path(sys.argv[3]), *map(float, sys.argv[4:]))
