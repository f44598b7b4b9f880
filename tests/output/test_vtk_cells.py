"""Opens mesh files with VTK and integrates them there: python3 test_vtk_cells.py WRITE_CELLS CONVERT_MESH"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter
except ImportError:
    print("VTK for Python is not installed; install python3-vtk9")
    sys.exit(77)
import numpy as np

FOLDER = None
CONVERT = None
# vtkCellType.h: simplices, and what is a product of a triangle and a line
TRIANGLES, TETRAHEDRA, WEDGES, PLANE = {5, 69}, {10, 71}, {13, 73}, {5, 69, 9, 70}


def expected():
    for line in (FOLDER / "integrals.txt").read_text().splitlines():
        words = line.split(";")
        yield f"{words[0]}-{words[1]}", words[0], int(words[1]), int(words[2]), float(words[3]), float(words[4])


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    failures = []
    reader.AddObserver("ErrorEvent", lambda *_: failures.append(path))
    reader.SetFileName(str(path))
    reader.Update()
    assert not failures, f"VTK cannot read {path}"
    return reader.GetOutput()


def rule(kind, order):
    """Points and weights on VTK's reference cell of a type; triangles by a collapsed square, and so on."""
    n = 2 * order + 3
    x, w = np.polynomial.legendre.leggauss(n)
    x, w = 0.5 * (1.0 + x), 0.5 * w
    if kind in PLANE:
        a, b = np.meshgrid(x, x, indexing="ij")
        weight = np.outer(w, w)
        if kind in TRIANGLES:
            weight = weight * (1.0 - b)
            a = a * (1.0 - b)
        return np.stack([a.ravel(), b.ravel(), 0.0 * a.ravel()], 1), weight.ravel()
    a, b, c = np.meshgrid(x, x, x, indexing="ij")
    weight = np.einsum("i,j,k->ijk", w, w, w)
    if kind in TETRAHEDRA:
        weight = weight * (1.0 - b) * (1.0 - c) ** 2
        a, b = a * (1.0 - b) * (1.0 - c), b * (1.0 - c)
    elif kind in WEDGES:
        weight = weight * (1.0 - b)
        a = a * (1.0 - b)
    return np.stack([a.ravel(), b.ravel(), c.ravel()], 1), weight.ravel()


def tables(cell, points, dim):
    """Functions of a cell, shape (points, nodes), and derivatives, shape (points, nodes, dim), as VTK has them."""
    n = cell.GetNumberOfPoints()
    # VTK stores derivatives by direction, but those of Lagrange quadrilaterals and hexahedra by node.
    by_node = cell.GetCellType() in (70, 72)
    values, derivatives = [], []
    for point in points:
        value, derivative = [0.0] * n, [0.0] * (dim * n)
        cell.InterpolateFunctions(list(point), value)
        cell.InterpolateDerivs(list(point), derivative)
        values.append(value)
        derivatives.append(np.reshape(derivative, (n, dim) if by_node else (dim, n)))
        if not by_node:
            derivatives[-1] = derivatives[-1].T
    return np.array(values), np.array(derivatives)



def integrals(grid, order, dim, name):
    """Measure of a grid and integral of a field, with the smallest determinant."""
    measure, integral, least = 0.0, 0.0, np.inf
    x = vtk_to_numpy(grid.GetPoints().GetData())
    field = vtk_to_numpy(grid.GetPointData().GetArray(name))
    cached = {}
    for c in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(c)
        kind = cell.GetCellType()
        if kind not in cached:
            points, weights = rule(kind, order)
            cached[kind] = (*tables(cell, points, dim), weights)
        values, derivatives, weights = cached[kind]
        nodes = [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]
        jacobians = np.einsum("qnt,nd->qtd", derivatives, x[nodes][:, :dim])
        determinants = np.linalg.det(jacobians)
        least = min(least, determinants.min())
        measure += float((determinants * weights).sum())
        integral += float((determinants * weights * (values @ field[nodes])).sum())
    return measure, integral, least


class Files(unittest.TestCase):
    def test_measures_and_integrals_of_fields_are_ours_in_every_shape_and_order(self):
        for stem, _, order, dim, measure, integral in expected():
            if order > 5 and dim == 3:
                continue  # VTK's functions at each point in Python take long; test_every_order_in_space has these
            with self.subTest(stem):
                found = integrals(read(FOLDER / f"{stem}.vtu"), order, dim, "product")
                self.assertAlmostEqual(found[0] / measure, 1.0, delta=1e-11)
                self.assertAlmostEqual(found[1] / integral, 1.0, delta=1e-11)
                self.assertGreater(found[2], 0.0)

    def test_coordinates_as_field_are_the_coordinates(self):
        for stem, _, order, dim, _, _ in expected():
            grid = read(FOLDER / f"{stem}.vtu")
            position = vtk_to_numpy(grid.GetPointData().GetArray("position"))
            used = np.unique(vtk_to_numpy(grid.GetCells().GetConnectivityArray()))
            self.assertLess(abs(position - vtk_to_numpy(grid.GetPoints().GetData()))[used].max(), 1e-13)

    def test_field_data_name_blocks_regions_and_boundaries(self):
        data = read(FOLDER / "mixed3d-3.vtu").GetFieldData()
        strings = lambda name: [data.GetAbstractArray(name).GetValue(k)
                                for k in range(data.GetAbstractArray(name).GetNumberOfTuples())]
        self.assertEqual(strings("block_names"), ["first", "second block"])
        self.assertEqual(strings("block_regions"), ["fluid", "solid"])
        self.assertIn("outlet & more", strings("boundary_names"))
        self.assertEqual(data.GetArray("boundary_sides").GetNumberOfComponents(), 3)

    def test_files_written_by_vtk_in_any_encoding_are_read(self):
        for stem in ("mixed3d-3", "prism-5", "mixed2d-4", "pyramid-1"):
            grid = read(FOLDER / f"{stem}.vtu")
            expected_measure, name = next((e[4], e) for e in expected() if e[0] == stem)
            for mode in ("SetDataModeToAscii", "SetDataModeToBinary", "SetDataModeToAppended", "raw"):
                for compressor in (0, 1):  # none, zlib
                    for header in (32, 64):
                        with self.subTest(stem=stem, mode=mode, compressor=compressor, header=header):
                            writer = vtkXMLUnstructuredGridWriter()
                            writer.SetFileName(str(FOLDER / "by-vtk.vtu"))
                            writer.SetInputData(grid)
                            if mode == "raw":
                                writer.SetDataModeToAppended()
                                writer.EncodeAppendedDataOff()
                            else:
                                getattr(writer, mode)()
                            writer.SetCompressorType(compressor)
                            writer.SetHeaderType(header)
                            self.assertEqual(writer.Write(), 1)
                            subprocess.run([CONVERT, FOLDER / "by-vtk.vtu", FOLDER / "again.vtu"], check=True)
                            again = integrals(read(FOLDER / "again.vtu"), name[2], name[3], "product")
                            self.assertAlmostEqual(again[0] / expected_measure, 1.0, delta=1e-6)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        FOLDER = Path(folder)
        CONVERT = sys.argv.pop(2)
        subprocess.run([sys.argv.pop(1), folder], check=True)
        unittest.main()
