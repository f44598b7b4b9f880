"""A run that was interrupted and continued gives what the uninterrupted run gives, bit for bit."""
import re
import signal

import support
from support import FLAP, INTERRUPTED, USER_ERROR, RunTest, arguments, checkpoints, row_count, wait_until

STEPS = 16
PROBES = ('output.probes={tip={at=[0.095, 0.06], of="displacement"}, wake={at=[0.1, 0.0602], of="velocity"}, '
          'front={at=[0.045, 0.06], of="pressure"}}')
# Settings, and after how many rows to interrupt.
VARIANTS = {
    "IQN-ILS without reuse": (["coupling.accelerator={iqn_ils={reuse=0}}"], [7]),
    "IQN-IMVJ": (["coupling.accelerator={iqn_imvj={}}"], [1, 7]),
    "IQN-IMVJ that forgets": (["coupling.accelerator={iqn_imvj={reuse=2}}"], [7]),
    "Aitken": (["coupling.accelerator={aitken={initial=1}}"], [0, 7]),
    "constant relaxation": (["coupling.accelerator={constant={relaxation=0.6}}"], [0, 7]),
    "a strong flow": (["let.U=2"], [7]),
    "order 3": (["blocks.order=3"], [7]),
    "nonlinear corners": (['motion.regenerate={corners="nonlinear"}'], [0, 7]),
    "backward Euler": (['time.scheme="backward-euler"'], [7]),
    "a solid with cells of its own": (["solid.order=3", "solid.divide=1.5"], [1, 7]),
    "a pseudo-solid": (["motion={pseudo_solid={}}"], [7]),
    "an incremental pseudo-solid": (['motion={pseudo_solid={from="last"}}'], [1, 7]),
    "a biharmonic mesh": (["motion={biharmonic={}}"], [7]),
}


def has_rows(folder, count):
    return lambda: row_count(folder / "probes.csv") >= count


class Restart(RunTest):
    def words(self, folder, *settings):
        common = (*FLAP, PROBES, f"time.end={0.02 * STEPS}", "output.every=0.06", "output.checkpoint_every=5")
        return ["run", support.CASES / "wall-ramm-flap/case.toml", "--directory", folder,
                *arguments((*common, *settings))]

    def interrupt(self, words, ready, number=signal.SIGINT):
        """Sends a signal as soon as ready(); returns the last step done."""
        for _ in range(10):
            process = self.start(*words)
            # The line of the results comes when signals are heard already.
            while not process.stdout.readline().startswith("results:"):
                pass
            sent = wait_until(ready, process)
            process.send_signal(number)
            output = process.communicate()[0]
            if sent and process.returncode == INTERRUPTED:
                break
            self.assertEqual(process.returncode, 0, output)  # it was over before the signal came
        self.assertEqual(process.returncode, INTERRUPTED, output)
        self.assertRegex(output, "continue with --restart")
        return int(re.search(r"interrupted after step (\d+)", output).group(1))

    def compare(self, settings, rows, number=signal.SIGINT, ready=None):
        """Interrupts after so many rows, or when something else is ready, and continues."""
        reference = self.folder / "uninterrupted"
        folder = self.folder / f"interrupted-{rows}"
        if not reference.exists():
            self.call(*self.words(reference, *settings))
        words = self.words(folder, *settings)
        step = self.interrupt(words, ready or has_rows(folder, rows), number)
        self.assertEqual(row_count(folder / "probes.csv"), step)
        self.assertEqual(checkpoints(folder)[-1].name, f"step-{step:06}")
        output = self.call(*words, "--restart").stdout
        self.assertIn(f"continuing after step {step} ", output)
        self.assert_same_results(folder, reference)
        return step

    def test_an_interruption_at_any_step_leaves_no_trace(self):
        steps = [self.compare((), rows) for rows in (0, 1, 2, 4, 9)]
        self.assertEqual(steps[0], 1)  # within the start-up

    def test_a_run_interrupted_in_its_last_step_only_has_to_write_its_fields(self):
        before = self.folder / f"interrupted-{STEPS}/checkpoint/step-{STEPS - 1:06}/rank-0.bin"
        self.assertEqual(self.compare((), STEPS, ready=before.exists), STEPS)

    def test_an_interruption_leaves_no_trace_in_any_variant(self):
        for name, (settings, interruptions) in VARIANTS.items():
            with self.subTest(name):
                for path in list(self.folder.iterdir()):
                    if " before " not in path.name:
                        path.rename(path.with_name(f"{path.name} before {name}"))
                for rows in interruptions:
                    self.compare(settings, rows)

    def test_sigterm_is_heard_as_sigint_is(self):
        self.compare((), 3, signal.SIGTERM)

    def test_a_run_in_many_pieces_is_the_run_in_one(self):
        reference, folder = self.folder / "one", self.folder / "many"
        self.call(*self.words(reference))
        words = self.words(folder)
        pieces, step = [], 0
        while step < STEPS - 3:
            restart = ["--restart"] if step > 0 else []
            step = self.interrupt([*words, *restart], has_rows(folder, step + 1))
            pieces.append(step)
        self.assertGreater(len(pieces), 3)
        self.call(*words, "--restart")
        self.assert_same_results(folder, reference)

    def test_a_finished_run_has_nothing_to_continue(self):
        folder = self.folder / "results"
        self.call(*self.words(folder, "time.end=0.08"))
        before = (folder / "quality.csv").read_bytes()
        self.call(*self.words(folder, "time.end=0.08"), "--restart")
        self.assertEqual((folder / "quality.csv").read_bytes(), before)

    def test_a_finished_run_goes_on_to_a_later_end(self):
        reference, folder = self.folder / "one", self.folder / "two"
        self.call(*self.words(reference, "time.end=0.24"))
        self.call(*self.words(folder, "time.end=0.12"))
        self.call(*self.words(folder, "time.end=0.24"), "--restart")
        self.assert_same_results(folder, reference)

    def test_a_restart_may_change_the_length_of_step(self):
        folder = self.folder / "results"
        self.call(*self.words(folder, "time.end=0.1"))
        self.call(*self.words(folder, "time.end=0.12", "time.step=0.005"), "--restart")
        table = support.read_table(folder / "probes.csv")
        self.assertEqual(table["step"], [*range(1, 10)])
        expected = [0.02, 0.04, 0.06, 0.08, 0.1, 0.105, 0.11, 0.115, 0.12]
        for time, wanted in zip(table["time"], expected, strict=True):
            self.assertAlmostEqual(time, wanted, places=14)

    def test_a_restart_without_checkpoint_is_refused(self):
        words = self.words(self.folder / "nowhere")
        self.assertIn("there is no complete checkpoint", self.call(*words, "--restart", code=USER_ERROR).stderr)
        self.assertFalse((self.folder / "nowhere").exists())

    def test_a_checkpoint_of_another_mesh_is_refused(self):
        folder = self.folder / "results"
        self.call(*self.words(folder, "time.end=0.02"))
        tables = (folder / "probes.csv").read_bytes()
        result = self.call(*self.words(folder, "blocks.order=3"), "--restart", code=USER_ERROR)
        self.assertIn("start anew", result.stderr)
        self.assertEqual((folder / "probes.csv").read_bytes(), tables)

    def test_a_new_run_forgets_what_an_earlier_one_left(self):
        folder = self.folder / "results"
        self.call(*self.words(folder))
        settings = ("time.end=0.06", "output.forces=[]", "output.every=0")
        words = self.words(folder, *settings)
        self.interrupt(words, has_rows(folder, 0))
        self.assertFalse((folder / "forces.csv").exists())
        self.call(*words, "--restart")
        self.assertEqual((folder / "fields.pvd").read_text().count("<DataSet"), 2)


if __name__ == "__main__":
    support.main()
