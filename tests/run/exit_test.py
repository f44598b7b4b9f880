"""How a run ends: the exit code, what it says, and what it leaves behind."""
import math
import re
import resource
import shutil
import signal
import subprocess
import xml.etree.ElementTree as xml

import support
from support import (DONE, ENVIRONMENT, FAILED, FLAP, MISSED, USER_ERROR, RunTest, arguments, checkpoints,
                     read_table)

TINY = (*FLAP, "time.end=0.06", "output.every=0.02")


class Done(RunTest):
    def test_a_run_that_reaches_its_end_exits_with_0_and_says_what_it_did(self):
        folder = self.folder / "results"
        output = self.call("run", support.CASES / "wall-ramm-flap/case.toml", "--directory", folder,
                           *arguments(TINY)).stdout
        for part in ("place", "mesh quality", "assembly", "factorisation", "solve", "transfer", "output", "rest",
                     "total"):
            self.assertRegex(output, rf"(?m)^{part} +\d+\.\d+ +\d+\.\d\d%")
        self.assertIn(f"results are in {folder}", output)
        self.assertIn("step 3/3", output)
        self.assertEqual((folder / "fields.pvd").read_text().count("<DataSet"), 2 * 4)
        self.assertEqual(read_table(folder / "quality.csv")["certified"], [1, 1, 1])

    def test_a_steady_solution_is_written_whatever_the_interval_of_fields(self):
        for every in ("0", "0.1"):
            folder = self.folder / every
            self.call("run", support.CASES / "schaefer-turek-2d1/case.toml", "--directory", folder,
                      *arguments(("blocks.order=1", f"output.every={every}")))
            self.assertEqual([path.name for path in (folder / "fields").iterdir()], ["fluid-000001.vtu"])

    def test_a_probe_that_the_flap_moves_over_has_no_value_meanwhile(self):
        probes = ('output.probes={tip={at=[0.095, 0.06], of="displacement"}, '
                  'below={at=[0.0945, 0.05965], of="pressure"}}')
        self.call("run", support.CASES / "wall-ramm-flap/case.toml", "--directory", self.folder / "results",
                  *arguments((*FLAP, "let.U=2", "time.end=0.5", probes)))
        table = read_table(self.folder / "results/probes.csv")
        self.assertTrue(any(map(math.isnan, table["below_p"])))
        # The flap reaches from 0.0597 to 0.0603 at rest.
        for pressure, moved in zip(table["below_p"], table["tip_uy"], strict=True):
            if moved > 1e-5 or moved < -8e-4:
                self.assertTrue(math.isfinite(pressure))
            elif -5e-4 < moved < -1e-4:
                self.assertTrue(math.isnan(pressure))

    def test_results_lie_beside_the_case_unless_told_otherwise(self):
        shutil.copy(support.CASES / "wall-ramm-flap/case.toml", self.folder)
        self.call("run", self.folder / "case.toml", *arguments(TINY))
        self.call("run", self.folder / "case.toml", *arguments((*TINY, 'output.directory="elsewhere"')))
        for name in ("results", "elsewhere"):
            self.assertTrue((self.folder / name / "probes.csv").exists())


class UserError(RunTest):
    def words(self, *settings):
        return ["run", support.CASES / "wall-ramm-flap/case.toml", "--directory", self.folder / "results",
                *arguments(settings)]

    def assert_refused(self, words, *told):
        error = self.call(*words, code=USER_ERROR).stderr
        for text in told:
            self.assertIn(text, error)
        self.assertFalse((self.folder / "results").exists())

    def test_a_missing_case_file(self):
        for command in ("run", "check", "mesh", "verify"):
            self.assert_refused([command, "nothing.toml"], "nothing.toml: cannot be read")

    def test_a_malformed_case_file(self):
        (self.folder / "case.toml").write_text("[fluid]\ndensity = \n")
        self.assert_refused(["run", "case.toml"], "case.toml:2:")

    def test_a_setting_that_does_not_exist(self):
        self.assert_refused(self.words("time.stpe=1"), "--set", "did you mean 'step'?")

    def test_an_unknown_option_or_command(self):
        self.assert_refused([*self.words(), "--restrat"], "--restrat")
        self.assert_refused(["simulate"], "")
        self.assert_refused([], "subcommand")
        self.assert_refused(["verify", "case.toml", "--level", "long"], "--level")

    def test_a_folder_of_results_that_cannot_be_made(self):
        (self.folder / "file").touch()
        words = ["run", support.CASES / "wall-ramm-flap/case.toml", *arguments(TINY), "--directory"]
        for place in (self.folder / "file", self.folder / "file/results", "/dev/null/results"):
            self.assert_refused([*words, place], f"'{place}'", "choose another folder")

    def test_a_disk_that_is_full(self):
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))

        result = subprocess.run(self.command(*self.words(*TINY)), preexec_fn=limit, env=ENVIRONMENT,
                                capture_output=True, text=True, timeout=60)
        self.assertEqual(result.returncode, USER_ERROR, result.stderr)
        self.assertIn("cannot write", result.stderr)


class Failure(RunTest):
    def words(self, *settings):
        return ["run", support.CASES / "wall-ramm-flap/case.toml", "--directory", self.folder / "results",
                *arguments((*FLAP, "time.end=0.16", "output.every=0.04", *settings))]

    def assert_fails(self, *settings, told, step=None):
        """A failure (in that step) is told; everything up to the step before is there."""
        error = self.call(*self.words(*settings), code=FAILED).stderr
        step = step or int(re.search(r"in step (\d+)", error).group(1))
        folder, begin = self.folder / "results", 0.02 * (step - 1)
        for text in (*told, f"in step {step} (t = {begin:g} s to {begin + 0.02:g} s)",
                     f"the last good state (t = {begin:g} s) is in the results"):
            self.assertIn(text, error)
        self.assertEqual(read_table(folder / "probes.csv")["step"], [*range(1, step)])
        self.assertEqual(checkpoints(folder)[-1].name, f"step-{step - 1:06}")
        self.assertIn(f'timestep="{begin:g}', (folder / "fields.pvd").read_text().splitlines()[-3])
        self.assertTrue((folder / f"fields/fluid-{step - 1:06}.vtu").read_text().endswith("</VTKFile>\n"))

    def test_too_few_iterations_of_newton(self):
        self.assert_fails("fluid.newton.iterations=1", step=1, told=["Newton's method for the flow"])

    def test_too_few_iterations_of_the_coupling(self):
        self.assert_fails("coupling.iterations=2", step=1, told=["coupling of fluid and solid did not converge"])

    def test_a_mesh_that_folds(self):
        # A flap like cloth in a storm, and corners that stay where they are.
        self.assert_fails("let.U=30", "solid.model.saint_venant_kirchhoff={young=1e3, poisson=0.35}",
                          'motion.regenerate={corners="fixed"}',
                          told=["the fluid mesh folds", "of channel", "also with the step cut into 8",
                                "refused.svg shows the blocks"])
        picture = xml.parse(self.folder / "results/refused.svg").getroot()
        texts = [element.text for element in picture.iter() if element.tag.endswith("text")]
        self.assertTrue(any("of channel is not valid" in text for text in texts), texts)

    def test_a_failed_run_goes_on_when_its_cause_is_gone_as_if_nothing_had_been(self):
        # A sudden blow in the first or the second half of a step of the start-up, and later.
        reference, folder = self.folder / "reference", self.folder / "results"
        self.call(*self.words("output.every=0"))
        folder.rename(reference)
        for begin, step in ((0.005, 1), (0.015, 1), (0.035, 2), (0.09, 5)):
            with self.subTest(begin=begin):
                blow = f'fluid.inlet.velocity=["U * ramp(t, 1)", "if(t < {begin}, 0.2 * U * sin(2 * pi * t)^3, 1e9)"]'
                self.assert_fails(blow, step=step, told=["the flow"])
                self.call(*self.words("output.every=0"), "--restart")
                for name in ("probes.csv", "forces.csv", "quality.csv"):
                    self.assertEqual((folder / name).read_text(), (reference / name).read_text())
                self.assertEqual((folder / "fields/fluid-000008.vtu").read_bytes(),
                                 (reference / "fields/fluid-000008.vtu").read_bytes())

    def test_a_step_whose_mesh_folds_is_cut_and_the_run_goes_on(self):
        soft = "solid.model.saint_venant_kirchhoff={young=2e3, poisson=0.35}"
        # Four steps are too few for the third order: the first guess of the last one folds the mesh.
        strong = (soft, "let.U=22", "time.step=0.05", "time.end=0.2", "coupling.predictor=3")
        output = self.call(*self.words(*strong)).stdout
        self.assertRegex(output, r"(?m)^step \d was done in \d pieces: the fluid mesh folds over in step \d")
        table = read_table(self.folder / "results/quality.csv")
        self.assertEqual(table["step"], [*range(1, 5)])
        self.assertEqual(table["certified"], [1] * 4)
        self.assertAlmostEqual(table["time"][-1], 0.2)
        for step, pieces in zip(table["step"], table["pieces"], strict=True):
            self.assertEqual(f"step {step:g} was done in {pieces:g} pieces" in output, pieces > 1)
        self.call(*self.words(*strong, "time.cuts=0"), code=FAILED)

    def test_steps_that_are_cut_are_shorter_steps(self):
        # Only whole steps feel this: they look at forces at t + 0.5125 step.
        common = ("time.start_up=0", "time.ringing_decay=0.4", "output.every=0")
        blow = 'fluid.body_force=["if(abs(t - 0.02 * floor(t / 0.02) - 0.01025) < 1e-4, sqrt(-1), 0)", "0"]'
        folder, halves = self.folder / "results", self.folder / "halves"
        self.call(*self.words(*common, "time.step=0.01"))
        folder.rename(halves)
        self.call(*self.words(*common, blow))
        self.assertEqual(read_table(folder / "quality.csv")["pieces"], [2] * 8)
        whole, half = (read_table(place / "probes.csv") for place in (folder, halves))
        for name in whole:
            if name != "step":
                for a, b in zip(whole[name], half[name][1::2], strict=True):
                    self.assertAlmostEqual(a, b, delta=1e-9 * max(map(abs, half[name])))

    def test_a_failed_run_may_go_on_with_shorter_steps(self):
        self.call(*self.words("coupling.iterations=4", "time.cuts=0"), code=FAILED)
        self.call(*self.words("time.step=0.01"), "--restart")
        self.assertAlmostEqual(read_table(self.folder / "results/probes.csv")["time"][-1], 0.16)


class Verify(RunTest):
    REFERENCE = "quantity,statistic,clock,factor,value,tolerance,kind,level,source\n"

    def verify(self, *rows, options=(), code=DONE):
        shutil.copy(support.CASES / "wall-ramm-flap/case.toml", self.folder)
        (self.folder / "reference.csv").write_text(self.REFERENCE + "".join(row + "\n" for row in rows))
        return self.call("verify", "case.toml", *arguments(TINY), *options, code=code)

    def test_a_kept_reference_exits_with_0(self):
        output = self.verify("time,last,,,0.06,1e-9,relative,both,the end").stdout
        self.assertIn("1 of 1 within tolerance", output)

    def test_a_missed_reference_exits_with_1(self):
        right, wrong = "time,last,,,0.06,1e-9,relative,both,the end", "time,last,,,0.07,0.1,relative,both,wrong"
        output = self.verify(right, wrong, code=MISSED).stdout
        self.assertRegex(output, r"(?m)^time +last +0.06 +0.07 +-1.43e-01 +0.1 +MISSED$")
        self.assertIn("1 of 2 within tolerance", output)
        self.verify(right, options=["--finished"])
        self.verify(wrong, options=["--finished"], code=MISSED)

    def test_a_level_without_references_is_a_mistake(self):
        row = "time,last,,,0.06,1e-9,relative,full,the end"
        self.assertIn("no reference of level 'short'",
                      self.verify(row, options=["--level", "short"], code=USER_ERROR).stderr)

    def test_missing_or_malformed_references_are_told_before_the_run(self):
        self.verify("time,lsat,,,0.06,1e-9,relative,both,the end", code=USER_ERROR)
        (self.folder / "reference.csv").unlink()
        self.assertIn("reference.csv", self.call("verify", "case.toml", code=USER_ERROR).stderr)
        self.assertFalse((self.folder / "results").exists())

    def test_a_run_that_fails_is_not_compared(self):
        result = self.verify("time,last,,,0.06,1e-9,relative,both,the end",
                             options=["--set", "fluid.newton.iterations=1"], code=FAILED)
        self.assertNotIn("within tolerance", result.stdout)


if __name__ == "__main__":
    support.main()
