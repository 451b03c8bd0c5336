# SPDX-License-Identifier: GPL-3.0-or-later
"""Saves a scene that is touched as this release of ParaView does: box-SERIES.pvsm and box-SERIES.py in the folder STATES, of which
gzip -9 is kept here. The script is run by `paraview --plugin-search-paths=$PV_PLUGIN_PATH --plugins=Palpate
--script=save_states.py`, with the environment of the tests: only the client writes the touched sources into Python states."""

import os

from paraview import simple, smstate

from displays import move  # noqa: E402
from palpate.simple import SetHaptics, SetSource  # noqa: E402

view = simple.GetActiveViewOrCreate("RenderView")
SetHaptics(DeviceName="fed", VirtualTime=1, Stiffness=400.0, FitOnTouch=0, Scale=1000.0, Offset=[0, 0, 0], FrictionStatic=0.0)
box = simple.Box(registrationName="Box", XLength=100, YLength=100, ZLength=100)
move(simple.Show(box, view), [3.0, 0.0, 0.0])
SetSource("Box", stiffness=250.0)
simple.Render(view)
name = os.path.join(os.environ["STATES"], f"box-{os.environ['PALPATE_PARAVIEW']}")
simple.SaveState(name + ".pvsm")
with open(name + ".py", "w", encoding="utf-8") as file:
    file.write(smstate.get_state())
os._exit(0)  # whatever ParaView would ask
