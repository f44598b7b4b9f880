"""The commands that solve nothing: check, mesh and describe."""
import re
import shutil

import support
from support import USER_ERROR, RunTest, arguments

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
        rows = [line.split() for line in lines[start + 1:]]
        self.assertEqual(len(rows), 47)  # 30 points, 17 blocks, 1 hole: Euler
        # The case asks for first cells of 6e-4 m at the square.
        self.assertTrue(any(sorted(row[-3:]) == ["0.0006", "0.0336", "3.826"] for row in rows), rows)

    def test_a_file_that_cannot_be_written_is_a_mistake(self):
        (self.folder / "file").touch()
        self.assertIn("choose another folder",
                      self.call("mesh", self.case, "-o", "file/mesh.vtu", code=USER_ERROR).stderr)


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
