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



def integrate(dim, tag, order, function=None):
    """Integral of a function of node tags' values over an entity, by the elements' own Jacobians."""
    total = 0.0
    types, _, nodes = gmsh.model.mesh.getElements(dim, tag)
    for kind, of in zip(types, nodes):
        points, weights = gmsh.model.mesh.getIntegrationPoints(kind, f"Gauss{4 * order + 4}")
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
                self.assertAlmostEqual(found / measure, 1.0, delta=1e-11)
                for boundary_dim, tag in gmsh.model.getPhysicalGroups(dim - 1):
                    name = gmsh.model.getPhysicalName(boundary_dim, tag)
                    found = sum(integrate(dim - 1, int(e), order)
                                for e in gmsh.model.getEntitiesForPhysicalGroup(dim - 1, tag))
                    # Lengths and areas of curved sides are no polynomials: both rules are near, not exact.
                    self.assertAlmostEqual(found / boundaries.pop(name), 1.0, delta=1e-6)
                self.assertEqual(boundaries, {})

    def test_integrals_of_fields_are_ours(self):
        for stem, order, dim, _, integral, _ in expected():
            with self.subTest(stem):
                open_file(FOLDER / f"{stem}.msh")
                view = next(v for v in gmsh.view.getTags()
                            if gmsh.option.getString(f"View[{gmsh.view.getIndex(v)}].Name") == "product")
                _, tags, values, _, _ = gmsh.view.getModelData(view, 0)
                by_tag = np.zeros(max(tags) + 1)
                by_tag[np.array(tags, dtype=int)] = np.array(values).ravel()
                found = sum(integrate(dim, tag, order, by_tag) for _, tag in gmsh.model.getEntities(dim))
                self.assertAlmostEqual(found / integral, 1.0, delta=1e-11)

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
                    points, weights = gmsh.model.mesh.getIntegrationPoints(kind, "Gauss8")
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
            if order not in (3, 6):
                continue
            with self.subTest(stem):
                subprocess.run([CONVERT, FOLDER / f"{stem}.vtu", FOLDER / "converted.msh"], check=True)
                open_file(FOLDER / "converted.msh")
                found = sum(integrate(dim, tag, order) for _, tag in gmsh.model.getEntities(dim))
                self.assertAlmostEqual(found / measure, 1.0, delta=1e-11)


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
