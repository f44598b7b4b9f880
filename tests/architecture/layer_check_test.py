"""layer_check_test.py CHECK_LAYERS: the check finds each kind of breach in a small tree, and none in a sound one."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

check = sys.argv.pop(1)
sound = {
    "layers.txt": "core:\nmesh: core\nlinalg: core\n",
    "src/core/error.hpp": "#include <string>\n",
    "src/core/error.cpp": '#include "core/error.hpp"\n',
    "src/mesh/mesh.hpp": '#include "core/error.hpp"\n',
    "src/linalg/vector.cpp": "#include <petscvec.h>\n",
}


class LayerCheck(unittest.TestCase):
    def run_on(self, changes):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**sound, **changes}.items():
                path = pathlib.Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            done = subprocess.run([sys.executable, check, folder], capture_output=True, text=True)
            return done.returncode, done.stdout

    def finds(self, changes, breach):
        self.assertEqual(self.run_on(changes), (1, breach + "\n"))

    def test_sound_tree(self):
        self.assertEqual(self.run_on({}), (0, "layers hold: 3 layers, 4 files\n"))

    def test_include_upwards(self):
        self.finds({"src/core/part.hpp": '#include "mesh/mesh.hpp"\n'},
                   "src/core/part.hpp: 'core' may not include \"mesh/mesh.hpp\"")

    def test_missing_file(self):
        self.finds({"src/mesh/mesh.hpp": '#include "core/part.hpp"\n'},
                   'src/mesh/mesh.hpp: "core/part.hpp" is no file of a layer below src/')

    def test_line_names_a_later_one(self):
        self.finds({"layers.txt": "core: mesh\nmesh: core\nlinalg: core\n"},
                   "layers.txt: 'core' names 'mesh', which is no line above it")

    def test_folder_without_line(self):
        self.finds({"src/extra/file.hpp": ""}, "src/extra has no line in layers.txt")

    def test_line_without_folder(self):
        self.finds({"layers.txt": sound["layers.txt"] + "fem: core\n"}, "layers.txt: 'fem' has no folder in src/")

    def test_petsc_outside_linalg(self):
        self.finds({"src/mesh/mesh.hpp": "#include <petscmat.h>\n"},
                   "src/mesh/mesh.hpp: <petscmat.h> is for src/linalg alone")

    def test_own_header_not_first(self):
        self.finds({"src/core/error.cpp": '#include <string>\n#include "core/error.hpp"\n'},
                   "src/core/error.cpp: the first include must be its own header, which shows that it stands alone")


unittest.main()
