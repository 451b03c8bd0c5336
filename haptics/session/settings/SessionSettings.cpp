// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/settings/SessionSettings.h"

#include <algorithm>
#include <stdexcept>

#include "haptics/field/FieldPlan.h"
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

/// What the ends of an array's data feel like.
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

/// Whoever feels along a path in the scene begins with another value than a session.
Setting along(double path, Setting setting)
{
  setting.alongPath = path;
  return setting;
}

constexpr std::string_view ofComponent =
  "Component of the array; -1 is the length of a vector and the value of a scalar";

const Setting settings[] = {
  text("DeviceName", "&Device",
    "Who moves the hand: fed (poses from a program), mouse (the mouse in the view), simulated-…, replay, or what is "
    "plugged in as pid-…, evdev-… or spacemouse-…",
    NextTouch, "fed"),
  text("Hand", "Held &by", "Who holds a simulated device", NextTouch, "stylus", { "none", "light", "stylus", "firm" }),
  flag("Wheel", "This is a wheel",
    "The device is one motor that turns, whatever it calls itself: only its x is there, from the next touch or check "
    "on",
    false, NextTouch),
  at({ .field = "safety.deadMan.buttons" },
    count("DeadManButtons", "", "&Must be held",
      "Buttons of which one must be held to be pushed: bit i stands for button i + 1; 0 is none", 0, 0)),
  at({ .field = "safety.deadMan.grip" },
    flag("DeadManGrip", "&Must be held",
      "The grip, or the safety switch of a joystick that reports one, must be held for the hand to be pushed", false)),
  { "PressDepth", Number, "m", "Mouse &goes in by", "How deep the mouse in the view presses, as a way of the hand",
    NextFrame, { 0.002 }, {}, 5e-5, 0.05 },
  along(1000.0, at({ .field = "stiffness.stiffness_N_per_m", .group = "main", .option = "stiffness" },
                  amount("Stiffness", "N/m", "&Stiffness", "Spring between hand and proxy", 500.0))),
  at({ .field = "coupling.damping_Ns_per_m" },
    amount("Damping", "N s/m", "", "One-sided damping: it brakes a hand that goes in, never one that leaves", 0.0)),
  at({ .field = "contact.radius_u", .group = "main", .option = "radius" },
    amount("Radius", "u", "&Radius", "Ball that touches; 0 is a point", 0.0)),
  along(0.0,
    at({ .group = "contact", .option = "limit-radius" },
      flag("LimitRadius", "No larger than &work allows",
        "The ball is at most as large as finishes its work in a tick (RadiusLimit); off: as asked for, and it may lag",
        true))),
  at({ .group = "contact", .option = "line-radius" },
    amount("LineRadius", "u", "Radius of li&nes",
      "Tubes as which lines (streamlines, centre lines, fibres) are touched; 0: they are not", 0.0, none, NextScene)),
  at({ .group = "contact" },
    amount("PointRadius", "u", "Radius of points", "Balls as which the points of a cloud are touched; 0: they are not",
      0.0, none, NextScene)),
  at({ .group = "contact" }, count("ServerLimit", "", "Server whole up to",
                               "Triangles up to which a surface of a server is fetched whole; of a larger one what is "
                               "around the hand is, no more "
                               "than as many",
                               100000, 1000, none, NextFrame)),
  along(1.0, at({ .field = "hand.map.scale_u_per_m", .group = "contact", .option = "scale" },
               { "Scale", Number, "u/m", "S&cale", "Scene units per metre of the hand's motion", NextTick, { 1000.0 },
                 {}, 0.0, none, true })),
  at({ .field = "hand.map.q_WD" },
    { "Rotation", Rotation, "", "", "From device to scene frame", NextTick, { 1.0, 0.0, 0.0, 0.0 } }),
  at({ .field = "hand.map.offset_W" },
    { "Offset", Number, "u", "", "Where the device's origin is in the scene", NextTick, { 0.0, 0.0, 0.0 } }),
  flag("FitOnTouch", "",
    "The hand is fitted to the scene whenever touching begins, until scale, rotation or offset are set by hand", false,
    NextTouch),
  at({ .group = "view" },
    choice("ViewAlignment", "Aligned with view",
      "Right, up and towards of the device are those of the view's camera, the hand stays where it is: when touching "
      "begins, or always; not for the mouse",
      0, { "Off", "On touch", "Always" }, NextFrame)),
  at({ .group = "view" },
    { "PrecisionFactor", Number, "1", "Precision", "By how much the same way of the device is less while precise is on",
      NextFrame, { 5.0 }, {}, 1.0, 1000.0 }),
  at({ .group = "view" },
    count("PrecisionButton", "", "Precise by button",
      "Button of the device that makes the hand precise while it is held, from 1 on; 0 is none", 0, 0, 32, NextFrame)),
  at({ .group = "view" },
    count("ClutchButton", "", "Clutch by button",
      "Button of the device with which the device is moved and the hand is not, from 1 on; 0 is none", 0, 0, 32,
      NextFrame)),
  at({ .group = "view" }, flag("ShowWorkspace", "Show workspace",
                            "The box of what the device reaches is drawn while it touches", false, NextFrame)),
  at({ .field = "contact.shading", .group = "contact", .option = "shading" },
    flag("ForceShading", "Smoot&h forces over facets",
      "Forces as if the surface were round between its corners; edges sharper than 30 degrees stay", false)),
  at({ .field = "constant force.force_W", .group = "contact", .option = "constant-force" },
    { "ConstantForce", Number, "N", "Constant force",
      "The same force on the hand everywhere, in W, shortened to the largest force; none before force is engaged, and "
      "none while the device holds walls",
      NextTick, { 0.0, 0.0, 0.0 } }),
  at({ .group = "friction", .option = "mu-static" },
    amount("FrictionStatic", "1", "Static",
      "Friction that holds at rest: force along the surface over force into it; 0 is none", 0.0, largestFriction)),
  at({ .group = "friction", .option = "mu-kinetic" },
    amount("FrictionKinetic", "1", "Kinetic", "Friction while it slides; no more than the static one is used", 0.0,
      largestFriction)),
  text("SoftSource", "",
    "Source that gives way, made by the filter Soft Body, by its name in the pipeline browser; empty: none", NextScene),
  at({ .group = "soft" },
    { "SoftRate", Number, "Hz", "Computed at", "How often what gives way is computed, or as often as can be", NextScene,
      { 30.0 }, {}, 1.0, 1000.0 }),
  text("MechanismSource", "",
    "Mechanism that the hand holds a body of, made by Haptic Mechanism, by its name in the pipeline browser; empty: "
    "none",
    NextScene),
  text("MechanismLaws", "",
    "Laws of the mechanism in place of those of its scene file, a list as in that; empty: those", NextScene),
  at({ .field = "mechanism.turning_N_m_per_rad", .group = "mechanism" },
    { "MechanismTurning", Number, "N m/rad", "Turned with",
      "How stiffly the hand turns what it holds of a mechanism; 0: that turns freely, and so it does with a device "
      "without torque",
      NextTick, { 0.0 }, {}, 0.0, 1000.0 }),
  at({ .group = "soft" }, flag("ShowSoftHand", "Show its hand",
                            "Where the hand was when what gives way, a mechanism's bodies too, was computed last is "
                            "drawn: a grey ball, beside "
                            "that of the hand and the one that touches, or the ghost of the hand and what it holds",
                            false, NextFrame)),
  text("ToolSource", "",
    "Source whose surface the hand holds in place of the ball, by its name in the pipeline browser; empty: the ball",
    NextScene),
  at({ .group = "tool" },
    choice("ToolHandle", "Held at",
      "What of the tool is where the hand is: its centre of mass, its data's origin, or its handle", 0,
      { "Centre of mass", "Origin of its data", "Handle" }, NextScene)),
  at({ .group = "tool" },
    { "ToolHandlePoint", Number, "u", "Handle", "Where the hand holds a tool that is held at its handle, in its data",
      NextScene, { 0.0, 0.0, 0.0 } }),
  at({ .group = "tool" },
    { "ToolTipPoint", Number, "u", "Tip",
      "What a tool that is held at its handle works with, in its data; the lever is the way from handle to tip",
      NextScene, { 0.0, 0.0, 0.0 } }),
  at({ .group = "tool" },
    amount("ToolLever", "u", "Lever",
      "Way that a turn of the tool by a radian counts as: turning is as stiff as the spring times its square, as the "
      "hand goes; 0: the tool's own, or the way from handle to tip",
      0.0, none, NextScene)),
  at({ .field = "tool.coupling", .group = "tool" },
    choice("ToolCoupling", "Felt as",
      "What the tool touches: no drag while it lags; or a spring from the hand to the tool, which drags", 0,
      { "Contacts", "Spring" })),
  text("StiffnessArray", "Stiffn&ess from",
    "Array of points or cells that gives the stiffness; surfaces without it keep their own", NextScene),
  count("StiffnessComponent", "", "Component", ofComponent, -1, -1, none, NextScene),
  pair("StiffnessDataRange", "", "Data range",
    "Values of the array between which the stiffness changes; equal ends: the array's own range", { 0.0, 0.0 }),
  pair("StiffnessFeltRange", "N/m", "Feels like",
    "Stiffness at the ends of the data range, linear between; never more than the spring's", { 100.0, 1000.0 }, 0.0),
  text("FrictionArray", "Friction from",
    "Array of points or cells that gives the friction; surfaces without it keep their own", NextScene),
  count("FrictionComponent", "", "Component", ofComponent, -1, -1, none, NextScene),
  pair("FrictionDataRange", "", "Data range",
    "Values of the array between which the friction changes; equal ends: the array's own range", { 0.0, 0.0 }),
  pair("FrictionFeltRange", "1", "Feels like",
    "Friction at the ends of the data range, linear between, at rest and sliding alike", { 0.0, 1.0 }, 0.0,
    largestFriction),
  text("TextureArray", "Te&xture from",
    "Array of points or cells that gives heights; surfaces without it are as their triangles are", NextScene),
  count("TextureComponent", "", "Component", ofComponent, -1, -1, none, NextScene),
  pair("TextureDataRange", "", "Data range",
    "Values of the array between which the height changes; equal ends: the array's own range", { 0.0, 0.0 }),
  pair("TextureFeltRange", "u", "Feels like",
    "Heights at the ends of the data range: the highest place is the surface itself, lower ones are hollows; their "
    "mean under a hand too fast for them",
    { 0.0, 1.0 }),
  at({ .group = "field" },
    text("FeltSource", "Field of source",
      "Name of the source whose values are felt, shown or not; empty: the first that is shown and has them",
      NextScene)),
  text("FieldArray", "V&alues",
    "Array of numbers in space, of what is shown, that is felt: isosurface, detents; empty: none", NextScene),
  at({ .option = "component" }, count("FieldComponent", "", "Component", ofComponent, -1, -1, none, NextScene)),
  text("FieldVectors", "Directions", "Array of directions in space: follow, push; empty: none", NextScene),
  at({ .group = "field", .option = "eigenvector" },
    choice("FieldEigenvector", "Eigenvector of",
      "Directions of a symmetric tensor (6 or 9 components): the eigenvector of which of its eigenvalues is followed",
      0, { "Largest", "Middle", "Least" }, NextScene)),
  text("FieldResistance", "Resistance",
    "Array of numbers that says how strong the drag is where the hand is, from 0 on; empty: the same everywhere",
    NextScene),
  text("FieldOther", "Compared with", "Array that the values are compared with; empty: none", NextScene),
  at({ .group = "field" },
    text("CompareSource", "Compared with source",
      "Name of the source whose array FieldOther is, in which it need not be shown; empty: that of the values",
      NextScene)),
  at({ .group = "field", .option = "smoothing" },
    count("FieldSmoothing", "", "Smoothing",
      "Times that each value is averaged with its neighbours before it is felt; -1: once where noise "
      "of more than a fifth of a voxel beside the isosurface would trap a hand, which is said",
      -1, -1, 8, NextScene)),
  at({ .field = "field.isosurface", .group = "field" },
    flag("FieldIsosurface", "Isosurface", "The surface where the values are the isovalue is a wall from both sides",
      false)),
  at({ .field = "field.isovalue", .group = "field" },
    { "FieldIsovalue", Number, "", "Isovalue", "Value of that surface; it moves under the hand without a step",
      NextTick, { 0.0 } }),
  at({ .field = "field.yield_N", .group = "field" },
    amount("FieldYield", "N", "Gives way at",
      "Above 0 the surface is a membrane that lets the hand through at this force", 0.0)),
  at({ .field = "field.follow_N", .group = "field" },
    amount("FieldFollow", "N", "Follow",
      "Holds the hand on the streamline of the directions that it is on; no more than this force", 0.0)),
  at({ .field = "field.drag_N", .group = "field" },
    amount("FieldDrag", "N", "Drag", "Resists every motion, times the resistance at the hand; no more than this force",
      0.0)),
  at({ .field = "field.dragNone", .group = "field" },
    { "FieldDragNone", Number, "", "No drag at", "Resistance of which nothing is felt", NextTick, { 0.0 } }),
  at({ .field = "field.dragFull", .group = "field" },
    { "FieldDragFull", Number, "", "Full drag at",
      "Resistance at which the drag has all of its force; below that of which nothing is felt, less resists more",
      NextTick, { 1.0 } }),
  at({ .field = "field.detent_N", .group = "field" },
    amount("FieldDetent", "N", "Detent", "Levels of the values hold the hand; no more than this force", 0.0)),
  at({ .field = "field.detent.origin", .group = "field", .option = "first-level" },
    { "FieldDetentOrigin", Number, "", "First level", "One of the values that hold the hand", NextTick, { 0.0 } }),
  at({ .field = "field.detent.spacing", .group = "field", .option = "between-levels" },
    { "FieldDetentSpacing", Number, "", "Between levels", "Difference of the values from one level to the next",
      NextTick, { 1.0 }, {}, 0.0, none, true }),
  at({ .group = "field" },
    text("FieldDetentLevels", "Chosen levels",
      "Values that hold the hand instead, with commas between them, 16 at most; each as far around as half of the "
      "difference between levels; empty: levels at equal distances",
      NextTick)),
  at({ .field = "field.detent.click", .group = "field", .option = "levels-click" },
    flag("FieldDetentClick", "Levels click",
      "The hand snaps over each level and loses energy; off: smooth, loses none, and never stronger than holds it "
      "without a jump",
      false)),
  at({ .field = "field.snap_N", .group = "field" },
    amount("FieldSnap", "N", "Snap",
      "Pulls to the nearest extremum of the values and critical point of the directions; no more than this force",
      0.0)),
  at({ .field = "field.snapReach_u", .group = "field", .option = "snap-reach" },
    { "FieldSnapReach", Number, "u", "Snaps from", "How far such a place reaches", NextTick, { 5.0 }, {}, 0.0, none,
      true }),
  at({ .group = "field" }, text("SnapSource", "Snaps to source",
                             "Name of a source, shown or not, to whose points and lines the hand snaps instead: cores "
                             "of vortices, centre lines",
                             NextScene)),
  at({ .field = "field.compare_N", .group = "field" },
    amount("FieldCompare", "N", "Compare",
      "Resists motion where values and those compared with differ; no more than this force", 0.0)),
  at({ .field = "field.compareFull", .group = "field", .option = "compare-full" },
    amount("FieldCompareFull", "", "Full at", "Difference from which on it resists with all of that force", 1.0)),
  at({ .field = "field.push_N", .group = "field" },
    amount("FieldPush", "N", "Push", "The directions are a force: a source of energy, 0.5 N at most; 0: none", 0.0,
      FieldPlan::mostPush_N)),
  at({ .field = "field.fullSpeed", .group = "field", .option = "full-length" },
    amount("FieldFullSpeed", "", "Full at length",
      "Length of the directions from which on they are followed and push with all strength; 0: any", 0.0)),
  at({ .field = "stiffness.limitStiffness", .group = "stability" },
    flag("LimitStiffness", "L&imit stiffness to what the device can hold",
      "No stiffer than the device and the rate can hold (LargestStiffness); off: a wall may shake", true)),
  at({ .field = "coupling.passivity.enabled", .group = "stability" },
    flag("Passivity", "&Passivity control",
      "Damps the spring as much as a held force would otherwise give back more than it took", true)),
  at({ .field = "coupling.passivity.delay_ticks", .group = "stability" },
    count("Delay", "ticks", "Delay",
      "Ticks of 1 ms between a force and its effect beyond the hold itself: what is known of the device's link; a "
      "simulated link has that delay from the next touch on",
      0, 0, 16)),
  at({ .field = "hand.velocity.method", .group = "stability" },
    choice("VelocityMethod", "Velocity", "How the hand's velocity is made from its positions", 2,
      { "Backward difference", "Low pass", "Adaptive window" })),
  at({ .group = "scene" },
    choice("Simplify", "Simpler s&urfaces",
      "Surfaces and lines finer than a hand feels are replaced by simpler ones once those are proven to feel the same; "
      "auto: from 50,000 triangles, or 64 segments shorter than 1/32 mm in the hand, on",
      0, { "Auto", "Off", "On" }, AtOnce)),
  at({ .group = "scene" },
    choice("LinesAsWalls", "Lines as walls",
      "Lines that lie in a plane are walls across it, felt in that plane by a disc; auto: on devices that move in a "
      "plane",
      0, { "Auto", "Off", "On" }, NextScene)),
  at({ .group = "scene" },
    flag("HoldWalls", "Walls held by the device",
      "A device that can holds at most four walls of a plane world itself, with the viscosity that keeps corridors "
      "still",
      true)),
  { "WallRate", Number, "Hz", "", "How often held walls are moved on at most", NextTick, { 125.0 }, {}, 20.0, 1000.0 },
  at({ .group = "scene" },
    flag("PlaneGuide", "Led to the plane",
      "The hand is led to the plane of a plane world by 200 N/m and at most 2 N, from nothing within half a second",
      true)),
  { "StrokePoints", Points, "u", "", "Where a simulated hand is led: a polyline", NextTouch },
  { "StrokeSpeed", Number, "m/s", "", "Speed of the stroke of a simulated hand", NextTouch, { 0.05 }, {}, 0.0, none,
    true },
  flag("Inspect", "", "What is at the contact is looked up with every picture", false, NextFrame),
  count("MarkButton", "", "", "Button of the device that sets a mark at the contact, from 1 on; 0 is none", 0, 0, 32,
    NextFrame),
  text("MarksText", "",
    "The marks that were set at contacts, as comma-separated text with a header line, as the source Touch Marks takes "
    "it",
    AtOnce),
  text("SourcesText", "",
    "Sources that are not touched, or in a way of their own, as comma-separated text: Source, Touched (0 or 1), "
    "Stiffness (inf: the session's), FrictionStatic and FrictionKinetic (-1: the session's)",
    NextScene),
  text("RecordFile", "",
    "File that receives what is recorded, from the beginning of a touch on; none: recordings go to a temporary file "
    "until they are saved",
    NextTouch),
  text("ReplayFile", "", "Recording that the device replay plays", NextTouch),
  flag("VirtualTime", "", "Nothing runs by itself: Step computes ticks, in the thread that calls it", false, NextTouch),
  { "Recording", Flag, "", "Record",
    "What is touched is recorded, from now on or with the next touch; off: the recording ends, as it does with the "
    "touch",
    AtOnce, { 0 }, {}, -none, none, false, {}, false },
  { "Precision", Flag, "", "Precise", "The same way of the device is a shorter one of the hand", NextFrame, { 0 }, {},
    -none, none, false, {}, false },
  { "Clutch", Flag, "", "Clutch",
    "The device is moved and the hand stays where it is, without force; off: it goes on from there", NextFrame, { 0 },
    {}, -none, none, false, {}, false },
  { "Touching", Flag, "", "&Touch",
    "Device on, servo on and force engaged through its ramp; loading a state never moves a device", AtOnce, { 0 }, {},
    -none, none, false, {}, false },
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
