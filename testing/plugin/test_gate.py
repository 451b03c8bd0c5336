# SPDX-License-Identifier: GPL-3.0-or-later
"""A plugin that ParaView cannot have says why: it was built for another ParaView, or a library beside it is missing."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

LOAD = "import sys; from paraview import simple; simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())"


class Gate(unittest.TestCase):
    def said(self, plugin):
        """By ParaView, which goes on without the plugin."""
        with tempfile.NamedTemporaryFile("w", suffix=".py") as script:
            script.write(LOAD)
            script.flush()
            run = subprocess.run([shutil.which("pvpython"), "--dr", script.name, str(plugin)], capture_output=True, text=True, check=False)
        said = run.stdout + run.stderr
        self.assertIn("RuntimeError: Problem loading plugin", said)
        return said

    def test_in_another_paraview_it_names_both_and_what_to_do(self):
        said = self.said(os.environ["PALPATE_GATE_OF_ANOTHER"])
        self.assertIn("was built for ParaView 4.0, and this is ParaView " + os.environ["PALPATE_PARAVIEW"] + ". Install the package", said)

    def test_without_what_belongs_beside_it_it_names_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            alone = pathlib.Path(folder, "Palpate.so")
            shutil.copy(os.environ["PALPATE_PLUGIN"], alone)
            said = self.said(alone)
        self.assertIn(f"the plugin cannot be opened: {folder}/PalpatePlugin.so: cannot open shared object file", said)


if __name__ == "__main__":
    if not unittest.main(exit=False).result.wasSuccessful():
        sys.exit(1)
