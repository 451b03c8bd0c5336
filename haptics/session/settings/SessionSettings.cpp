// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/settings/SessionSettings.h"

#include <algorithm>
#include <stdexcept>

#include "haptics/field/proxy/FieldPlan.h"
#include "haptics/geometry/mesh/Material.h"

namespace palpate
{
namespace
{

using enum SettingKind;
using enum TakesEffect;

/// Ends of a range that are not there.
constexpr double none = Setting::infinity;
constexpr double largestFriction = Material::largestFriction;

Setting flag(
  std::string_view name, std::string_view title, std::string_view sentence, bool on, TakesEffect effect = NextTick)
{
  return { name, Flag, "", title, sentence, effect, { on ? 1.0 : 0.0 } };
}

Setting choice(std::string_view name, std::string_view title, std::string_view sentence, double number,
  std::vector<std::string_view> choices, TakesEffect effect = NextTick)
{
  return { name, Choice, "", title, sentence, effect, { number }, {}, -none, none, false, std::move(choices) };
}

Setting text(std::string_view name, std::string_view title, std::string_view sentence, TakesEffect effect,
  std::string_view byDefault = {}, std::vector<std::string_view> choices = {})
{
  return { name, Text, "", title, sentence, effect, {}, byDefault, -none, none, false, std::move(choices) };
}

/// Not negative.
Setting amount(std::string_view name, std::string_view unit, std::string_view title, std::string_view sentence,
  double byDefault, double high = none, TakesEffect effect = NextTick)
{
  return { name, Number, unit, title, sentence, effect, { byDefault }, {}, 0.0, high };
}

Setting count(std::string_view name, std::string_view unit, std::string_view title, std::string_view sentence,
  double byDefault, double low, double high = none, TakesEffect effect = NextTick)
{
  return { name, Count, unit, title, sentence, effect, { byDefault }, {}, low, high };
}

/// A setting of two numbers, felt at the ends of an array's data.
Setting pair(std::string_view name, std::string_view unit, std::string_view title, std::string_view sentence,
  std::vector<double> byDefault, double low = -none, double high = none)
{
  return { name, Number, unit, title, sentence, NextScene, std::move(byDefault), {}, low, high };
}

/// A setting with the other places in which it stands.
Setting at(SettingPlaces places, Setting setting)
{
  setting.at = places;
  return setting;
}

/// Default used by Touch Along Path, where it differs from the session's.
Setting along(double path, Setting setting)
{
  setting.alongPath = path;
  return setting;
}

/// Along a path, in virtual time, every value from 0 on is possible.
Setting anyAlongPath(Setting setting)
{
  setting.anyAlongPath = true;
  return setting;
}

constexpr std::string_view ofComponent =
  "Component of the array; -1 is the length of a vector and the value of a scalar";

const Setting settings[] = {
  text("DeviceName", "Device",
    "Device that moves the hand: fed (poses from a program), mouse (the mouse in the view), simulated-…, replay, or an "
    "attached device as pid-…, evdev-… or spacemouse-…",
    NextTouch, "fed"),
  text("Hand", "Held &by", "Simulated hand that holds a simulated device", NextTouch, "stylus",
    { "none", "light", "stylus", "firm" }),
  flag("Wheel", "This is a wheel",
    "Treat the device as a wheel with one motor, whatever its descriptor reports: only the x axis is used. Applies "
    "from the next touch or device check",
    false, NextTouch),
  at({ .field = "safety.deadMan.buttons" },
    count("DeadManButtons", "", "Must be held",
      "Dead-man buttons: force flows only while one of these is pressed. Bit i stands for button i + 1; 0: none", 0,
      0)),
  at({ .field = "safety.deadMan.grip" },
    flag("DeadManGrip", "Must be held",
      "Force flows only while the grip is held, or the safety switch of a joystick that reports one", false)),
  at({ .group = "tool" },
    choice("HoldAlong", "Mouse advances",
      "Axis along which the mouse advances a held tool or mechanism. Automatic: a tool goes against the surface under "
      "the pointer and is not turned, a mechanism along its own axis. Surface normal and view also turn it so that its "
      "axis points there",
      0, { "Automatic", "Own axis", "Surface normal", "View" }, NextFrame)),
  along(1000.0, at({ .field = "stiffness.stiffness_N_per_m", .group = "main", .option = "stiffness" },
                  amount("Stiffness", "N/m", "St&iffness", "Stiffness of the spring between hand and proxy", 500.0))),
  at({ .field = "coupling.damping_Ns_per_m" },
    amount("Damping", "N s/m", "",
      "One-sided damping: brakes a hand that moves into a surface, never one that moves out", 0.0)),
  at({ .field = "contact.radius_u", .group = "main", .option = "radius" },
    amount("Radius", "u", "Radi&us", "Radius of the proxy sphere; 0 is a point proxy", 0.0)),
  at({ .group = "main" }, { "PressDepth", Number, "m", "Mouse goes in by",
                            "Depth to which the mouse in the view presses, as displacement of the hand", NextFrame,
                            { 0.002 }, {}, 5e-5, 0.05 }),
  along(0.0, at({ .group = "contact", .option = "limit-radius" },
               flag("LimitRadius", "No larger than &work allows",
                 "Limit the proxy radius to the largest that can be computed within one tick (see RadiusLimit). Off: "
                 "use the radius as set; the proxy may lag",
                 true))),
  at({ .group = "main", .option = "line-radius" },
    amount("LineRadius", "u", "Radius of lines",
      "Tube radius for lines (streamlines, centre lines, fibres). 0: lines are not touchable", 0.0, none, NextScene)),
  at({ .group = "lines" },
    amount("PointRadius", "u", "Radius of points",
      "Sphere radius for the points of a cloud. 0: points are not touchable", 0.0, none, NextScene)),
  at({ .group = "scene" }, choice("SceneUnit", "Unit of lengths",
                             "Unit of the scene's lengths where the panel shows them, and for the mass of loose "
                             "sources. Automatic: the unit of the files, and u where they have none",
                             0, { "Automatic", "u", "um", "mm", "cm", "m" }, NextFrame)),
  at({ .group = "scene" }, count("ServerLimit", "", "Server whole up to",
                             "Fetch remote surfaces whole up to this many triangles. Of larger surfaces only the "
                             "part around the hand is fetched, again up to this many",
                             100000, 1000, none, NextFrame)),
  along(1.0, at({ .field = "hand.map.scale_u_per_m", .group = "main", .option = "scale" },
               { "Scale", Number, "u/m", "Scale", "Scene units per metre of the hand's motion", NextTick, { 1000.0 },
                 {}, 0.0, none, true })),
  at({ .field = "hand.map.q_WD" }, { "Rotation", Rotation, "", "", "Rotation from the device frame to the scene frame",
                                     NextTick, { 1.0, 0.0, 0.0, 0.0 } }),
  at({ .field = "hand.map.offset_W" },
    { "Offset", Number, "u", "", "Position of the device's origin in the scene", NextTick, { 0.0, 0.0, 0.0 } }),
  flag("FitOnTouch", "",
    "Fit the device's workspace to the scene at every touch, until scale, rotation or offset are set by the user",
    false, NextTouch),
  at({ .group = "main" }, choice("ViewAlignment", "Aligned with view",
                            "Align the device's axes with right, up and towards the viewer of the view's camera, at "
                            "the start of a touch or always. The hand keeps its position. No effect on the mouse",
                            0, { "Off", "On touch", "Always" }, NextFrame)),
  at({ .group = "view" },
    { "PrecisionFactor", Number, "1", "Precision", "Precision mode divides the hand's motion by this factor", NextFrame,
      { 5.0 }, {}, 1.0, 1000.0 }),
  at({ .group = "view" },
    count("PrecisionButton", "", "Precise by button",
      "Device button that activates precision mode while pressed, counted from 1; 0: none", 0, 0, 32, NextFrame)),
  at({ .group = "view" },
    count("ClutchButton", "", "Clutch by button",
      "Device button that decouples the device from the hand while pressed, counted from 1; 0: none", 0, 0, 32,
      NextFrame)),
  at({ .group = "main" },
    flag("ShowWorkspace", "Show workspace", "Draw the device's workspace as a box while touching", false, NextFrame)),
  at({ .field = "contact.shading", .group = "main", .option = "shading" },
    flag("ForceShading", "Smooth forces over facets",
      "Interpolate surface normals so that facets feel smooth. Edges sharper than 30 degrees stay sharp", false)),
  at({ .field = "constant force.force_W", .group = "contact", .option = "constant-force" },
    { "ConstantForce", Number, "N", "Constant force",
      "Constant force on the hand (world frame), limited to the device's largest force. Zero before force is engaged "
      "and while the device holds walls itself",
      NextTick, { 0.0, 0.0, 0.0 } }),
  at({ .group = "main", .option = "mu-static" },
    amount("FrictionStatic", "1", "Static friction",
      "Static friction coefficient: largest tangential force divided by the normal force; 0: no friction", 0.0,
      largestFriction)),
  at({ .group = "main", .option = "mu-kinetic" },
    amount("FrictionKinetic", "1", "Kinetic friction",
      "Kinetic friction coefficient; at most the static coefficient is used", 0.0, largestFriction)),
  at({ .group = "soft" },
    text("SoftSource", "Body",
      "Soft body, made by the filter Soft Body, by its name in the pipeline browser; empty: none", NextScene)),
  anyAlongPath(at({ .group = "soft", .option = "low-rate" },
    { "SoftRate", Number, "Hz", "Computed at",
      "Largest rate of the soft-body and mechanism solver; the actual rate may be lower", NextScene, { 30.0 }, {}, 1.0,
      1000.0 })),
  at({ .group = "mechanism" },
    text("MechanismSource", "Held mechanism",
      "Mechanism, made by Haptic Mechanism, by its name in the pipeline browser; the hand holds one of the bodies. "
      "Empty: none",
      NextScene)),
  text("MechanismConstraints", "",
    "Constraints that replace those of the scene file, as a JSON list in the format of the key 'laws'; empty: "
    "constraints of the scene file",
    NextScene),
  anyAlongPath(at({ .field = "mechanism.turning_N_m_per_rad", .group = "mechanism", .option = "torque-stiffness" },
    { "MechanismTurning", Number, "N m/rad", "Turned with",
      "Rotational stiffness between hand and held body; with the mouse 1 N m/rad or more. 0, or a device without "
      "torque output: the body rotates freely",
      NextTick, { 0.0 }, {}, 0.0, 1000.0 })),
  at({ .field = "mechanism.wireTurn_deg", .group = "mechanism" },
    { "WireTurn", Number, "deg", "Wire turned by",
      "Turn of a held wire about its sheath beside the hand's own rotation; reached at one turn in a second", NextTick,
      { 0.0 }, {}, -36000.0, 36000.0 }),
  at({ .group = "mechanism" }, { "Gravity", Number, "m/s2", "Gravity", "Acceleration of loose sources (world frame)",
                                 NextScene, { 0.0, 0.0, -9.81 }, {}, -100.0, 100.0 }),
  at({ .group = "soft" }, flag("ShowSoftHand", "Show its hand",
                            "Draw a grey ball at the hand position used by the last soft-body solve, next to the hand "
                            "and the proxy. For a mechanism: a ghost of the held body",
                            false, NextFrame)),
  at({ .group = "tool" },
    text("ToolSource", "Held tool",
      "Source whose surface is the tool in the hand, by its name in the pipeline browser; empty: the proxy sphere",
      NextScene)),
  at({ .group = "tool" }, flag("ShowContactForces", "Contact forces",
                            "Draw an arrow at each contact of the tool: the force there on the tool, in one colour for "
                            "each surface or body that is touched",
                            false, NextFrame)),
  at({ .group = "tool" },
    choice("ToolHandle", "Held at",
      "Point of the tool that coincides with the hand: centre of mass, origin of its data, or handle", 0,
      { "Centre of mass", "Origin of its data", "Handle" }, NextScene)),
  at({ .group = "tool" }, { "ToolHandlePoint", Number, "u", "Handle",
                            "Handle, in the tool's own coordinates. Used when the tool is held at its handle",
                            NextScene, { 0.0, 0.0, 0.0 } }),
  at({ .group = "tool" }, { "ToolTipPoint", Number, "u", "Tip",
                            "Tool tip, in the tool's own coordinates. Used when the tool is held at its handle; the "
                            "handle-to-tip distance is the lever arm",
                            NextScene, { 0.0, 0.0, 0.0 } }),
  at({ .group = "tool", .option = "lever" },
    amount("ToolLever", "u", "Lever",
      "Lever arm that converts rotation to translation: rotational stiffness = Stiffness x "
      "(Lever / Scale)^2. 0: the tool's radius of gyration, or the distance from handle to tip",
      0.0, none, NextScene)),
  at({ .field = "tool.coupling", .group = "tool" },
    choice("ToolCoupling", "Felt as",
      "Force on the hand: the contact forces of the tool, without drag while the tool lags, or a spring between hand "
      "and tool, which drags",
      0, { "Contacts", "Spring" })),
  at({ .option = "stiffness-array" },
    text("StiffnessArray", "Stiffness from",
      "Point or cell array mapped to stiffness; surfaces without the array keep their own stiffness", NextScene)),
  at({ .option = "stiffness-component" },
    count("StiffnessComponent", "", "Component", ofComponent, -1, -1, none, NextScene)),
  at({ .option = "stiffness-range" },
    pair("StiffnessDataRange", "", "Data range",
      "Array values mapped to the ends of the stiffness range; equal ends: the array's own range", { 0.0, 0.0 })),
  at({ .option = "stiffness-to" },
    pair("StiffnessFeltRange", "N/m", "Feels like",
      "Stiffness at the ends of the data range, linear between them; never above the session's stiffness",
      { 50.0, 500.0 }, 0.0)),
  at({ .option = "friction-array" },
    text("FrictionArray", "Friction from",
      "Point or cell array mapped to friction; surfaces without the array keep their own friction", NextScene)),
  at({ .option = "friction-component" },
    count("FrictionComponent", "", "Component", ofComponent, -1, -1, none, NextScene)),
  at({ .option = "friction-range" },
    pair("FrictionDataRange", "", "Data range",
      "Array values mapped to the ends of the friction range; equal ends: the array's own range", { 0.0, 0.0 })),
  at({ .option = "friction-to" },
    pair("FrictionFeltRange", "1", "Feels like",
      "Friction coefficient (static and kinetic alike) at the ends of the data range, linear between them",
      { 0.0, 1.0 }, 0.0, largestFriction)),
  at({ .option = "texture-array" },
    text("TextureArray", "Texture from",
      "Point or cell array mapped to height (texture); surfaces without the array keep the shape of their triangles",
      NextScene)),
  at({ .option = "texture-component" },
    count("TextureComponent", "", "Component", ofComponent, -1, -1, none, NextScene)),
  at({ .option = "texture-range" },
    pair("TextureDataRange", "", "Data range",
      "Array values mapped to the ends of the height range; equal ends: the array's own range", { 0.0, 0.0 })),
  at({ .option = "texture-to" },
    pair("TextureFeltRange", "u", "Feels like",
      "Heights at the ends of the data range. The highest point lies on the surface, lower points are hollows; a hand "
      "too fast for the texture feels the mean height",
      { 0.0, 1.0 })),
  at({ .group = "field" }, text("FeltSource", "Field of source",
                             "Name of the source whose values are rendered as a field, visible or hidden; empty: the "
                             "first visible source that has the values",
                             NextScene)),
  text("FieldArray", "Values", "Scalar array of a visible volume, for isosurface and detents; empty: none", NextScene),
  at({ .option = "component" }, count("FieldComponent", "", "Component", ofComponent, -1, -1, none, NextScene)),
  text("FieldVectors", "Directions", "Vector array of a visible volume, for follow and push; empty: none", NextScene),
  at({ .group = "field", .option = "eigenvector" },
    choice("FieldEigenvector", "Eigenvector of",
      "Eigenvector of a symmetric tensor (6 or 9 components) that is used as direction, chosen by its eigenvalue", 0,
      { "Largest", "Middle", "Least" }, NextScene)),
  text("FieldResistance", "Resistance",
    "Scalar array, 0 or more, that scales the drag at the hand; empty: the same drag everywhere", NextScene),
  at({ .option = "compare-with" },
    text("FieldOther", "Compared with", "Array compared with the values; empty: none", NextScene)),
  at({ .group = "field" },
    text("CompareSource", "Compared with source",
      "Name of the source that has the array FieldOther, visible or hidden; empty: the source of the values",
      NextScene)),
  at({ .group = "field", .option = "smoothing" },
    count("FieldSmoothing", "", "Smoothing",
      "Number of times each value is averaged with its neighbours. -1: once, with a notice, where noise above 1/5 "
      "voxel next to the isosurface would trap a hand",
      -1, -1, 8, NextScene)),
  at({ .field = "field.isosurface", .group = "field" },
    flag("FieldIsosurface", "Isosurface", "Render the isosurface at the isovalue as a wall, from both sides", false)),
  at({ .field = "field.isovalue", .group = "field" },
    { "FieldIsovalue", Number, "", "Isovalue",
      "Value of the isosurface; changes move the wall continuously under the hand", NextTick, { 0.0 } }),
  at({ .field = "field.yield_N", .group = "field" },
    amount("FieldYield", "N", "Lets through at",
      "Force at which the isosurface, as a membrane, lets the hand through; 0: a solid wall", 0.0)),
  at({ .field = "field.follow_N", .group = "field" },
    amount(
      "FieldFollow", "N", "Follow", "Largest force that keeps the hand on the streamline through its position", 0.0)),
  at({ .field = "field.drag_N", .group = "field" },
    amount("FieldDrag", "N", "Drag",
      "Largest drag force: opposes every motion, in proportion to the resistance at the hand", 0.0)),
  at({ .field = "field.dragNone", .group = "field" },
    { "FieldDragNone", Number, "", "Drag range min", "Resistance at which the drag is zero", NextTick, { 0.0 } }),
  at({ .field = "field.dragFull", .group = "field" },
    { "FieldDragFull", Number, "", "Drag range max",
      "Value at which the drag reaches full force. A value below 'Drag range min' makes low values drag more", NextTick,
      { 1.0 } }),
  at({ .field = "field.detent_N", .group = "field" },
    amount("FieldDetent", "N", "Detent", "Largest force that holds the hand at a detent level of the values", 0.0)),
  at({ .field = "field.detent.origin", .group = "field", .option = "first-level" },
    { "FieldDetentOrigin", Number, "", "First level",
      "Value of one detent level; the others are 'Between levels' apart", NextTick, { 0.0 } }),
  at({ .field = "field.detent.spacing", .group = "field", .option = "between-levels" },
    { "FieldDetentSpacing", Number, "", "Between levels", "Difference between the values of neighbouring detent levels",
      NextTick, { 1.0 }, {}, 0.0, none, true }),
  at({ .group = "field", .option = "levels" },
    text("FieldDetentLevels", "Chosen levels",
      "Values of up to 16 detent levels, separated by commas, in place of equal distances. Each "
      "level reaches as far as half of 'Between levels'; empty: equal distances",
      NextTick)),
  at({ .field = "field.detent.click", .group = "field", .option = "levels-click" },
    flag("FieldDetentClick", "Levels click",
      "The hand snaps over each level and loses energy. Off: the force is smooth, dissipates nothing, and stays below "
      "the limit at which the hand would jump",
      false)),
  at({ .field = "field.snap_N", .group = "field" },
    amount("FieldSnap", "N", "Snap",
      "Largest force towards the nearest extremum of the values or critical point of the directions", 0.0)),
  at({ .field = "field.snapReach_u", .group = "field", .option = "snap-reach" },
    { "FieldSnapReach", Number, "u", "Snaps from",
      "Distance from which an extremum or critical point attracts the hand", NextTick, { 5.0 }, {}, 0.0, none, true }),
  at({ .group = "field" }, text("SnapSource", "Snaps to source",
                             "Name of a source, visible or hidden, whose points and lines (vortex cores, centre lines) "
                             "attract the hand in place of extrema and critical points",
                             NextScene)),
  at({ .field = "field.compare_N", .group = "field" },
    amount(
      "FieldCompare", "N", "Compare", "Largest force that opposes motion where the two compared arrays differ", 0.0)),
  at({ .field = "field.compareFull", .group = "field", .option = "compare-full" },
    amount("FieldCompareFull", "", "Full at", "Difference at which the opposing force reaches its maximum", 1.0)),
  at({ .field = "field.push_N", .group = "field" },
    amount("FieldPush", "N", "Push",
      "Render the directions as a force of up to this magnitude: a source of energy, limited to 0.5 N; 0: none", 0.0,
      FieldPlan::mostPush_N)),
  at({ .field = "field.fullSpeed", .group = "field", .option = "full-length" },
    amount("FieldFullSpeed", "", "Full at length",
      "Vector length at which follow and push reach full force; 0: full force at any length", 0.0)),
  at({ .field = "stiffness.limitStiffness", .group = "stability" },
    flag("LimitStiffness", "Limit stiffness to the stable range",
      "Limit the stiffness to the largest that device and rate can render stably (LargestStiffness). Off: a wall may "
      "vibrate",
      true)),
  at({ .field = "coupling.passivity.enabled", .group = "stability" },
    flag("Passivity", "&Passivity control",
      "Passivity controller: adds damping so that contact never returns more energy than it absorbed", true)),
  at({ .field = "coupling.passivity.delay_ticks", .group = "stability" },
    count("Delay", "ticks", "Delay",
      "Actuation delay of the device link, in ticks of 1 ms, in addition to the zero-order hold. Simulated links use "
      "the delay from the next touch",
      0, 0, 16)),
  at({ .field = "hand.velocity.method", .group = "stability" },
    choice("VelocityMethod", "Velocity", "Estimator of the hand's velocity from its positions", 2,
      { "Backward difference", "Low pass", "Adaptive window" })),
  at({ .group = "scene" },
    choice("Simplify", "Simpler surfaces",
      "Replace surfaces and lines that are finer than a hand can feel by simpler ones, after a proof that these feel "
      "the same. Auto: from 50,000 triangles, or 64 segments shorter than 1/32 mm of hand motion",
      0, { "Auto", "Off", "On" }, AtOnce)),
  at({ .group = "lines" }, choice("LinesAsWalls", "Lines as walls",
                             "Render lines that lie in a plane as walls, touched by a disc in that plane. Auto: on "
                             "devices that move in a plane",
                             0, { "Auto", "Off", "On" }, NextScene)),
  at({ .group = "lines" }, flag("HoldWalls", "Walls held by the device",
                             "Let a capable device hold up to four walls of a plane world in its own loop, with the "
                             "viscosity that keeps corridors free of vibration",
                             true)),
  { "WallRate", Number, "Hz", "", "Largest update rate of the walls that the device holds", NextTick, { 125.0 }, {},
    20.0, 1000.0 },
  at({ .group = "lines" },
    flag("PlaneGuide", "Led to the plane",
      "Guide the hand to the plane of a plane world with 200 N/m and at most 2 N, increased from zero within 0.5 s",
      true)),
  { "StrokePoints", Points, "u", "", "Path of a simulated hand: a polyline", NextTouch },
  { "StrokeSpeed", Number, "m/s", "", "Speed of a simulated hand along its path", NextTouch, { 0.05 }, {}, 0.0, none,
    true },
  flag("Inspect", "", "Look up the data at the contact with every frame", false, NextFrame),
  count("MarkButton", "", "", "Device button that sets a mark at the contact, counted from 1; 0: none", 0, 0, 32,
    NextFrame),
  text("MarksText", "", "Marks set at contacts, as CSV with a header line, in the format of the source Touch Marks",
    AtOnce),
  text("SourcesText", "",
    "Per-source overrides as CSV: Source, Touched (0/1), Stiffness (inf = session value), FrictionStatic, "
    "FrictionKinetic (-1 = session value); where any source is loose, Density (kg/m3; 0 = fixed)",
    NextScene),
  text("RecordFile", "",
    "File for recordings, from the next touch on; empty: a temporary file until the recording is saved", NextTouch),
  text("ReplayFile", "", "Recording played by the device replay", NextTouch),
  flag(
    "VirtualTime", "", "Virtual time: no servo thread; Step() computes ticks in the calling thread", false, NextTouch),
  { "Recording", Flag, "", "Record",
    "Record the touch, from now on or from the next touch. Off, or the end of the touch, ends the recording", AtOnce,
    { 0 }, {}, -none, none, false, {}, false },
  { "Precision", Flag, "", "Precise", "Precision mode: the same displacement of the device moves the hand less",
    NextFrame, { 0 }, {}, -none, none, false, {}, false },
  { "Clutch", Flag, "", "Clutch",
    "Move the device while the hand stays in place, without force. Off: the hand continues from there", NextFrame,
    { 0 }, {}, -none, none, false, {}, false },
  { "Touching", Flag, "", "T&ouch",
    "Start the device and the servo, and engage force through its ramp. Loading a state never starts a device", AtOnce,
    { 0 }, {}, -none, none, false, {}, false },
};

} // namespace

std::span<const Setting> sessionSettings()
{
  return settings;
}

const Setting* findSetting(std::string_view name)
{
  const auto named = [name](const Setting& setting) { return setting.name == name; };
  const auto found = std::find_if(std::begin(settings), std::end(settings), named);
  return found == std::end(settings) ? nullptr : &*found;
}

const Setting& sessionSetting(std::string_view name)
{
  const Setting* const found = findSetting(name);
  if (!found)
  {
    throw std::logic_error("no setting is called " + std::string(name));
  }
  return *found;
}

} // namespace palpate
