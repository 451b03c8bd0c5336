# SPDX-License-Identifier: GPL-3.0-or-later
"""Touching from Python as paraview.simple does the rest, in ParaView's shell and in pvpython alike.

    from paraview.simple import *
    from palpate.simple import *

    Show(Sphere(Radius=50))
    SetHaptics(DeviceName="fed", Stiffness=500)
    Touch()
    print(HapticState()["StateText"])
    LetGo()

In ParaView these are the panel's session and the active view; in pvpython a session is made and registered with the
first call, and HapticUpdate() follows the view. What is refused is raised as HapticRefusal, in the words of the panel.
"""

import json
import os

import paraview
from paraview import servermanager, simple
from vtkmodules.vtkCommonDataModel import vtkTable

from palpate.vtkHapticInteraction import vtkHapticSession  # noqa: F401  the proxy's object becomes scriptable
from palpate.vtkHapticViews import vtkHapticViewScene

__all__ = ["HapticRefusal", "GetHapticSession", "SetHaptics", "Touch", "TakeColorRange", "LetGo", "FitHand", "HapticUpdate",
           "HapticState", "Mark", "GetMarks", "ClearMarks", "SaveMarks", "SetSource", "HoldTool", "PressBody", "SoftText",
           "HoldMechanism", "Laws", "AddLaw", "RemoveLaw", "BreakLaw"]


class HapticRefusal(RuntimeError):
    """What was refused, why, and what to do."""


_scenes = {}  # of sessions that no panel looks after, by global id


def _manager():
    return servermanager.ActiveConnection.Session.GetSessionProxyManager()


def _proxy():
    manager = _manager()
    present = manager.GetProxy("haptics", "HapticSession")
    if present:
        return present
    if not manager.GetProxyDefinitionManager().HasDefinition("haptics", "HapticSession"):
        raise HapticRefusal("The server has not the plugin Palpate: start it with the plugin's folder in PV_PLUGIN_PATH, then connect again."
                            if servermanager.ActiveConnection.IsRemote() else
                            "Palpate is not loaded: call LoadPlugin('.../Palpate.so') first.")
    made = manager.NewProxy("haptics", "HapticSession")
    servermanager.vtkSMPropertyHelper(made, "FitOnTouch").Set(1)
    made.UpdateVTKObjects()
    manager.RegisterProxy("haptics", "HapticSession", made)
    return made


class _Refusals:
    """Raises what the session refuses within, instead of printing it."""

    def __enter__(self):
        self.session = GetHapticSession()
        self.refused = None
        self.observer = self.session.AddObserver("ErrorEvent", self._note)
        return self.session

    def _note(self, *_):
        self.refused = self.session.GetProblem()  # a proxy that reads the former value back takes the sentence away

    def __exit__(self, kind, *_):
        self.session.RemoveObserver(self.observer)
        if self.refused and kind is None:
            raise HapticRefusal(self.refused)


def _put(name, value):
    servermanager.ProxyManager().GetProxy("haptics", "HapticSession").SetPropertyWithName(name, value)


def _value(name):
    value = servermanager.ProxyManager().GetProxy("haptics", "HapticSession").GetPropertyValue(name)
    return value if isinstance(value, (int, float, str)) else list(value)


def _described(name):
    """What the table of settings says of one; None of what is none."""
    settings = json.loads(GetHapticSession().GetDescribed())["settings"]
    return next((setting for setting in settings if setting["name"] == name), None)


def _taken(setting):
    """Such values as a setting takes, in words."""
    count = max(len(setting["defaults"]), 1)
    number = "a number" if count == 1 else f"{count} numbers"
    kinds = {"text": "a text", "flag": "1 or 0", "count": "a whole number", "choice": "a whole number", "points": "numbers, three a point"}
    allowed = setting["allowed"] if setting["kind"] != "text" else ""
    return kinds.get(setting["kind"], number) + (f" ({allowed})" if allowed else "")


def _is_number(value):
    return isinstance(value, (int, float))


def _source_name(source):
    """In the pipeline browser, of a proxy or a name."""
    if isinstance(source, str):
        name = source if _manager().GetProxy("sources", source) else None
    else:
        name = _manager().GetProxyName("sources", source.SMProxy) if hasattr(source, "SMProxy") else None
    if not name:
        there = ", ".join(name for name, _ in simple.GetSources())
        advice = f"name one of these: {there}." if there else "there is none yet, open a file."
        raise HapticRefusal(f"The pipeline has no source {source!r}; {advice}")
    return name


def _touchable_view(view):
    """That view, or the active one. Refused is a view in which nothing can be touched."""
    if not hasattr(view, "MakeRenderWindowInteractor") and view is not None:
        raise HapticRefusal(f"{view!r} is no view; give what CreateView or GetActiveView returns, or nothing for the active one.")
    view = view or simple.GetActiveView()
    looked_at = vtkHapticViewScene()
    looked_at.SetSession(_proxy().GetClientSideObject())  # which says whether numbers in space are felt
    if view:
        simple.Render(view)
        looked_at.SetView(view.SMProxy)
    if looked_at.GetRefusal():
        raise HapticRefusal(looked_at.GetRefusal())
    return view


def _follow(view):
    """Has the session feel what the view shows; the panel does that by itself, for the active view."""
    if getattr(paraview, "palpate_panel", False):
        simple.SetActiveView(view)
        return
    simple.Render(view)
    proxy = _proxy()
    scene = _scenes.setdefault(proxy.GetGlobalIDAsString(), vtkHapticViewScene())
    scene.SetSession(proxy.GetClientSideObject())
    scene.SetView(view.SMProxy)
    scene.Update()


def GetHapticSession():
    """The session's object, with all that a proxy does not offer: Step(n), SetHandPosition(x, y, z) ..."""
    return _proxy().GetClientSideObject()


def SetHaptics(**settings):
    """Sets properties of the session by name: SetHaptics(Stiffness=300, Radius=0.5)."""
    for name, value in settings.items():
        setting = _described(name)
        if not setting:
            raise HapticRefusal(f"{name} is no setting of the session; plugin/README.md lists them.")
        before = _value(name)
        try:
            with _Refusals():
                _put(name, value)
        except HapticRefusal:
            _put(name, before)  # the property says what the session has
            raise
        except (TypeError, RuntimeError):  # so ParaView says that it is of another kind
            _put(name, before)
            raise HapticRefusal(f"{name} takes {_taken(setting)}, not {value!r}.") from None


def Touch(view=None):
    """Touches what a view shows, the active one if none is named. Returns once the scene is built, and a field's brick."""
    view = _touchable_view(view)
    with _Refusals() as session:
        _follow(view)
        _put("Touching", 1)
        session.FinishScene()
        if session.GetFieldName():
            session.FinishField()
        session.Update()


def TakeColorRange(view=None):
    """What low and high feel like is what a view's colour maps show low and high: data ranges of the arrays of stiffness,
    friction and texture, isovalue (half as opaque as any) and levels of the field's. A line for each that was set."""
    view = view or simple.GetActiveView()
    looked_at = vtkHapticViewScene()
    looked_at.SetView(view.SMProxy if view else None)
    said = looked_at.TakeColorRange(_proxy())
    if not said:
        raise HapticRefusal("Nothing that is felt is coloured by; colour by an array that is felt.")
    return said


def LetGo():
    """Force to zero within 50 ms, and no touching any more. What was held or bent is shown as it is at rest."""
    scene = _scenes.get(_proxy().GetGlobalIDAsString())
    _put("Touching", 0)
    if scene:
        scene.ShowHanded()


def FitHand(view=None):
    """Scale and place such that the device's workspace holds everything that a view shows, the active one if none is
    named, touched already or not."""
    view = _touchable_view(view)
    with _Refusals() as session:
        _follow(view)
        _proxy().InvokeCommand("FitWorkspace")
        session.FinishScene()


def HapticUpdate():
    """Takes the session's latest state and, where no panel does it, what the view shows now."""
    scene = _scenes.get(_proxy().GetGlobalIDAsString())
    if scene:
        scene.Update()
    GetHapticSession().Update()


def HapticState():
    """All that the session says of itself now, by name: force, contact, state in words ..."""
    HapticUpdate()
    session = GetHapticSession()
    readouts = json.loads(session.GetDescribed())["readouts"]
    return {readout["name"]: getattr(session, "Get" + readout["name"])() for readout in readouts}


def Mark():
    """Sets a mark at the contact. Returns it as GetMarks() does."""
    with _Refusals():
        HapticUpdate()
        _proxy().InvokeCommand("AddMark")
    return GetMarks()[-1]


def GetMarks():
    """The marks in their order, each a dictionary: Source, X, Y, Z and all that was found there."""
    table = vtkTable()
    GetHapticSession().GetInspection().GetMarksTable(table)
    return _rows(table)


def _rows(table):
    columns = [table.GetColumn(column) for column in range(table.GetNumberOfColumns())]
    return [{column.GetName(): column.GetValue(row) for column in columns} for row in range(table.GetNumberOfRows())]


def ClearMarks():
    """Removes all marks."""
    _proxy().InvokeCommand("ClearMarks")


def SaveMarks(file):
    """Writes the marks as csv or vtp, by the suffix."""
    if not isinstance(file, (str, os.PathLike)):
        raise HapticRefusal(f"{file!r} is no file's name; give one that ends in .csv or .vtp.")
    with _Refusals() as session:
        session.GetInspection().WriteMarks(os.fspath(file))


def SetSource(source, touched=None, stiffness=None, friction=None):
    """Touches one source in a way of its own: a proxy, or its name in the pipeline browser. `stiffness` [N/m] as felt,
    `friction` at rest and sliding. What is not named stays as it is."""
    name = _source_name(source)
    if touched not in (None, True, False):
        raise HapticRefusal(f"{name}: touched is True or False, not {touched!r}.")
    if stiffness is not None and not _is_number(stiffness):
        raise HapticRefusal(f"{name}: stiffness is a number [N/m], not {stiffness!r}.")
    if friction is not None and not (isinstance(friction, (tuple, list)) and len(friction) == 2 and all(map(_is_number, friction))):
        raise HapticRefusal(f"{name}: friction is two numbers, at rest and sliding, as (0.5, 0.3), not {friction!r}.")
    with _Refusals() as session:
        material = [0.0, 0.0, 0.0]
        session.GetSourceMaterial(name, material)
        own_stiffness = material[0] if stiffness is None else stiffness
        taken = session.SetSourceMaterial(name, own_stiffness, *(material[1:] if friction is None else friction))
        if taken and touched is not None:
            session.SetSourceTouched(name, touched)


def HoldTool(source=None, view=None):
    """Holds the surface of a source in place of the ball: a proxy, or its name in the pipeline browser; None: the ball.
    The source is hidden, for the tool is drawn where it is."""
    name = None if source is None else _source_name(source)
    with _Refusals():
        _put("ToolSource", name or "")
        if name:
            simple.Hide(simple.FindSource(name), view or simple.GetActiveView())
        HapticUpdate()


def PressBody(source=None, rate=None):
    """Has the output of Soft Body give way: a proxy, or its name in the pipeline browser; None: nothing does. It bends in
    the view, with its arrays Displacement, Strain and Stress. rate: how often it is computed [Hz]."""
    name = None if source is None else _source_name(source)
    with _Refusals():
        if rate is not None:
            _put("SoftRate", rate)
        _put("SoftSource", name or "")
        HapticUpdate()


def SoftText(source):
    """What Soft Body or Soft Skin says of what it has made: material and what is assumed of it, what coarse tetrahedra leave
    out. A proxy of theirs."""
    source.UpdatePipeline()
    source.SMProxy.UpdatePropertyInformation()
    return source.GetPropertyValue("Text")


def HoldMechanism(source=None, turning=None, laws=None):
    """Holds a body of the output of Haptic Mechanism: a proxy, or its name in the pipeline browser; None: none. turning:
    how stiffly the hand turns it [N m/rad], 0: it turns freely. laws: a list of laws in place of those of its scene
    file, each a dictionary as in that; []: the file's."""
    name = None if source is None else _source_name(source)
    with _Refusals() as session:
        if turning is not None:
            _put("MechanismTurning", turning)
        if name != session.GetSettingText("MechanismSource"):
            _put("MechanismLaws", "")  # those of another mechanism would not fit
        _put("MechanismSource", name or "")
        _follow_if_none()
        HapticUpdate()
        if laws is not None:
            _put("MechanismLaws", json.dumps(laws) if laws else "")
            _put("MechanismLaws", session.GetSettingText("MechanismLaws"))  # what was refused is not kept in a state file
            HapticUpdate()


def _follow_if_none():
    """What is held before the first touch is read then, so that what is wrong with it is raised there."""
    scene, view = _scenes.get(_proxy().GetGlobalIDAsString()), simple.GetActiveView()
    if (not scene or not scene.GetView()) and hasattr(view, "MakeRenderWindowInteractor"):
        _follow(view)


def Laws():
    """The laws of the mechanism in their order, each a dictionary: Law, Kind, A, B, Numbers, Phase, Force [N], Inside [u]."""
    table = vtkTable()
    GetHapticSession().GetMechanism().GetTable(table)
    return _rows(table)


def _put_laws(laws):
    if laws:
        _put("MechanismLaws", laws)
        HapticUpdate()


def AddLaw(**law):
    """Another law of the mechanism, with the keys of a scene file; in the place of the one of its name, if there is
    one. MechanismLaws has it."""
    with _Refusals() as session:
        _put_laws(session.GetMechanism().GetLawsWith(json.dumps(law)))


def RemoveLaw(name):
    """One law less. MechanismLaws has what is left."""
    with _Refusals() as session:
        _put_laws(session.GetMechanism().GetLawsWithout(name))


def BreakLaw(name):
    """From the next tick on that law holds no more, until the mechanism is held or touched anew, or
    has other laws."""
    with _Refusals() as session:
        session.GetMechanism().BreakLaw(name)
