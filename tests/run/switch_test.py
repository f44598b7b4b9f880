"""A second layout of blocks that takes over the state of the first."""
from pathlib import Path

import support
from support import DONE, FAILED, MISSED, USER_ERROR, RunTest, checkpoints, read_table

# The flap of support.FLAP as a file, with three things to fill in.
CASE = (Path(__file__).parents[2] / "cases/wall-ramm-flap/case.toml").read_text()
DIVIDE = {"divide.x = [4, 3, 9, 14]": "divide.x = [2, 2, 4, 4]", "divide.y = [4, 4, 1, 4, 4]": "divide.y = [2, 2, 1, 2, 2]"}
FINER = {"divide.x = [4, 3, 9, 14]": "divide.x = [3, 2, 4, 6]", "divide.y = [4, 4, 1, 4, 4]": "divide.y = [3, 3, 1, 3, 3]"}
TIGHT = {"[solid]": "newton.tolerance = 1e-11\n\n[coupling]\ntolerance = 1e-10\n\n[solid]"}
SOFT = {"young = 2.5e5": "young = 1e3", "U = 0.513 ": "U = 30 "}


def text_of(*changes, end, more=""):
    text = CASE.replace("order = 3", "order = 2").replace("step = 2.5e-3", "step = 0.02")
    text = text.replace("end  = 10", f"end  = {end}").replace("every  = 0.05", "every = 0.04")
    for change in changes:
        for old, new in change.items():
            assert old in text, old
            text = text.replace(old, new)
    return text + "\n" + more


class Switch(RunTest):
    def write(self, first, second):
        (self.folder / "first.toml").write_text(first)
        (self.folder / "second.toml").write_text(second)

    def run_first(self, *options, code=DONE, out="out", processes=1):
        return self.call("run", self.folder / "first.toml", "--directory", self.folder / out, *options, code=code,
                         processes=processes)

    def test_the_same_blocks_take_over_without_a_difference(self):
        switch = '[switch]\nto = "second.toml"\nat = 0.08\n'
        self.write(text_of(DIVIDE, TIGHT, end=0.16, more=switch), text_of(DIVIDE, TIGHT, end=0.16))
        output = self.run_first().stdout
        self.assertIn("takes over at t = 0.08 s", output)
        first, second = self.folder / "out", self.folder / "out/second"
        self.assertEqual(read_table(first / "probes.csv")["step"], [1, 2, 3, 4])
        self.assertEqual(read_table(second / "probes.csv")["step"], [5, 6, 7, 8])
        self.assertAlmostEqual(read_table(second / "probes.csv")["time"][-1], 0.16)
        transfer = read_table(second / "transfer.csv")
        self.assertEqual(transfer["step"], [4])
        self.assertLess(transfer["velocity_error"][0], 1e-12)
        self.assertLess(transfer["pressure_error"][0], 1e-12)
        self.assertAlmostEqual(transfer["scaled_jacobian"][0], transfer["scaled_jacobian_before"][0], places=12)
        (self.folder / "first.toml").write_text(text_of(DIVIDE, TIGHT, end=0.16))
        self.run_first(out="whole")
        for name in ("probes.csv", "forces.csv"):
            whole = read_table(self.folder / "whole" / name)
            for column, values in read_table(second / name).items():
                scale = max(map(abs, whole[column]))
                for found, wanted in zip(values, whole[column][4:], strict=True):
                    self.assertAlmostEqual(found, wanted, delta=1e-8 * scale, msg=f"{name}: {column}")

    def test_finer_blocks_take_over_and_a_restart_continues_them_bit_for_bit(self):
        switch = '[switch]\nto = "second.toml"\nat = 0.4\n'
        self.write(text_of(DIVIDE, end=0.48, more=switch), text_of(FINER, end=0.48))
        self.run_first()
        transfer = read_table(self.folder / "out/second/transfer.csv")
        self.assertGreater(transfer["velocity_error"][0], 1e-12)
        self.assertLess(transfer["velocity_error"][0], 1e-2)
        (self.folder / "second.toml").write_text(text_of(FINER, end=0.44))
        self.run_first(out="cut")
        self.assertEqual(checkpoints(self.folder / "cut/second")[-1].name, "step-000022")
        (self.folder / "second.toml").write_text(text_of(FINER, end=0.48))
        self.run_first("--restart", out="cut")
        for name in ("probes.csv", "forces.csv", "quality.csv"):
            self.assertEqual((self.folder / "cut/second" / name).read_text(),
                             (self.folder / "out/second" / name).read_text())

    def test_the_forces_go_on_behind_a_switch_without_ringing(self):
        """Values taken over at the nodes make the lift ring with 1.3 of its size here, as they have a divergence."""
        def cells(x, y):
            divide = {"divide.x = [4, 3, 9, 14]": f"divide.x = {x}", "divide.y = [4, 4, 1, 4, 4]": f"divide.y = {y}"}
            return {"step = 0.02": "step = 0.01", "order = 2": "order = 3", **divide}

        switch = '[switch]\nto = "second.toml"\nat = 0.1\n'
        self.write(text_of(cells([4, 3, 4, 6], [3, 3, 1, 3, 3]), end=0.2, more=switch),
                   text_of(cells([5, 4, 4, 5], [3, 4, 1, 4, 3]), end=0.2))
        self.run_first()
        before, after = (read_table(self.folder / "out" / name / "forces.csv")["total_y"] for name in ("", "second"))
        lift, first = before + after, len(before)
        ringing = max(abs(lift[i + 1] - 2 * lift[i] + lift[i - 1]) for i in range(first, len(lift) - 1))
        self.assertLess(ringing, 0.3 * max(map(abs, lift)))
        transfer = {name: values[0] for name, values in read_table(self.folder / "out/second/transfer.csv").items()}
        self.assertAlmostEqual(transfer["area"] / transfer["area_before"], 1.0, places=12)
        self.assertAlmostEqual(transfer["momentum_x"] / transfer["momentum_x_before"], 1.0, delta=1e-3)
        through = transfer["momentum_x"] / 1.18 / 0.195  # channel length, density: flow through a section
        self.assertLess(abs(transfer["outflow"]), 1e-5 * through)
        self.assertLess(abs(transfer["outflow_before"]), 1e-5 * through)

    def test_a_second_layout_goes_on_where_the_mesh_of_the_first_ends(self):
        switch = '[motion]\nregenerate = { corners = "fixed" }\n'
        alone = text_of(DIVIDE, SOFT, end=0.16, more=switch)
        self.write(alone, text_of(DIVIDE, SOFT, end=0.16))
        error = self.run_first(code=FAILED, out="alone").stderr
        self.assertTrue("folds over" in error or "not proved valid" in error, error)
        (self.folder / "first.toml").write_text(alone + '\n[switch]\nto = "second.toml"\n')
        output = self.run_first().stdout
        self.assertIn("another layout takes over", output)
        steps = read_table(self.folder / "out/probes.csv")["step"]
        more = read_table(self.folder / "out/second/probes.csv")["step"]
        self.assertEqual(steps + more, [*range(1, 9)])
        self.assertGreater(len(more), 0)
        self.assertEqual(set(read_table(self.folder / "out/second/quality.csv")["certified"]), {1})

    def test_a_layout_whose_mesh_is_not_valid_does_not_take_over(self):
        corners = '[motion]\nregenerate = { corners = "fixed" }\n'
        self.write(text_of(DIVIDE, SOFT, end=0.18, more='[switch]\nto = "second.toml"\nat = 0.16\n'),
                   text_of(DIVIDE, SOFT, end=0.18, more=corners))
        error = self.run_first(code=FAILED).stderr
        self.assertIn("second.toml' cannot take over at t = 0.16 s: its mesh is not valid there either", error)
        self.assertEqual(checkpoints(self.folder / "out")[-1].name, "step-000008")
        self.assertFalse((self.folder / "out/second").exists())

    def test_a_higher_order_of_the_fluid_takes_over_exactly_what_the_lower_one_had(self):
        """Without the gust, which meets the slip walls in a jump: there each mesh has its own values."""
        calm = {'"if(t < 1, 0.2 * U * sin(2 * pi * t)^3, 0)"': "0"}
        heavy = {"density = 100\n": "density = 100\nbody_force = [0, -5]\n"}
        body = {'region  = "flap"': 'region  = "flap"\norder = 2'}
        self.write(text_of(DIVIDE, calm, heavy, end=0.16, more='[switch]\nto = "second.toml"\nat = 0.12\n'),
                   text_of(DIVIDE, calm, heavy, {"order = 2": "order = 3"}, body, end=0.16))
        self.run_first()
        transfer = {name: values[0] for name, values in read_table(self.folder / "out/second/transfer.csv").items()}
        self.assertLess(transfer["pressure_error"], 1e-12)
        self.assertLess(transfer["velocity_error"], 1e-11)

    def test_a_run_goes_through_several_layouts_and_is_continued_and_verified_as_one(self):
        switches = '[[switch]]\nto = "second.toml"\nat = 0.08\n\n[[switch]]\nto = "third.toml"\nat = 0.14\n'
        self.write(text_of(DIVIDE, end=0.2, more=switches), text_of(FINER, end=0.2))
        (self.folder / "third.toml").write_text(text_of(DIVIDE, end=0.2))
        self.run_first()
        folders = [self.folder / "out" / name for name in ("", "second", "third")]
        steps = [read_table(folder / "probes.csv")["step"] for folder in folders]
        self.assertEqual(steps, [[1, 2, 3, 4], [5, 6, 7], [8, 9, 10]])
        self.assertEqual([read_table(folder / "transfer.csv")["step"] for folder in folders[1:]], [[4], [7]])

        last = read_table(folders[2] / "probes.csv")["tip_uy"][-1]
        largest = max(max(read_table(folder / "quality.csv")["coupling_iterations"]) for folder in folders)
        first_drag = read_table(folders[0] / "forces.csv")["total_x"][0]
        (self.folder / "reference.csv").write_text(
            "quantity,statistic,clock,factor,value,tolerance,kind,level,source\n"
            f"tip_uy,last,,,{last},1e-12,relative,full,\n"
            f"total_x,least,,,{first_drag},1e-12,relative,full,\n"
            f"coupling_iterations,greatest,,,{largest + 1},,at most,full,\n")
        self.assertIn("3 of 3 within tolerance", self.call(
            "verify", "--finished", self.folder / "first.toml", "--directory", self.folder / "out").stdout)

        # Interrupted in the third layout, in the second one, and when the third is due but has not begun.
        for end, name, step in ((0.18, "third", 9), (0.12, "second", 6), (0.14, "second", 7)):
            cut = self.folder / f"cut-{step}"
            cut_cases = {other: (self.folder / other).read_text() for other in ("second.toml", "third.toml")}
            for other, text in cut_cases.items():
                (self.folder / other).write_text(text.replace("end  = 0.2", f"end  = {end}"))
            self.run_first(out=cut.name)
            self.assertEqual(checkpoints(cut / name)[-1].name, f"step-{step:06}")
            for other, text in cut_cases.items():
                (self.folder / other).write_text(text)
            self.run_first("--restart", out=cut.name)
            for folder in folders:
                for table in ("probes.csv", "forces.csv", "quality.csv"):
                    path = folder.relative_to(self.folder / "out") / table
                    self.assertEqual((cut / path).read_text(), (self.folder / "out" / path).read_text(), path)

        # A run that ends before the switch leaves nothing of the one before to be read.
        (self.folder / "first.toml").write_text(text_of(DIVIDE, end=0.06, more=switches))
        self.run_first()
        self.assertIn("2 of 3 within tolerance", self.call(
            "verify", "--finished", self.folder / "first.toml", "--directory", self.folder / "out", code=MISSED).stdout)

    def test_several_processes_switch_as_one_does(self):
        switch = '[switch]\nto = "second.toml"\nat = 0.08\n'
        self.write(text_of(DIVIDE, TIGHT, end=0.16, more=switch), text_of(FINER, TIGHT, end=0.16))
        self.run_first()
        self.run_first(out="both", processes=2)
        for name in ("probes.csv", "forces.csv", "transfer.csv"):
            columns = read_table(self.folder / "both/second" / name)
            for column, wanted in read_table(self.folder / "out/second" / name).items():
                if column.startswith("outflow"):  # round-off of what flows through
                    continue
                for value, right in zip(columns[column], wanted, strict=True):
                    self.assertLessEqual(abs(value - right), 1e-7 * max(map(abs, wanted)), f"{name}: {column}")
        self.assertIn("2 processes", self.run_first("--restart", out="both", code=USER_ERROR).stderr)

    def test_what_cannot_take_over_is_refused_before_anything_is_solved(self):
        switch = '[switch]\nto = "second.toml"\nbelow = 0.2\n'
        longer = {"divide.x = [4, 3, 9, 14]": "divide.x = [2, 2, 5, 4]", **dict([list(DIVIDE.items())[1]])}
        self.write(text_of(DIVIDE, end=0.16, more=switch), text_of(longer, end=0.16))
        self.assertIn("the body must have the same blocks, divisions and order", self.run_first(code=USER_ERROR).stderr)
        (self.folder / "second.toml").write_text(text_of(DIVIDE, end=0.16, more=switch))
        self.assertIn("has a section [switch], too; name all layouts here", self.run_first(code=USER_ERROR).stderr)
        (self.folder / "first.toml").write_text(text_of(DIVIDE, end=0.16, more='[switch]\nto = "third.toml"\n'))
        self.assertIn("there is no case file", self.run_first(code=USER_ERROR).stderr)
        # A wall behind the flap: the fluid no longer meets its tip.
        wall = {
            '"fluid  .    flap  fluid"': '"fluid  .    flap  .    "',
            'square = "hole 1 in channel"': 'square = "hole 1 in channel"\n'
                                            'gap = "x >= 0.095 and (y = 0.0597 or y = 0.0603)"\n'
                                            'tip = "x = 0.095 and y >= 0.0597 and y <= 0.0603"',
            "square = { wall": "gap = { wall = true }\nsquare = { wall",
            "square  = { fixed": "tip = { free = true }\nsquare  = { fixed",
        }
        self.write(text_of(DIVIDE, end=0.16, more=switch), text_of(DIVIDE, wall, end=0.16))
        error = self.run_first(code=USER_ERROR).stderr
        self.assertIn("it meets 19 nodes of it in the first one and 18 in the second", error)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    support.main()
