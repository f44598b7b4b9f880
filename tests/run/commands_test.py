"""The commands that solve nothing: check, mesh and describe."""
import base64
import math
import re
import shutil
import struct
import subprocess
import time
import zlib
from pathlib import Path

import support
from support import USER_ERROR, RunTest, arguments

# A cube with a pyramid on top, a prism beside it and a tetrahedron below that.
HOUSE = """
[blocks]
dim = 3
order = 2
divide = 2

[blocks.points]
a = [0, 0, 0]
b = [1, 0, 0]
c = [1, 1, 0]
d = [0, 1, 0]
e = [0, 0, 1]
f = [1, 0, 1]
g = [1, 1, 1]
h = [0, 1, 1]
top = [0.5, 0.5, 2]
side = [2, 0.5, 0]
upper = [2, 0.5, 1]
below = [1.3, 0.5, -1]

[blocks.hexes]
cube = { corners = ["a", "b", "c", "d", "e", "f", "g", "h"], region = "house" }

[blocks.pyramids]
roof = { corners = ["e", "f", "g", "h", "top"], region = "roof" }

[blocks.prisms]
wing = { corners = ["b", "side", "c", "f", "upper", "g"], region = "house" }

[blocks.tets]
cellar = { corners = ["b", "c", "side", "below"], region = "house" }

[boundaries]
ground = "z < 1e-9"
outside = "x = 0 or y = 0 or y = 1 or z >= 1 or 2 * y = x - 1 or 2 * y = 3 - x"
"""

# A quarter of a circle as one triangle.
SLICE = """
[blocks]
order = 2
divide = 2

[blocks.points]
centre = [0, 0]
east = [1, 0]
north = [0, 1]

[blocks.triangles]
slice = { corners = ["centre", "east", "north"], region = "cake" }

[blocks.edges]
"east - north" = { circle = { center = [0, 0] } }

[boundaries]
rim = "x + y > 0.9"
cuts = "x = 0 or y = 0"
"""


def points(path):
    """Coordinates of the points of a small .vtu file."""
    data = re.search(r'Name="Points"[^>]*>\s*(\S+)', path.read_text()).group(1)
    blocks, size, rest, packed = struct.unpack("<4Q", base64.b64decode(data[:44]))
    assert blocks == 1, path
    values = zlib.decompress(base64.b64decode(data[44:]))
    return list(struct.iter_unpack("<3d", values))


class Check(RunTest):
    def test_no_mistake_is_found_in_the_cases_and_nothing_is_written(self):
        for case in sorted(support.CASES.glob("*/case.toml")):
            with self.subTest(case.parent.name):
                shutil.copy(case, self.folder)
                self.assertEqual(self.call("check", "case.toml").stdout, "case.toml: no mistakes found\n")
                self.assertEqual([path.name for path in self.folder.iterdir()], ["case.toml"])

    def test_mistakes_are_told_with_their_place_and_nothing_is_written(self):
        case = support.CASES / "wall-ramm-flap/case.toml"
        text = case.read_text().replace("density   = 1.18", "density   = -1.18")
        (self.folder / "case.toml").write_text(text)
        line = text[:text.index("-1.18")].count("\n") + 1
        result = self.call("check", "case.toml", code=USER_ERROR)
        self.assertTrue(any(told.startswith(f"case.toml:{line}:13:") for told in result.stderr.splitlines()), result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["case.toml"])


class Mesh(RunTest):
    def setUp(self):
        super().setUp()
        self.case = support.CASES / "wall-ramm-flap/case.toml"

    def test_counts_quality_and_proof_are_told(self):
        output = self.call("mesh", self.case).stdout
        cells = re.search(r"17 blocks, (\d+) cells of order 3", output).group(1)
        self.assertRegex(output, r"scaled Jacobian at least 0\.99\d")
        self.assertIn(f"proved valid: {cells} of {cells} cells", output)
        self.assertEqual([*self.folder.iterdir()], [])

    def test_the_file_that_is_asked_for_holds_all_cells(self):
        output = self.call("mesh", self.case, "-o", "new/mesh.vtu", *arguments(["blocks.order=3"])).stdout
        text = (self.folder / "new/mesh.vtu").read_text()
        self.assertEqual(re.search(r'NumberOfCells="(\d+)"', text).group(1),
                         re.search(r"(\d+) cells", output).group(1))
        self.assertIn('Name="proved_valid"', text)
        self.assertEqual([path.name for path in self.folder.rglob("*") if path.is_file()], ["mesh.vtu"])

    def test_sizes_lists_the_cells_of_every_edge(self):
        lines = self.call("mesh", self.case, "--sizes").stdout.splitlines()
        start = next(i for i, line in enumerate(lines) if line.startswith("edge "))
        self.assertEqual(lines[start].split(), ["edge", "cells", "first", "[m]", "last", "[m]", "largest", "ratio"])
        end = next(i for i, line in enumerate(lines) if line.startswith("part "))
        rows = [line.split() for line in lines[start + 1:end]]
        self.assertEqual(len(rows), 47)  # 30 points, 17 blocks, 1 hole: Euler
        # The case asks for first cells of 6e-4 m at the square.
        self.assertTrue(any(sorted(row[-3:]) == ["0.0006", "0.0336", "3.826"] for row in rows), rows)

    def test_the_time_of_each_part_is_told(self):
        for words, optional in (([], []), (["-o", "m.vtu", "--picture", "m.svg", "--convert", "triangles", "--order", "2"],
                                           ["edges, faces", "picture", "convert", "write"])):
            before = time.monotonic()
            output = self.call("mesh", self.case, *words).stdout
            taken = time.monotonic() - before
            nodes = int(re.search(r"(\d+) nodes", output).group(1))
            lines = output[output.index("part "):].splitlines()
            self.assertEqual(re.split("  +", lines[0]), ["part", "seconds", "share", "nodes per s"])
            rows = {name: (float(seconds), float(share.rstrip("%")), rate)
                    for name, seconds, share, rate in (re.split("  +", line) for line in lines[1:])}
            always = ["read, check", "connect", "place", "quality", "certify", "total"]
            self.assertEqual([name for name in rows if name not in optional], always)
            self.assertEqual([name for name in rows if name in optional], optional)
            total, whole, rate = rows.pop("total")
            self.assertLess(total, taken)
            self.assertEqual(whole, 100.0)
            self.assertAlmostEqual(sum(seconds for seconds, _, _ in rows.values()), total, delta=0.01)
            self.assertAlmostEqual(sum(share for _, share, _ in rows.values()), 100.0, delta=0.1)
            # Seconds are rounded to milliseconds, rates to three digits.
            self.assertAlmostEqual(float(rate) * total, nodes, delta=0.0006 * float(rate) + 0.006 * nodes)

    def test_a_file_that_cannot_be_written_is_a_mistake(self):
        (self.folder / "file").touch()
        self.assertIn("choose another folder",
                      self.call("mesh", self.case, "-o", "file/mesh.vtu", code=USER_ERROR).stderr)


class Convert(RunTest):
    def setUp(self):
        super().setUp()
        (self.folder / "house.toml").write_text(HOUSE)
        (self.folder / "slice.toml").write_text(SLICE)

    def cells(self, *words):
        """Cells by shape, all proved valid."""
        output = self.call("mesh", *words).stdout
        total, listed = re.search(r"(\d+) cells of order \d \(([^)]*)\)", output).groups()
        self.assertIn(f"proved valid: {total} of {total} cells", output)
        return {name: int(count) for count, name in (entry.split() for entry in listed.split(", "))}

    def test_blocks_of_all_shapes_make_one_mesh(self):
        self.assertEqual(self.cells("house.toml"), {"hexahedra": 8, "tetrahedra": 8 + 4, "prisms": 8, "pyramids": 6})

    def test_cells_in_space_are_cut_into_tetrahedra_and_those_into_hexahedra(self):
        for order in (1, 3):
            tetrahedra = self.cells("house.toml", "--convert", "tetrahedra", "--order", order)["tetrahedra"]
            self.assertGreaterEqual(tetrahedra, 8 * 5 + 12 + 8 * 3 + 6 * 2)
            self.assertLessEqual(tetrahedra, 8 * 6 + 12 + 8 * 3 + 6 * 2)
            self.assertEqual(self.cells("house.toml", "--convert", "tetrahedra,hexahedra", "--order", order),
                             {"hexahedra": 4 * tetrahedra})

    def test_cells_in_the_plane_are_cut_into_triangles_and_quadrilaterals(self):
        case = support.CASES / "wall-ramm-flap/case.toml"
        coarse = ["--set", "blocks.order=1"]
        quadrilaterals = self.cells(case, *coarse)["quadrilaterals"]
        for name, expected in (("triangles", {"triangles": 2 * quadrilaterals}),
                               ("triangles4", {"triangles": 4 * quadrilaterals}),
                               ("quadrilaterals", {"quadrilaterals": quadrilaterals}),
                               ("triangles,quadrilaterals", {"quadrilaterals": 6 * quadrilaterals})):
            self.assertEqual(self.cells(case, *coarse, "--convert", name), expected)

    def test_order_makes_cells_of_that_order_on_the_geometry(self):
        for order in (1, 2, 5):
            output = self.call("mesh", "slice.toml", "--order", order, "-o", "slice.vtu").stdout
            self.assertIn(f"4 cells of order {order} (4 triangles)", output)
            rim = [math.hypot(x, y) for x, y, _ in points(self.folder / "slice.vtu") if math.hypot(x, y) > 0.9]
            self.assertGreaterEqual(len(rim), 2 * order + 1)
            # Equispaced points of a polynomial arc of 45 degrees.
            off = max(abs(r - 1.0) for r in rim if r > 0.999)
            self.assertLess(off, {1: 1e-14, 2: 1e-14, 5: 1e-6}[order])

    def test_nodes_of_cut_edges_lie_on_the_geometry(self):
        self.assertEqual(self.cells("slice.toml", "--convert", "quadrilaterals", "-o", "slice.vtu"),
                         {"quadrilaterals": 12})
        rim = [math.hypot(x, y) for x, y, _ in points(self.folder / "slice.vtu") if math.hypot(x, y) > 0.995]
        self.assertEqual(len(rim), 9)  # 4 edges of order 2
        # Nodes of a polynomial of order 2 would be off by 5e-4.
        self.assertLess(max(abs(r - 1.0) for r in rim), 1e-6)

    def test_gmsh_files_name_regions_and_boundaries(self):
        self.assertIn("written: house.msh", self.call("mesh", "house.toml", "-o", "house.msh").stdout)
        content = (self.folder / "house.msh").read_bytes()
        self.assertTrue(content.startswith(b"$MeshFormat\n4.1 1 8\n"), content[:40])
        for name in (b'3 1 "house"', b'3 2 "roof"', b'"ground"', b'"outside"'):
            self.assertIn(name, content)

    def test_what_cannot_be_is_told_before_anything_is_made(self):
        flap = support.CASES / "wall-ramm-flap/case.toml"
        for words, told in (
            (["house.toml", "--convert", "triangles4"], "--convert triangles4: the mesh is in space, where it can be "
             "converted to tetrahedra or hexahedra"),
            ([flap, "--convert", "tetrahedra"], "--convert tetrahedra: the mesh is plane, where it can be converted "
             "to triangles, triangles4 or quadrilaterals"),
            (["house.toml", "--convert", "hexahedra"], "--convert tetrahedra,hexahedra"),
            (["house.toml", "--convert", "cubes"], "cubes not in {triangles,triangles4,quadrilaterals,tetrahedra,"
             "hexahedra}"),
            (["house.toml", "--order", "9"], "9 not in range"),
            (["house.toml", "-o", "house.stl"], "'house.stl' must end in .vtu (VTK, ParaView) or .msh (Gmsh)"),
        ):
            with self.subTest(words):
                result = self.call("mesh", *words, code=USER_ERROR)
                self.assertIn(told, result.stderr)
                self.assertEqual(result.stdout, "")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["house.toml", "slice.toml"])


class MeshProgram(RunTest):
    """blockfsi-mesh, beside blockfsi."""

    def setUp(self):
        super().setUp()
        self.program = Path(support.PROGRAM).with_name("blockfsi-mesh")
        (self.folder / "house.toml").write_text(HOUSE)

    def make(self, *words):
        return subprocess.run([self.program, *words], cwd=self.folder, capture_output=True, text=True, timeout=60)

    def test_it_makes_the_same_files_and_tells_the_same(self):
        told = self.call("mesh", "house.toml", "-o", "a.vtu", "--order", "3", "--picture", "b.vtu").stdout
        files = {name: (self.folder / name).read_bytes() for name in ("a.vtu", "b.vtu")}
        result = self.make("house.toml", "-o", "a.vtu", "--order", "3", "--picture", "b.vtu")
        self.assertEqual(result.returncode, support.DONE, result.stderr)
        without_times = [re.sub(r"( +[\d.e+%-]+){3}$", "", text, flags=re.MULTILINE) for text in (told, result.stdout)]
        self.assertEqual(*without_times)
        for name, content in files.items():
            self.assertTrue((self.folder / name).read_bytes() == content, name)

    def test_mistakes_have_the_same_code(self):
        for words in (["missing.toml"], ["house.toml", "--convert", "triangles"], []):
            result = self.make(*words)
            self.assertEqual(result.returncode, USER_ERROR, result.stderr)
            self.assertEqual(result.stdout, "")
        self.assertEqual(self.make("--help").returncode, support.DONE)

    def test_it_knows_neither_petsc_nor_mpi(self):
        libraries = subprocess.run(["ldd", self.program], capture_output=True, text=True, check=True).stdout
        self.assertIn("libc.so", libraries)
        self.assertIsNone(re.search("petsc|libmpi", libraries), libraries)


class Picture(RunTest):
    def test_blocks_in_the_plane_are_drawn_with_names_and_numbers_of_cells(self):
        case = support.CASES / "turek-hron-fsi1/case.toml"
        output = self.call("mesh", case, "--picture", "blocks.svg", "--sizes").stdout
        self.assertIn("written: blocks.svg", output)
        text = (self.folder / "blocks.svg").read_text()
        edges = output[output.index("edge "):].splitlines()[1:]
        told = re.findall(r"<title>([^<]* - [^<]*): (\d+) cells?", text)
        rows = [re.match(r"(.*?) {2,}(\d+) ", row).groups() for row in edges if re.match(r".* - ", row)]
        self.assertGreater(len(rows), 20)
        self.assertEqual(sorted(told), sorted(rows))
        for name in ("fluid", "flag", "walls", "inlet", "outlet", "cylinder"):
            self.assertTrue(f">{name}</text>" in text, name)

    def test_edges_of_blocks_in_space_are_written_as_curves(self):
        (self.folder / "house.toml").write_text(HOUSE)
        self.call("mesh", "house.toml", "--picture", "edges.vtu")
        text = (self.folder / "edges.vtu").read_text()
        for told in ('NumberOfCells="24"', 'Name="divisions"', 'Name="boundary"', 'Name="blocks"'):
            self.assertTrue(told in text, told)

    def test_the_name_of_a_picture_must_fit_the_dimension(self):
        (self.folder / "house.toml").write_text(HOUSE)
        told = self.call("mesh", "house.toml", "--picture", "edges.svg", code=USER_ERROR).stderr
        self.assertIn("the picture 'edges.svg' of blocks in space must end in .vtu", told)


class CadList(RunTest):
    def setUp(self):
        super().setUp()
        self.part = support.CASES.parent / "tests/unit/case/part.step"

    def test_edges_of_a_cad_file_are_listed_without_a_case(self):
        result = self.run_list("--list", self.part)
        if "built without CAD" in result.stderr:
            self.assertEqual(result.returncode, USER_ERROR)
            return
        self.assertEqual(result.returncode, support.DONE, result.stderr)
        heading, *rows = [re.split("  +", line.strip()) for line in result.stdout.splitlines()]
        self.assertEqual(heading[0], "edge")
        # A quarter of a circle from (1, 0) to (0, -0.2) [m].
        self.assertEqual([row[:2] for row in rows], [["1", "circle"]])

    def test_it_is_either_a_case_or_a_list(self):
        for words, told in (([], "a case is needed, or --list and a CAD file"),
                            (["case.toml", "--list", self.part], "case excludes --list"),
                            (["--list", "missing.step"], "cannot read missing.step: there is no such file"),
                            (["--list", support.CASES / "aorta/case.toml"], "must end in .step, .stp, .iges or .igs")):
            with self.subTest(words):
                result = self.run_list(*words)
                self.assertEqual(result.returncode, USER_ERROR)
                self.assertIn(told, result.stderr)
                self.assertEqual(result.stdout, "")

    def run_list(self, *words):
        return subprocess.run([support.PROGRAM, "mesh", *words], cwd=self.folder, capture_output=True, text=True,
                              timeout=60)


class Describe(RunTest):
    def test_every_key_of_the_cases_is_explained(self):
        described = self.call("describe").stdout
        for key in ("[blocks]", "[fluid]", "[solid]", "[time]", "[motion]", "[coupling]", "[output]", "viscosity",
                    "follows", "checkpoint_every", "iqn_ils"):
            self.assertIn(key, described)
        self.assertEqual([*self.folder.iterdir()], [])

    def test_help_is_no_mistake(self):
        for words in (["--help"], ["run", "--help"]):
            self.assertIn("Usage:", self.call(*words).stdout)


if __name__ == "__main__":
    support.main()
