"""Several processes give what one gives, continue what they began, and end together when one of them cannot go on."""
import os
import signal
import subprocess

import support
from support import (ENVIRONMENT, FLAP, INTERRUPTED, USER_ERROR, RunTest, arguments, checkpoints, read_table,
                     row_count, wait_until)

# Relative to the largest value of a column; asked for by the project's first release.
AGREEMENT = 1e-7

TIGHT = ("fluid.newton.tolerance=1e-11", "coupling.tolerance=1e-10")


class Parallel(RunTest):
    def words(self, folder, *settings, case="wall-ramm-flap"):
        return ["run", support.CASES / case / "case.toml", "--directory", folder, *arguments(settings)]

    def assert_close(self, folder, reference, tables=("probes.csv", "forces.csv")):
        for name in tables:
            columns, expected = read_table(folder / name), read_table(reference / name)
            self.assertEqual(list(columns), list(expected))
            for column, wanted in expected.items():
                scale = max(map(abs, wanted))
                self.assertTrue(scale > 0.0 or column == "time", f"{column} is zero: nothing to compare")
                for value, right in zip(columns[column], wanted, strict=True):
                    self.assertLessEqual(abs(value - right), AGREEMENT * scale, f"{name}: {column}")

    def compare(self, case, *settings):
        reference = self.folder / "1"
        self.call(*self.words(reference, *settings, case=case))
        for processes in (2, 4):
            folder = self.folder / str(processes)
            self.call(*self.words(folder, *settings, case=case), processes=processes)
            self.assert_close(folder, reference)

    def test_the_moving_flap_does_not_depend_on_the_number_of_processes(self):
        self.compare("wall-ramm-flap", *FLAP, "time.end=0.3", *TIGHT)

    def test_a_solid_with_cells_of_its_own_does_not_depend_on_the_number_of_processes(self):
        self.compare("wall-ramm-flap", *FLAP, "time.end=0.2", "let.U=5", "solid.order=3", "solid.divide=2", *TIGHT,
                     "coupling.tolerance=1e-8")

    def test_the_flap_with_the_tolerances_of_the_case_does_not_either(self):
        self.compare("wall-ramm-flap", *FLAP, "time.end=0.2")

    def test_the_flow_around_the_cylinder_does_not_either(self):
        self.compare("schaefer-turek-2d1", "blocks.order=2")

    def test_the_bent_flag_does_not_either(self):
        self.compare("turek-hron-fsi1", "blocks.order=1")

    def test_all_processes_stop_at_the_signal_of_one_and_continue(self):
        settings = (*FLAP, "time.end=0.4", "output.every=0.1")
        reference, folder = self.folder / "reference", self.folder / "interrupted"
        self.call(*self.words(reference, *settings), processes=2)
        words = self.words(folder, *settings)
        # Each process tells its number before it becomes the program.
        tell = ["sh", "-c", f'echo $$ > "{self.folder}/process-$OMPI_COMM_WORLD_RANK"; exec "$@"', "sh"]
        process = subprocess.Popen([support.MPIEXEC, "-n", "2", *tell, support.PROGRAM, *map(str, words)],
                                   env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.kill)
        self.assertTrue(wait_until(lambda: row_count(folder / "probes.csv") >= 3, process))
        os.kill(int((self.folder / "process-1").read_text()), signal.SIGTERM)
        self.assertEqual(process.wait(60), INTERRUPTED)
        step = row_count(folder / "probes.csv")
        self.assertLess(step, 20)
        self.assertEqual(checkpoints(folder)[-1].name, f"step-{step:06}")
        self.call(*words, "--restart", processes=2)
        self.assert_close(folder, reference)

    def test_a_run_of_two_processes_is_not_continued_by_another_number(self):
        folder = self.folder / "results"
        words = self.words(folder, *FLAP, "time.end=0.04")
        self.call(*words, processes=2)
        for processes in (1, 3):
            result = self.call(*words, "--restart", code=USER_ERROR, processes=processes)
            self.assertIn("were written by 2 processes, but now there", result.stderr)

    def assert_ends(self, *words, processes=2):
        """The error of a run, which must come within 60 s: processes that wait for others would wait for ever."""
        return self.call(*words, code=USER_ERROR, processes=processes, seconds=60).stderr

    def test_mistakes_of_the_case_are_told_once(self):
        error = self.assert_ends(*self.words(self.folder, "time.stpe=1"))
        self.assertEqual(error.count("did you mean 'step'?"), 1)

    def test_a_folder_that_only_the_first_process_writes_to_ends_all(self):
        (self.folder / "file").touch()
        self.assertIn("choose another folder", self.assert_ends(*self.words(self.folder / "file", *FLAP)))

    def test_a_probe_outside_ends_all(self):
        words = self.words(self.folder / "results", *FLAP,
                           'output.probes={corner={at=[0.05, 0.06], of="velocity"}}')
        self.assertIn("corner", self.assert_ends(*words, processes=3))

    def test_a_process_that_cannot_write_its_fields_ends_all(self):
        for rank in (0, 1):
            with self.subTest(rank=rank):
                folder = self.folder / f"results-{rank}"
                (folder / f"fields/fluid-000002-{rank}.vtu.tmp").mkdir(parents=True)
                error = self.assert_ends(*self.words(folder, *FLAP, "time.end=0.1", "output.every=0.04"))
                self.assertIn(f"fluid-000002-{rank}.vtu", error)

    def test_a_damaged_checkpoint_of_one_process_is_passed_over_by_all(self):
        folder = self.folder / "results"
        words = self.words(folder, *FLAP, "time.end=0.06", "output.checkpoint_every=1")
        self.call(*words, processes=2)
        (checkpoints(folder)[-1] / "rank-1.bin").write_bytes(b"blockfsi")
        self.assertIn("continuing after step 2 ", self.call(*words, "--restart", processes=2).stdout)


if __name__ == "__main__":
    support.main()
