# SPDX-License-Identifier: GPL-3.0-or-later
"""Touch data from Python, in the style of paraview.simple, in ParaView's shell and in pvpython.

    from paraview.simple import *
    from palpate.simple import *

    Show(Sphere(Radius=50))
    SetHaptics(DeviceName="fed", Stiffness=500)
    Touch()
    print(HapticState()["StateText"])
    LetGo()

In ParaView the functions use the panel's session and the active view. In pvpython the first call creates and registers
a session, and HapticUpdate() follows the view. A refusal is raised as HapticRefusal, with the message of the panel.
"""

import json
import math
import numbers
import os

import paraview
from paraview import servermanager, simple
from vtkmodules.vtkCommonDataModel import vtkTable

from palpate.vtkHapticInteraction import vtkHapticSession  # noqa: F401  the proxy's object becomes scriptable
from palpate.vtkHapticViews import vtkHapticTouchAs, vtkHapticViewScene

__all__ = ["HapticRefusal", "GetHapticSession", "SetHaptics", "Touch", "TakeColorRange", "LetGo", "FitHand", "HapticUpdate",
           "HapticState", "Mark", "GetMarks", "Marks", "AddMark", "RemoveMark", "RenameMark", "ClearMarks", "SaveMarks",
           "LoadMarks", "MapContact", "SetSource", "Touched", "TouchAs", "HoldTool", "PressBody", "SoftText",
           "HoldMechanism", "Constraints", "AddConstraint", "RemoveConstraint", "BreakConstraint",
           "PutBack", "PlaceWire"]


class HapticRefusal(RuntimeError):
    """A refused request: the message names the request, the reason and the remedy."""


_scenes = {}  # of sessions that no panel looks after, by global id


def _manager():
    return servermanager.ActiveConnection.Session.GetSessionProxyManager()


def _proxy():
    manager = _manager()
    present = manager.GetProxy("haptics", "HapticSession")
    if present:
        return present
    if not manager.GetProxyDefinitionManager().HasDefinition("haptics", "HapticSession"):
        raise HapticRefusal("The server has not loaded the Palpate plugin. Start pvserver with PV_PLUGIN_PATH set to the plugin's folder, then connect again."
                            if servermanager.ActiveConnection.IsRemote() else
                            "Palpate is not loaded: call LoadPlugin('.../Palpate.so') first.")
    made = manager.NewProxy("haptics", "HapticSession")
    servermanager.vtkSMPropertyHelper(made, "FitOnTouch").Set(1)
    made.UpdateVTKObjects()
    manager.RegisterProxy("haptics", "HapticSession", made)
    return made


class _Refusals:
    """Raises a refusal of the session as an exception, in place of a printed error. raises: whether it is of this request."""

    def __init__(self, raises=True):
        self.raises = raises

    def __enter__(self):
        self.session = GetHapticSession()
        self.refused = None
        self.observer = self.session.AddObserver("ErrorEvent", self._note)
        return self.session

    def _note(self, *_):
        self.refused = self.session.GetProblem()  # a proxy that reads the former value back takes the sentence away

    def __exit__(self, kind, *_):
        self.session.RemoveObserver(self.observer)
        if self.refused and self.raises and kind is None:
            raise HapticRefusal(self.refused)


def _put(name, value):
    servermanager.ProxyManager().GetProxy("haptics", "HapticSession").SetPropertyWithName(name, value)


def _value(name):
    value = servermanager.ProxyManager().GetProxy("haptics", "HapticSession").GetPropertyValue(name)
    return value if isinstance(value, (int, float, str)) else list(value)


def _described(name):
    """The row of a setting in the table of settings; None for an unknown name."""
    settings = json.loads(GetHapticSession().GetDescribed())["settings"]
    return next((setting for setting in settings if setting["name"] == name), None)


def _taken(setting):
    """The allowed values of a setting, as text."""
    count = max(len(setting["defaults"]), 1)
    number = "a number" if count == 1 else f"{count} numbers"
    kinds = {"text": "a text", "flag": "1 or 0", "count": "a whole number", "choice": "a whole number", "points": "numbers, three a point"}
    allowed = setting["allowed"] if setting["kind"] != "text" else ""
    return kinds.get(setting["kind"], number) + (f" ({allowed})" if allowed else "")


def _is_number(value):
    return isinstance(value, (int, float))


def _source_name(source):
    """The name in the pipeline browser of a proxy or a name."""
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
    """The given view, or the active one. A view without touchable data is refused."""
    if not hasattr(view, "MakeRenderWindowInteractor") and view is not None:
        raise HapticRefusal(f"{view!r} is not a view; pass the result of CreateView or GetActiveView, or None for the active view.")
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
    """Sets the scene of the session to the data of the view. The panel does this itself, for the active view."""
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
    """Returns the session object, with functions that its proxy lacks: Step(n), SetHandPosition(x, y, z) ..."""
    return _proxy().GetClientSideObject()


def SetHaptics(**settings):
    """Sets properties of the session by name: SetHaptics(Stiffness=300, Radius=0.5)."""
    for name, value in settings.items():
        setting = _described(name)
        if not setting:
            raise HapticRefusal(f"{name} is not a setting of the session; plugin/README.md lists the settings.")
        before = _value(name)
        try:
            with _Refusals():
                _put(name, value)
        except HapticRefusal:
            _put(name, before)  # the property follows the session
            raise
        except (TypeError, RuntimeError):  # so ParaView says that it is of another kind
            _put(name, before)
            raise HapticRefusal(f"{name} takes {_taken(setting)}, not {value!r}.") from None


def Touch(view=None):
    """Touches the visible data of a view (default: the active view). Returns when scene and field are ready."""
    view = _touchable_view(view)
    with _Refusals() as session:
        _follow(view)
        _put("Touching", 1)
        session.FinishScene()
        if session.GetFieldName():
            session.FinishField()
        session.Update()


def TakeColorRange(view=None):
    """Takes data ranges from the colour maps of a view: ranges of stiffness, friction and texture, isovalue (at half of
    the largest opacity) and detent levels of the field. Returns one line per range that was set."""
    view = view or simple.GetActiveView()
    looked_at = vtkHapticViewScene()
    looked_at.SetView(view.SMProxy if view else None)
    said = looked_at.TakeColorRange(_proxy())
    if not said:
        raise HapticRefusal("No touchable source is coloured by its array; colour a source by the array that is felt.")
    return said


def LetGo():
    """Reduces the force to zero within 50 ms and stops touching. Tools and soft bodies are drawn at rest again."""
    scene = _scenes.get(_proxy().GetGlobalIDAsString())
    _put("Touching", 0)
    if scene:
        scene.ShowHanded()


def FitHand(view=None):
    """Sets scale and offset so that the device's workspace contains all visible data of a view (default: the active
    view), before or during a touch."""
    view = _touchable_view(view)
    with _Refusals() as session:
        _follow(view)
        _proxy().InvokeCommand("FitWorkspace")
        session.FinishScene()


def HapticUpdate():
    """Updates the state of the session and, without a panel, the scene from the view."""
    scene = _scenes.get(_proxy().GetGlobalIDAsString())
    if scene:
        scene.Update()
    GetHapticSession().Update()


def HapticState():
    """Returns all read-outs of the session by name: force, contact, state as text ..."""
    HapticUpdate()
    session = GetHapticSession()
    readouts = json.loads(session.GetDescribed())["readouts"]
    return {readout["name"]: getattr(session, "Get" + readout["name"])() for readout in readouts}


def Mark():
    """Sets a mark at the contact and returns the mark, in the format of GetMarks()."""
    with _Refusals():
        HapticUpdate()
        _proxy().InvokeCommand("AddMark")
    return GetMarks()[-1]


def GetMarks():
    """Returns the marks in order, each a dictionary: Source, X, Y, Z and the data at the contact."""
    table = vtkTable()
    GetHapticSession().GetInspection().GetMarksTable(table)
    return _rows(table)


def _rows(table):
    columns = [table.GetColumn(column) for column in range(table.GetNumberOfColumns())]
    return [{column.GetName(): column.GetValue(row) for column in columns} for row in range(table.GetNumberOfRows())]


def Marks():
    """Returns the marks in order, each as (name, (x, y, z)); "" for a mark without a name."""
    return [(mark["Name"], (mark["X"], mark["Y"], mark["Z"])) for mark in GetMarks()]


def AddMark(name="", position=None):
    """Sets a mark at a position of the scene, or at the contact, and gives it a name. Returns the mark as Marks() does."""
    if position is not None and not (len(position) == 3 and all(map(_is_number, position))):
        raise HapticRefusal(f"A position is three numbers, not {position!r}.")
    if position is None:
        Mark()
        if name:
            RenameMark(len(GetMarks()), name)
    else:
        with _Refusals() as session:
            session.GetInspection().AddMarkAt(name, *position)
    return Marks()[-1]


def _mark_index(mark):
    """Of a number from 1, or of a name."""
    names = [name for name, _ in Marks()]
    if isinstance(mark, str) and mark not in names:
        raise HapticRefusal(f"No mark is called {mark!r}; there are {names}.")
    return names.index(mark) if isinstance(mark, str) else int(mark) - 1


def RemoveMark(mark):
    """Removes a mark, by its name or its number from 1. The numbers of later marks decrease."""
    with _Refusals() as session:
        session.GetInspection().RemoveMark(_mark_index(mark))


def RenameMark(mark, name):
    """Names a mark, which is given by its present name or its number from 1."""
    with _Refusals() as session:
        session.GetInspection().RenameMark(_mark_index(mark), name)


def LoadMarks(file):
    """Replaces the marks by those of a csv file that SaveMarks() wrote."""
    with _Refusals() as session:
        session.GetInspection().ReadMarks(os.fspath(file))


def ClearMarks():
    """Removes all marks."""
    _proxy().InvokeCommand("ClearMarks")


def SaveMarks(file):
    """Writes the marks as csv or vtp, by the suffix."""
    if not isinstance(file, (str, os.PathLike)):
        raise HapticRefusal(f"{file!r} is not a file name; use a name that ends in .csv or .vtp.")
    with _Refusals() as session:
        session.GetInspection().WriteMarks(os.fspath(file))


def _in_pipeline(made, **properties):
    """A new source or filter of the plugin: paraview.simple has these only if the plugin was loaded into that namespace."""
    controller = servermanager.ParaViewPipelineController()
    controller.PreInitializeProxy(made)
    simple.SetProperties(made, **properties)
    controller.PostInitializeProxy(made)
    controller.RegisterPipelineProxy(made)
    return made


def MapContact(quantity="Thickness", radius=0.0, view=None):
    """Shows a map of "Thickness" or "Curvature" around the contact, or the last one, in place of the touched source, and
    returns the filter. radius [u] of the map; 0: a tenth of the diagonal of the surface. view: None for the active one."""
    with _Refusals() as session:
        if not session.InspectContact():
            raise HapticRefusal("A map needs a contact: touch a surface first.")
    if quantity not in ("Thickness", "Curvature"):
        raise HapticRefusal(f"A map shows 'Thickness' or 'Curvature', not {quantity!r}.")
    source = simple.FindSource(_source_name(session.GetContactSource()))
    if source.GetDataInformation().GetDataClassName() != "vtkPolyData":
        raise HapticRefusal(f"{session.GetContactSource()} has no polygons of its own: touch the result of ExtractSurface on that source.")
    centre = [0.0, 0.0, 0.0]
    session.GetInspection().GetContactInData(centre)
    made = _in_pipeline(servermanager.filters.MapAroundContact(), Input=source, Quantity=quantity, Centre=centre, Radius=radius)
    simple.Show(made, view)
    simple.Hide(source, view)
    return made


def SetSource(source, touched=None, stiffness=None, friction=None):
    """Sets overrides of one source (a proxy, or its name in the pipeline browser): `touched`, `stiffness` [N/m], and
    `friction` as a pair of static and kinetic coefficients. Omitted arguments keep their values."""
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


def _density(name, density):
    """Of a loose source [kg/m3], or a refusal. Numbers of numpy are real ones."""
    if isinstance(density, bool) or not isinstance(density, numbers.Real) or not 0 < density <= 1e6:
        raise HapticRefusal(f"{name}: a loose source needs a density above 0 and at most 1e6 kg/m3, not {density!r}; "
                            f"for example Touched({name!r}, \"loose\", density=2500).")
    return density


def _put_unit(unit):
    units = _described("SceneUnit")["choices"][1:]  # the first is automatic
    if unit not in units:
        raise HapticRefusal(f"A unit of lengths is one of {', '.join(units)}, not {unit!r}.")
    _put("SceneUnit", units.index(unit) + 1)


def Touched(source, kind="fixed", density=None, unit=None):
    """Has a visible source (a proxy, or its name in the pipeline browser) touched as "fixed", a part of the scene; as
    "loose", a rigid body with the mass of its volume at a density [kg/m3], which falls, slides and is pushed; or as "soft",
    as PressBody() does. unit: of the lengths of the scene, "um", "mm", "cm" or "m"; None: that of the files, or SceneUnit."""
    name = _source_name(source)
    if kind not in ("fixed", "loose", "soft"):
        raise HapticRefusal(f"{name} is touched as 'fixed', 'loose' or 'soft', not {kind!r}.")
    if density is not None and kind != "loose":
        raise HapticRefusal(f"{name}: only a loose source has a density here; omit the density, or touch the source as 'loose'.")
    density = _density(name, density) if kind == "loose" else 0
    with _Refusals(raises=kind == "loose") as session:  # else another source is refused, as LooseText says
        if kind != "fixed" and session.GetSettingText("ToolSource") == name:
            raise HapticRefusal(f"{name} is the tool in the hand; release it with HoldTool(None) before it is touched as {kind!r}.")
        if kind != "soft" and session.GetSettingText("SoftSource") == name:
            _put("SoftSource", "")
        if unit is not None:
            _put_unit(unit)
        session.GetMechanism().SetDensity(name, density)
        HapticUpdate()
        if _value("Touching"):
            session.FinishScene()  # with which a source that cannot be loose is refused
            session.Update()
    if kind == "soft":
        PressBody(source)


def TouchAs(source, kind=None, view=None):
    """Touches a source (a proxy, or its name in the pipeline browser) as "surface", "lines", "field", "tool", "tissue",
    "mechanism" or "not at all"; None: as the kind that is most likely for its data. Returns a sentence with the
    settings that were chosen. The source is shown or hidden in the view (default: the active view) as the kind needs."""
    proxy = simple.FindSource(_source_name(source)).SMProxy
    view = view or simple.GetActiveView()
    touch = vtkHapticTouchAs()
    touch.SetSession(_proxy())
    touch.SetView(view.SMProxy if view else None)
    with _Refusals():
        if not touch.Touch(proxy, kind or touch.GetLikely(proxy)):
            raise HapticRefusal(touch.GetText())
        HapticUpdate()
    return touch.GetText()


def HoldTool(source=None, view=None):
    """Holds the surface of a source (a proxy, or its name in the pipeline browser) as tool; None: the proxy sphere.
    The source is hidden, because the tool is drawn at its pose."""
    name = None if source is None else _source_name(source)
    with _Refusals():
        _put("ToolSource", name or "")
        if name:
            simple.Hide(simple.FindSource(name), view or simple.GetActiveView())
        HapticUpdate()


def PressBody(source=None, rate=None):
    """Makes an output of Soft Body (a proxy, or its name in the pipeline browser) deform under the hand; None: no soft
    body. The view shows the deformation, with the arrays Displacement, Strain and Stress. rate: solver rate [Hz]."""
    name = None if source is None else _source_name(source)
    with _Refusals():
        if rate is not None:
            _put("SoftRate", rate)
        _put("SoftSource", name or "")
        HapticUpdate()


def SoftText(source):
    """Returns the report of a Soft Body, Soft Skin or Haptic Wire proxy: material, assumed values, error of coarse tetrahedra."""
    source.UpdatePipeline()
    source.SMProxy.UpdatePropertyInformation()
    return source.GetPropertyValue("Text")


def HoldMechanism(source=None, turning=None, laws=None):
    """Holds a body of an output of Haptic Mechanism (a proxy, or its name in the pipeline browser); None: no mechanism.
    turning: rotational stiffness between hand and body [N m/rad], 0: free rotation. laws: list of constraints that
    replaces the key `laws` of the scene file, each a dictionary; []: the constraints of the file."""
    name = None if source is None else _source_name(source)
    with _Refusals() as session:
        if turning is not None:
            _put("MechanismTurning", turning)
        if name != session.GetSettingText("MechanismSource"):
            _put("MechanismConstraints", "")  # those of another mechanism would not fit
        _put("MechanismSource", name or "")
        _follow_if_none()
        HapticUpdate()
        if laws is not None:
            _put("MechanismConstraints", json.dumps(laws) if laws else "")
            _put("MechanismConstraints", session.GetSettingText("MechanismConstraints"))  # a refused list is not saved in a state file
            HapticUpdate()


def _follow_if_none():
    """Reads a held mechanism before the first touch, so that its faults are raised by the call that holds it."""
    scene, view = _scenes.get(_proxy().GetGlobalIDAsString()), simple.GetActiveView()
    if (not scene or not scene.GetView()) and hasattr(view, "MakeRenderWindowInteractor"):
        _follow(view)


def Constraints():
    """Returns the constraints of the mechanism in order, each a dictionary with the keys `Constraint` (name), Kind, A, B, Numbers,
    Phase, Force [N], Inside [u]."""
    table = vtkTable()
    GetHapticSession().GetMechanism().GetTable(table)
    return _rows(table)


def _put_laws(laws):
    if laws:
        _put("MechanismConstraints", laws)
        HapticUpdate()


def AddConstraint(**law):
    """Adds a constraint to the mechanism, with the keys of a scene file. A constraint of the same name is replaced. The
    setting MechanismConstraints stores the result."""
    with _Refusals() as session:
        _put_laws(session.GetMechanism().GetConstraintsWith(json.dumps(law)))


def RemoveConstraint(name):
    """Removes a constraint from the mechanism. The setting MechanismConstraints stores the result."""
    with _Refusals() as session:
        _put_laws(session.GetMechanism().GetConstraintsWithout(name))


def BreakConstraint(name):
    """Breaks a constraint from the next tick on, until the mechanism is held or touched anew, or gets other
    constraints."""
    with _Refusals() as session:
        session.GetMechanism().BreakConstraint(name)


def PutBack():
    """Puts the bodies of the mechanism back where the scene file has them: loose bodies at rest, needles outside, and
    broken constraints whole. Loose sources are put back where their data are."""
    with _Refusals() as session:
        session.GetMechanism().PutBack()
        HapticUpdate()


_WIRE_KEYS = {"poisson": "PoissonsRatio", "friction": "Friction", "beams": "Beams", "tip_length": "TipLength", "tip_radius": "TipRadius",
              "tip_pitch": "TipPitch", "tip_young_Pa": "ModulusoftheTip"}
_WIRE_TIPS = ("straight", "angled", "hook", "helix")


def _opened(file):
    try:
        return simple.OpenDataFile(os.path.abspath(file))
    except RuntimeError as error:
        raise HapticRefusal(f"{file} cannot be opened as a vessel: give the file of a surface.") from error


def _refuse_numbers(values):
    for key, value in values.items():
        given = value if isinstance(value, (list, tuple)) else [value]
        if not all(math.isfinite(number) for number in given if isinstance(number, numbers.Real)):
            raise HapticRefusal(f"The {key} of a wire cannot be {value}: give a finite number.")


def PlaceWire(vessel, file="", diameter=0.5, length=250, mouth=(0, 0, 0), direction=(1, 0, 0), centred=False, unit=0.001, young_Pa=None,
              tip="straight", **keys):
    """Returns the filter Haptic Wire, a wire in a vessel, for HoldMechanism(). vessel: a source, or the path of a surface's
    file. file: the filter writes the same as a scene file there, with the vessel beside it as VTP; "": no file. mouth,
    direction: of the sheath. centred: the mouth is moved to the middle of the vessel there. diameter, length: of the wire
    [u], of `unit` metres each. young_Pa: None is 60 GPa, assumed for a NiTi wire. tip: "straight", "angled", "hook" or
    "helix". keys: others that a scene file has for a wire: poisson, friction, beams, tip_length, tip_radius, tip_pitch,
    tip_young_Pa."""
    file = os.path.abspath(file) if file else ""
    if file and not os.path.isdir(os.path.dirname(file)):
        raise HapticRefusal(f"There is no folder {os.path.dirname(file)}: make it, or choose another one for the scene file.")
    _refuse_numbers({"diameter": diameter, "length": length, "mouth": list(mouth), "direction": list(direction), "unit": unit,
                     "young_Pa": young_Pa, **keys})
    unknown = sorted(set(keys) - set(_WIRE_KEYS))
    if unknown or tip not in _WIRE_TIPS:
        raise HapticRefusal(f"{unknown[0]} is no key of a wire: {', '.join(_WIRE_KEYS)}" if unknown
                            else f"{tip!r} is no tip of a wire: {', '.join(_WIRE_TIPS)}")
    source = _opened(vessel) if isinstance(vessel, str) else vessel
    stiffness = {"Material": 0} if young_Pa is None else {"Material": 3, "YoungsModulus": young_Pa}
    wire = _in_pipeline(servermanager.filters.HapticWire(Input=source), Diameter=diameter, Length=length, Unit=unit, Centred=int(centred),
                        Tip=_WIRE_TIPS.index(tip), SceneFile=file, **stiffness, **{_WIRE_KEYS[key]: value for key, value in keys.items()})
    # Behind the defaults, which are of the bounds of the vessel.
    simple.SetProperties(wire, Mouth=list(mouth), Ahead=[m + d for m, d in zip(mouth, direction)])
    wire.UpdatePipeline()
    made = wire.GetDataInformation().GetNumberOfPoints() > 0  # else holding it raises the reason
    if made and file and not os.path.isfile(file):
        raise HapticRefusal(f"{file} cannot be written: choose another folder for the scene file.")
    return wire
