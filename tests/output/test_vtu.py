"""Opens field files with VTK and integrates them: python3 test_vtu.py PATH_OF_write_sample

The sample is the quarter annulus 1 <= r <= 2 of 3 x 6 cells, whose own axes are turned from cell to cell.
"""
import math
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader, vtkXMLUnstructuredGridReader
except ImportError:
    print("VTK for Python is not installed; install python3-vtk9")
    sys.exit(77)
import numpy as np

COLUMNS, ROWS = 3, 6
ORDERS = range(1, 9)
VTK_QUAD, VTK_LAGRANGE_QUADRILATERAL = 9, 70
FOLDER = None


def read(name):
    reader = vtkXMLPUnstructuredGridReader() if name.endswith(".pvtu") else vtkXMLUnstructuredGridReader()
    failures = []
    reader.AddObserver("ErrorEvent", lambda *_: failures.append(name))
    reader.SetFileName(str(FOLDER / name))
    reader.Update()
    assert not failures, f"VTK cannot read {name}"
    return reader.GetOutput()


def point_field(grid, name):
    return vtk_to_numpy(grid.GetPointData().GetArray(name))


def functions(cell, xi, eta):
    """Values and derivatives, shape (3, nodes), of the cell's functions as VTK evaluates them."""
    n = cell.GetNumberOfPoints()
    value, derivative = [0.0] * n, [0.0] * (2 * n)
    cell.InterpolateFunctions([xi, eta, 0.0], value)
    cell.InterpolateDerivs([xi, eta, 0.0], derivative)
    # VTK stores derivatives of linear cells by direction, those of Lagrange cells by node.
    by_node = cell.GetCellType() == VTK_LAGRANGE_QUADRILATERAL
    along_xi, along_eta = (derivative[0::2], derivative[1::2]) if by_node else (derivative[:n], derivative[n:])
    return np.array([value, along_xi, along_eta])


class Tabulated:
    """All cells of a grid at the points of a lattice of the reference cell."""

    def __init__(self, grid, points):
        self.grid = grid
        self.points = [(xi, eta) for xi in points for eta in points]
        tables = [functions(grid.GetCell(0), xi, eta) for xi, eta in self.points]
        self.table = np.array(tables)
        self.nodes = np.array([[grid.GetCell(c).GetPointId(k) for k in range(grid.GetCell(c).GetNumberOfPoints())]
                               for c in range(grid.GetNumberOfCells())])
        x = vtk_to_numpy(grid.GetPoints().GetData())[self.nodes]
        self.x = np.einsum("qi,cid->cqd", self.table[:, 0], x)
        along_xi = np.einsum("qi,cid->cqd", self.table[:, 1], x)
        along_eta = np.einsum("qi,cid->cqd", self.table[:, 2], x)
        self.jacobian = along_xi[..., 0] * along_eta[..., 1] - along_xi[..., 1] * along_eta[..., 0]

    def field(self, name):
        return np.einsum("qi,ci...->cq...", self.table[:, 0], point_field(self.grid, name)[self.nodes])


class Integral(Tabulated):
    def __init__(self, grid, n=10):
        points, weights = np.polynomial.legendre.leggauss(n)
        super().__init__(grid, 0.5 * (1.0 + points))
        self.weights = 0.25 * np.outer(weights, weights).ravel()

    def of(self, values=1.0):
        return float((values * self.jacobian * self.weights).sum())


class Files(unittest.TestCase):
    def test_cells_share_their_points_and_have_the_order_of_the_mesh(self):
        for order in ORDERS:
            grid = read(f"order-{order}.vtu")
            self.assertEqual(grid.GetNumberOfCells(), COLUMNS * ROWS)
            self.assertEqual(grid.GetNumberOfPoints(), (COLUMNS * order + 1) * (ROWS * order + 1))
            expected = VTK_QUAD if order == 1 else VTK_LAGRANGE_QUADRILATERAL
            self.assertEqual(set(grid.GetCellType(c) for c in range(grid.GetNumberOfCells())), {expected})
            self.assertEqual(grid.GetCell(0).GetNumberOfPoints(), (order + 1) ** 2)

    def test_no_cell_is_turned_inside_out(self):
        for order in ORDERS:
            cells = Tabulated(read(f"order-{order}.vtu"), np.linspace(0.0, 1.0, 7))
            self.assertGreater(cells.jacobian.min(), 0.0)

    def test_area_and_integrals_are_exact_to_the_accuracy_of_the_cells(self):
        for order in ORDERS:
            integral = Integral(read(f"order-{order}.vtu"))
            x, y = integral.x[..., 0], integral.x[..., 1]
            # Chords and arcs of higher order: error like (angle of a cell / 4)^(2 order).
            tolerance = 10.0 * (math.pi / 2.0 / ROWS / 4.0) ** (2 * order) + 1e-13
            self.assertAlmostEqual(integral.of() / (0.75 * math.pi), 1.0, delta=tolerance)
            self.assertAlmostEqual(integral.of(x) / (7.0 / 3.0), 1.0, delta=tolerance)
            self.assertAlmostEqual(integral.of(x * y) / (15.0 / 8.0), 1.0, delta=tolerance)
            self.assertAlmostEqual(integral.of(integral.field("product")) / (15.0 / 8.0), 1.0, delta=2.0 * tolerance)

    def test_straight_cells_have_the_area_of_their_polygons(self):
        area = ROWS * 0.5 * (4.0 - 1.0) * math.sin(math.pi / 2.0 / ROWS)
        self.assertAlmostEqual(Integral(read("order-1.vtu")).of(), area, delta=1e-14)

    def test_coordinates_as_field_are_the_coordinates(self):
        for order in ORDERS:
            cells = Tabulated(read(f"order-{order}.vtu"), [0.0, 0.123, 0.5, 0.89, 1.0])
            self.assertEqual(cells.field("position").shape[-1], 3)
            self.assertLess(abs(cells.field("position") - cells.x).max(), 1e-14)

    def test_a_polynomial_of_the_order_of_the_mesh_is_reproduced_between_the_points(self):
        # The radius is linear along one axis of each cell: VTK sees that only if it is evaluated at VTK's nodes.
        for order in ORDERS:
            cells = Tabulated(read(f"order-{order}.vtu"), [0.0, 0.123, 0.4, 0.5, 0.89, 1.0])
            radius = cells.field("radius")
            self.assertLess(abs(cells.field("power") - (radius - 1.0) ** order).max(), 1e-12)
            inner = radius.min(axis=1, keepdims=True)
            fraction = np.array(cells.points)
            linear = [inner + f / COLUMNS for f in (fraction[:, 0], fraction[:, 1], 1 - fraction[:, 0], 1 - fraction[:, 1])]
            self.assertLess(np.min([abs(radius - g).max(axis=1) for g in linear], axis=0).max(), 1e-13)

    def test_cell_fields_keep_their_values_and_types(self):
        grid = read("order-3.vtu")
        number = vtk_to_numpy(grid.GetCellData().GetArray("number"))
        block = vtk_to_numpy(grid.GetCellData().GetArray("block"))
        self.assertTrue((number == np.arange(COLUMNS * ROWS)).all())
        self.assertTrue((block == np.arange(COLUMNS * ROWS) // COLUMNS).all())
        self.assertEqual(block.dtype, np.int32)

    def test_the_pieces_of_two_processes_make_the_whole(self):
        for order in ORDERS:
            whole, pieces = Integral(read(f"order-{order}.vtu")), Integral(read(f"order-{order}.pvtu"))
            self.assertEqual(pieces.grid.GetNumberOfCells(), COLUMNS * ROWS)
            self.assertAlmostEqual(pieces.of(), whole.of(), delta=1e-13)
            self.assertAlmostEqual(pieces.of(pieces.field("product")), whole.of(whole.field("product")), delta=1e-13)
            for name in ("number", "block"):
                self.assertIsNotNone(pieces.grid.GetCellData().GetArray(name))

    def test_the_series_is_well_formed_and_names_files_that_exist(self):
        snapshots = xml.parse(FOLDER / "series.pvd").getroot().findall("Collection/DataSet")
        self.assertEqual([float(s.get("timestep")) for s in snapshots], [0.1 * order for order in ORDERS])
        for snapshot in snapshots:
            self.assertTrue((FOLDER / snapshot.get("file")).exists())


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        FOLDER = Path(folder)
        subprocess.run([sys.argv.pop(1), folder], check=True)
        unittest.main()
