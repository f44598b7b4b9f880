"""Opens mesh files with Gmsh and integrates them there: python3 test_gmsh.py WRITE_CELLS CONVERT_MESH"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import gmsh
except ImportError:
    print("Gmsh for Python is not installed; install gmsh and python3-gmsh")
    sys.exit(77)
import numpy as np

FOLDER = None
CONVERT = None
NAMES = ["triangle", "quadrilateral", "tetrahedron", "hexahedron", "prism", "pyramid", "mixed2d", "mixed3d"]


def expected():
    for line in (FOLDER / "integrals.txt").read_text().splitlines():
        words = line.split(";")
        name, order, dim = words[0], int(words[1]), int(words[2])
        boundaries = dict(zip(words[5::2], map(float, words[6::2])))
        yield f"{name}-{order}", order, dim, float(words[3]), float(words[4]), boundaries



def family(kind):
    """Name of the shape of a type of elements, without asking Gmsh for the type's basis."""
    for name, numbers in {"line": (1, 8, 26, 27, 28, 62, 63, 64), "triangle": (2, 9, 21, 23, 25, 42, 43, 44),
                          "quadrilateral": (3, 10, 36, 37, 38, 47, 48, 49),
                          "tetrahedron": (4, 11, 29, 30, 31, 71, 72, 73),
                          "hexahedron": (5, 12, 92, 93, 94, 95, 96, 97),
                          "prism": (6, 13, 90, 91, 106, 107, 108, 109),
                          "pyramid": (7, 14, 118, 119, 120, 121, 122, 123)}.items():
        if kind in numbers:
            return name
    raise ValueError(kind)


def point_count(dim, order):
    """Of a rule, per direction: exact for the measure and for fields of small cells, near for large ones in space.

    Gmsh 4.8 needs a minute for each of the latter; nodes in a wrong order would change measures by tenths."""
    return 4 if dim == 3 and order > 4 else 2 * order + 2


def tolerance(dim, order):
    return 1e-4 if dim == 3 and order > 4 else 1e-9 if order > 5 else 1e-11


def rule(kind, n):
    """Points and weights on Gmsh's reference element. Gmsh 4.8's own rules for pyramids are wrong by a factor."""
    x, w = np.polynomial.legendre.leggauss(n)
    t, v = 0.5 * (1.0 + x), 0.5 * w  # on [0, 1]
    shape = family(kind)
    if shape == "line":
        a, b, c, weight = x, 0 * x, 0 * x, w
    elif shape == "quadrilateral":
        a, b = np.meshgrid(x, x, indexing="ij")
        c, weight = 0 * a, np.outer(w, w)
    elif shape == "triangle":
        a, b = np.meshgrid(t, t, indexing="ij")
        a, c, weight = a * (1 - b), 0 * a, np.outer(v, v) * (1 - b)
    elif shape == "tetrahedron":
        a, b, c = np.meshgrid(t, t, t, indexing="ij")
        weight = np.einsum("i,j,k->ijk", v, v, v) * (1 - b) * (1 - c) ** 2
        a, b = a * (1 - b) * (1 - c), b * (1 - c)
    elif shape == "hexahedron":
        a, b, c = np.meshgrid(x, x, x, indexing="ij")
        weight = np.einsum("i,j,k->ijk", w, w, w)
    elif shape == "prism":
        a, b, c = np.meshgrid(t, t, x, indexing="ij")
        weight = np.einsum("i,j,k->ijk", v, v, w) * (1 - b)
        a = a * (1 - b)
    else:
        a, b, c = np.meshgrid(x, x, t, indexing="ij")
        weight = np.einsum("i,j,k->ijk", w, w, v) * (1 - c) ** 2
        a, b = a * (1 - c), b * (1 - c)
    return np.stack([a.ravel(), b.ravel(), c.ravel()], 1).ravel(), weight.ravel()


def integrate(dim, tag, order, function=None):
    """Integral of a function given at the nodes over an entity, by Gmsh's Jacobians and basis functions."""
    total = 0.0
    types, _, nodes = gmsh.model.mesh.getElements(dim, tag)
    for kind, of in zip(types, nodes):
        points, weights = rule(kind, point_count(dim, order))
        _, determinants, _ = gmsh.model.mesh.getJacobians(kind, points, tag)
        determinants = np.array(determinants).reshape(-1, len(weights))
        values = 1.0
        if function is not None:
            _, basis, _ = gmsh.model.mesh.getBasisFunctions(kind, points, "Lagrange")
            basis = np.array(basis).reshape(len(weights), -1)
            values = function[np.array(of, dtype=int)].reshape(len(determinants), -1) @ basis.T
        total += float((determinants * values * weights).sum())
    return total


def open_file(path):
    gmsh.clear()
    gmsh.open(str(path))


class Files(unittest.TestCase):
    def test_measures_are_ours_in_every_shape_and_order(self):
        for stem, order, dim, measure, _, boundaries in expected():
            with self.subTest(stem):
                open_file(FOLDER / f"{stem}.msh")
                found = sum(integrate(dim, tag, order) for _, tag in gmsh.model.getEntities(dim))
                self.assertAlmostEqual(found / measure, 1.0, delta=tolerance(dim, order))
                for boundary_dim, tag in gmsh.model.getPhysicalGroups(dim - 1):
                    name = gmsh.model.getPhysicalName(boundary_dim, tag)
                    found = sum(integrate(dim - 1, int(e), order)
                                for e in gmsh.model.getEntitiesForPhysicalGroup(dim - 1, tag))
                    # Lengths and areas of curved sides are no polynomials: both rules are near, not exact.
                    self.assertAlmostEqual(found / boundaries.pop(name), 1.0, delta=1e-6)
                self.assertEqual(boundaries, {})

    def test_integrals_of_fields_are_ours(self):
        for stem, order, dim, _, integral, _ in expected():
            if dim == 3 and order > 5:
                continue
            with self.subTest(stem):
                open_file(FOLDER / f"{stem}.msh")
                view = next(v for v in gmsh.view.getTags()
                            if gmsh.option.getString(f"View[{gmsh.view.getIndex(v)}].Name") == "product")
                _, tags, values, _, _ = gmsh.view.getModelData(view, 0)
                by_tag = np.zeros(int(max(tags)) + 1)
                by_tag[np.array(tags, dtype=int)] = np.array(values).ravel()
                found = sum(integrate(dim, tag, order, by_tag) for _, tag in gmsh.model.getEntities(dim))
                self.assertAlmostEqual(found / integral, 1.0, delta=tolerance(dim, order))

    def test_regions_boundaries_and_blocks_are_groups_and_entities(self):
        for name in NAMES:
            open_file(FOLDER / f"{name}-2.msh")
            dim = 2 if name in ("triangle", "quadrilateral", "mixed2d") else 3
            regions = [gmsh.model.getPhysicalName(*group) for group in gmsh.model.getPhysicalGroups(dim)]
            self.assertEqual(regions, ["fluid", "solid"])
            blocks = gmsh.model.getEntities(dim)
            self.assertEqual(len(blocks), 2)
            for block in blocks:
                bounds = gmsh.model.getBoundary([block], oriented=False)
                self.assertGreater(len(bounds), 0)
                self.assertEqual({d for d, _ in bounds}, {dim - 1})
            # Every node stands once, on one entity.
            tags, _, _ = gmsh.model.mesh.getNodes()
            self.assertEqual(sorted(tags), list(range(1, len(tags) + 1)))

    def test_normals_of_boundaries_point_outwards(self):
        for name in NAMES:
            open_file(FOLDER / f"{name}-1.msh")
            dim = 2 if name in ("triangle", "quadrilateral", "mixed2d") else 3
            tags, x, _ = gmsh.model.mesh.getNodes()
            x = np.array(x).reshape(-1, 3)[np.argsort(tags)]
            flux, volume = 0.0, 0.0
            for _, tag in gmsh.model.getEntities(dim - 1):
                types, _, nodes = gmsh.model.mesh.getElements(dim - 1, tag)
                for kind, of in zip(types, nodes):
                    points, weights = rule(kind, 4)
                    jacobians, _, at = gmsh.model.mesh.getJacobians(kind, points, tag)
                    jacobians = np.array(jacobians).reshape(-1, len(weights), 3, 3)  # rows: tangents
                    at = np.array(at).reshape(-1, len(weights), 3)
                    t = jacobians[:, :, 0]
                    normal = np.cross(t, jacobians[:, :, 1]) if dim == 3 else np.cross(t, [0.0, 0.0, 1.0])
                    flux += float(((at * normal).sum(-1) * weights).sum()) / dim
            for _, tag in gmsh.model.getEntities(dim):
                volume += integrate(dim, tag, 1)
            self.assertAlmostEqual(flux, volume, delta=1e-12 * volume)

    def test_files_of_gmsh_are_read(self):
        for binary in (0, 1):
            for dim, order, recombine in [(2, 1, 0), (2, 3, 0), (2, 4, 1), (3, 1, 0), (3, 2, 0), (3, 3, 0)]:
                with self.subTest(binary=binary, dim=dim, order=order, recombine=recombine):
                    gmsh.clear()
                    if dim == 2:
                        gmsh.model.occ.addDisk(0, 0, 0, 1, 1)
                    else:
                        gmsh.model.occ.addSphere(0, 0, 0, 1)
                    gmsh.model.occ.synchronize()
                    gmsh.model.setPhysicalName(dim, gmsh.model.addPhysicalGroup(dim, [1]), "inside")
                    rim = [t for _, t in gmsh.model.getEntities(dim - 1)]
                    gmsh.model.setPhysicalName(dim - 1, gmsh.model.addPhysicalGroup(dim - 1, rim), "rim")
                    gmsh.option.setNumber("Mesh.CharacteristicLengthMin", 0.5)
                    gmsh.option.setNumber("Mesh.CharacteristicLengthMax", 0.5)
                    gmsh.option.setNumber("Mesh.RecombineAll", recombine)
                    gmsh.option.setNumber("Mesh.SecondOrderIncomplete", 0)
                    gmsh.option.setNumber("Mesh.Binary", binary)
                    gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
                    gmsh.model.mesh.generate(dim)
                    gmsh.model.mesh.setOrder(order)
                    measure = sum(integrate(dim, tag, order) for _, tag in gmsh.model.getEntities(dim))
                    rim_measure = sum(integrate(dim - 1, tag, order) for _, tag in gmsh.model.getEntities(dim - 1))
                    gmsh.write(str(FOLDER / "from-gmsh.msh"))
                    subprocess.run([CONVERT, FOLDER / "from-gmsh.msh", FOLDER / "back.msh"], check=True)
                    open_file(FOLDER / "back.msh")
                    self.assertAlmostEqual(
                        sum(integrate(dim, tag, order) for _, tag in gmsh.model.getEntities(dim)) / measure, 1.0,
                        delta=1e-11)
                    self.assertAlmostEqual(
                        sum(integrate(dim - 1, tag, order) for _, tag in gmsh.model.getEntities(dim - 1)) / rim_measure,
                        1.0, delta=1e-11)
                    self.assertEqual({gmsh.model.getPhysicalName(*g) for g in gmsh.model.getPhysicalGroups()},
                                     {"inside", "rim"})

    def test_vtu_and_msh_hold_the_same(self):
        for stem, order, dim, measure, _, _ in expected():
            if order != 3:
                continue
            with self.subTest(stem):
                subprocess.run([CONVERT, FOLDER / f"{stem}.vtu", FOLDER / "converted.msh"], check=True)
                open_file(FOLDER / "converted.msh")
                found = sum(integrate(dim, tag, order) for _, tag in gmsh.model.getEntities(dim))
                self.assertAlmostEqual(found / measure, 1.0, delta=tolerance(dim, order))


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        FOLDER = Path(folder)
        CONVERT = sys.argv.pop(2)
        subprocess.run([sys.argv.pop(1), folder], check=True)
        gmsh.initialize()
        gmsh.option.setNumber("General.Verbosity", 0)
        # Gmsh 4.8 complains about prisms above order 2, whose faces' closures it has not, yet evaluates them.
        gmsh.option.setNumber("General.AbortOnError", 0)
        unittest.main()
