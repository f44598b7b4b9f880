"""What the tests of whole runs share: the program, small cases, and comparisons of results."""
import os
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM = CASES = MPIEXEC = None

ENVIRONMENT = {
    **os.environ,
    "OPENBLAS_NUM_THREADS": "1",
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_mpi_yield_when_idle": "1",
    "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
}

# The flap on a mesh so coarse that a step takes hundredths of a second. Long steps make it move.
FLAP = (
    "blocks.order=2",
    "blocks.lattice.channel.divide.x=[2, 2, 4, 4]",
    "blocks.lattice.channel.divide.y=[2, 2, 1, 2, 2]",
    "time.step=0.02",
)

DONE, MISSED, USER_ERROR, FAILED, INTERRUPTED = 0, 1, 2, 3, 130

# Before the arrays of a checkpoint stands a header with the time at which its run began.
CHECKPOINT_HEADER = 48


def arguments(settings):
    return [argument for setting in settings for argument in ("--set", setting)]


def read_table(path):
    """Columns of a CSV file by name."""
    lines = path.read_text().splitlines()
    rows = [[float(field) for field in line.split(",")] for line in lines[1:]]
    return {name: [row[i] for row in rows] for i, name in enumerate(lines[0].split(","))}


def row_count(path):
    """Whole rows of a CSV file that a run is writing; -1 where there is none yet."""
    try:
        return path.read_bytes().count(b"\n") - 1
    except FileNotFoundError:
        return -1


def wait_until(condition, process, seconds=60):
    """Whether the condition came true while the process lived."""
    end = time.monotonic() + seconds
    while process.poll() is None:
        if condition():
            return True
        assert time.monotonic() < end, "waited too long"
        time.sleep(0.0005)
    return False


def checkpoints(folder):
    """Sets of checkpoints in a folder of results, oldest first."""
    return sorted((folder / "checkpoint").glob("step-*"))


class RunTest(unittest.TestCase):
    """A test with a folder of its own."""

    maxDiff = 2000

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="blockfsi-")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def command(self, *words, processes=1):
        launch = [MPIEXEC, "-n", str(processes)] if processes > 1 else []
        return [*launch, PROGRAM, *map(str, words)]

    def call(self, *words, code=DONE, processes=1, seconds=120):
        """Runs the program; fails unless it ends with that code in that time."""
        result = subprocess.run(self.command(*words, processes=processes), env=ENVIRONMENT, timeout=seconds,
                                capture_output=True, text=True, cwd=self.folder)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def start(self, *words, processes=1):
        process = subprocess.Popen(self.command(*words, processes=processes), env=ENVIRONMENT, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, cwd=self.folder)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def assert_same_results(self, folder, reference):
        """All files alike, byte for byte; of the checkpoints the newest, but for its header."""
        def files(root):
            return {str(path.relative_to(root)): path.read_bytes() for path in root.rglob("*")
                    if path.is_file() and "checkpoint" not in path.parts}

        found, expected = files(folder), files(reference)
        self.assertEqual(sorted(found), sorted(expected))
        for name, content in expected.items():
            if found[name] == content:
                continue
            if name.endswith(".csv"):
                self.assertEqual(found[name].decode(), content.decode(), name)
            self.fail(f"{name} differs")
        newest, expected_newest = checkpoints(folder)[-1], checkpoints(reference)[-1]
        self.assertEqual(newest.name, expected_newest.name)
        for path in expected_newest.iterdir():
            other = newest / path.name
            self.assertTrue(other.read_bytes()[CHECKPOINT_HEADER:] == path.read_bytes()[CHECKPOINT_HEADER:],
                            f"{newest.name}/{path.name} differs")


def main():
    """SCRIPT BLOCKFSI CASES MPIEXEC [options of unittest]"""
    global PROGRAM, CASES, MPIEXEC
    PROGRAM, CASES, MPIEXEC = sys.argv[1], Path(sys.argv[2]), sys.argv[3]
    unittest.main(module="__main__", argv=[sys.argv[0], *sys.argv[4:]], verbosity=2)
