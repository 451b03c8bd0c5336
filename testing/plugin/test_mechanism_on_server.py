# SPDX-License-Identifier: GPL-3.0-or-later
"""A mechanism whose scene file a server has read is felt as one that was read here, which is the judge."""

import contextlib
import json
import os
import pathlib
import sys
import tempfile
import unittest

from paraview import simple

from haptic_proxies import put
from test_surface_on_server import connected
from view_fixture import ViewTest

SCENES = pathlib.Path(os.environ["PALPATE_SOURCE_DIR"]) / "data" / "mechanisms"
TIP, FACE = 150.0, -8.0  # u: of the needle before the hand, of the wall's lower side
DEPTHS = (0.5, 1.0, 1.5, 2.0, 6.0, 12.0, 14.0)  # of the tip in the wall, which is pierced meanwhile [u]


class Held(ViewTest):
    """On whatever server is connected."""

    def __init__(self):
        super().__init__("hold")

    def hold(self, file):
        self.source = simple.HapticMechanism(registrationName="Mechanism", FileName=str(file))
        self.show(self.source)
        for name, value in (("Scale", 1000.0), ("Stiffness", 500.0), ("Passivity", 0)):
            put(self.proxy, name, value)
        self.lead(-5.0)
        put(self.proxy, "MechanismSource", "Mechanism")
        self.follow()
        put(self.proxy, "Touching", 1)
        self.session.Step(1500)
        self.follow()

    def lead(self, depth):
        self.session.SetHandPosition(0.0, 0.0, FACE + depth - TIP)

    def forces(self):
        felt = []
        for depth in DEPTHS:
            self.lead(depth)
            self.session.Step(100)
            self.follow()
            felt.append(tuple(self.session.GetForce()))
        return felt

    def text(self):
        self.session.Update()
        return self.session.GetMechanismText()


@contextlib.contextmanager
def held(file):
    one = Held()
    one.setUp()
    try:
        one.hold(file)
        yield one
    finally:
        one.tearDown()


class MechanismOnAServer(unittest.TestCase):
    def test_on_one_rank_or_two_it_feels_as_the_built_in_servers_and_is_no_surface(self):
        with held(SCENES / "needle.json") as here:
            expected = here.forces()
        self.assertLess(min(force[2] for force in expected), -0.5)
        for ranks in (1, 2):
            with connected(ranks), held(SCENES / "needle.json") as there:
                self.assertIn("2 constraints", there.text())
                found = there.forces()
                self.assertEqual(there.session.GetServerText(), "", "nothing of it is fetched to be touched as a surface")
            for one, other in zip(found, expected):
                for a, b in zip(one, other):
                    self.assertAlmostEqual(a, b, delta=1e-9)

    def test_another_file_and_its_end_are_followed(self):
        with connected(), held(SCENES / "needle.json") as there:
            there.source.FileName = str(SCENES / "suture.json")
            there.source.UpdatePipeline()
            there.follow()
            there.session.Step(100)
            self.assertIn("1 constraints", there.text())
            simple.Delete(there.source)
            there.follow()
            self.assertIn("does not exist", there.text())

    def test_a_file_of_a_body_that_is_on_the_server_alone_is_said_with_the_cure(self):
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            cells = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]))
            simple.SaveData(os.path.join(folder, "block.vtu"), cells)
            for source in (cells, cells.Input):
                simple.Delete(source)
            pathlib.Path(folder, "scene.json").write_text(json.dumps({
                "format": "palpate mechanism", "version": 1, "unit_m": 0.001,
                "bodies": [{"name": "needle", "kind": "held", "length": 150, "diameter": 1.2},
                           {"name": "block", "kind": "soft", "file": "block.vtu", "fixed": "zmax",
                            "young_Pa": 20000, "poisson": 0.4, "model": "linear"}],
                "laws": [{"name": "skin", "kind": "puncture", "a": "needle", "b": "block", "strength_N": 1.0}]}), encoding="utf-8")
            os.chdir(folder)  # the server finds files there that are not found from here
            try:
                with connected():
                    os.chdir(before)
                    with held("scene.json") as there:
                        self.assertRegex(there.text(), "Mechanism cannot be held: .*block.vtu.*comes from a server")
            finally:
                os.chdir(before)


if __name__ == "__main__":
    # A SystemExit would skip pvpython's own ending, which closes views before the display.
    if not unittest.main(exit=False, argv=sys.argv[:1] + (sys.argv[1:] or ["MechanismOnAServer"])).result.wasSuccessful():
        sys.exit(1)
