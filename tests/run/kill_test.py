"""A run that is killed while it writes, again and again, and continued each time, ends as if nothing had been."""
import os
import random
import time

import support
from support import FLAP, USER_ERROR, RunTest, arguments, checkpoints, row_count, wait_until

STEPS = 30
KILLS = 10


class Kill(RunTest):
    def words(self, folder, *settings):
        # Everything is written in every step, so that most moments are moments of writing.
        common = (*FLAP, f"time.end={0.02 * STEPS}", "output.every=0.02", "output.checkpoint_every=1")
        return ["run", support.CASES / "wall-ramm-flap/case.toml", "--directory", folder,
                *arguments((*common, *settings))]

    def kill(self, words, wait):
        """Whether the process was alive when it was killed, after wait(process)."""
        process = self.start(*words)
        while process.poll() is None and not process.stdout.readline().startswith("results:"):
            pass
        wait(process)
        process.kill()
        process.communicate()
        return process.returncode < 0

    def test_a_run_killed_while_it_writes_ends_as_one_left_alone(self):
        chance = random.Random(20260101)
        reference, folder = self.folder / "alone", self.folder / "killed"
        self.call(*self.words(reference))
        half_written = (folder / "checkpoint", folder / "fields")

        def is_writing():
            return any(name.endswith(".tmp") for part in half_written if part.exists()
                       for _, _, names in os.walk(part) for name in names)

        kills = 0
        while kills < KILLS:
            restart = ["--restart"] if any(folder.glob("checkpoint/step-*/rank-0.bin")) else []
            steps = row_count(folder / "quality.csv") + 1
            by_chance = lambda process: time.sleep(chance.uniform(0.0, 0.1))
            amid = lambda process: wait_until(
                lambda: row_count(folder / "quality.csv") > steps and is_writing(), process)
            if not self.kill([*self.words(folder), *restart], chance.choice([by_chance, amid])):
                break
            kills += 1
        self.assertGreaterEqual(kills, 5)
        self.call(*self.words(folder), "--restart")
        self.assert_same_results(folder, reference)

    def test_a_run_killed_before_its_first_checkpoint_must_start_anew(self):
        folder = self.folder / "results"
        words = self.words(folder, "output.checkpoint_every=1000")
        killed = self.kill(words, lambda process: wait_until(
            lambda: row_count(folder / "probes.csv") >= 2, process))
        self.assertTrue(killed)
        result = self.call(*words, "--restart", code=USER_ERROR)
        self.assertIn("there is no complete checkpoint", result.stderr)
        self.assertIn("run without --restart", result.stderr)
        self.assertGreaterEqual(row_count(folder / "probes.csv"), 2)

    def test_a_torn_checkpoint_is_passed_over(self):
        reference, folder = self.folder / "alone", self.folder / "torn"
        self.call(*self.words(reference, "time.end=0.16"))
        self.call(*self.words(folder, "time.end=0.1"))
        newest = next(checkpoints(folder)[-1].iterdir())
        newest.write_bytes(newest.read_bytes()[:-100])
        output = self.call(*self.words(folder, "time.end=0.16"), "--restart").stdout
        self.assertIn("continuing after step 4 ", output)
        self.assert_same_results(folder, reference)

    def test_a_torn_last_row_is_written_again(self):
        reference, folder = self.folder / "alone", self.folder / "torn"
        self.call(*self.words(reference, "time.end=0.16"))
        self.call(*self.words(folder, "time.end=0.1"))
        for name in ("probes.csv", "forces.csv", "quality.csv"):
            with open(folder / name, "a") as file:
                file.write("6,0.12,0.0")
        self.call(*self.words(folder, "time.end=0.16"), "--restart")
        self.assert_same_results(folder, reference)


if __name__ == "__main__":
    support.main()
