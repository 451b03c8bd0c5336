# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the plugin; its proxies by name, and their properties."""

import os

from paraview import servermanager, simple

simple.LoadPlugin(os.environ["PALPATE_PLUGIN"], remote=False, ns=globals())
from palpate.vtkHapticInteraction import vtkHapticSession  # noqa: E402,F401  the proxies' objects become scriptable
from palpate.vtkHapticViews import vtkHapticViewScene  # noqa: E402,F401


def manager():
    return servermanager.ActiveConnection.Session.GetSessionProxyManager()


def put(proxy, name, *values):
    for index, value in enumerate(values):
        servermanager.vtkSMPropertyHelper(proxy, name).Set(index, value)
    proxy.UpdateVTKObjects()
