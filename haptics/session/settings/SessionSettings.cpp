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
  amount(
    "PointRadius", "u", "", "Balls as which the points of a cloud are touched; 0: they are not", 0.0, none, NextScene),
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
  at({ .field = "contact.shading", .group = "contact", .option = "shading" },
    flag("ForceShading", "Smoot&h forces over facets",
      "Forces as if the surface were round between its corners; edges sharper than 30 degrees stay", false)),
  at({ .field = "constant force.force_W", .group = "contact", .option = "constant-force" },
    { "ConstantForce", Number, "N", "Constant force",
      "The same force on the hand everywhere, in W, shortened to the largest force; none before force is engaged, and "
      "none while the device holds walls",
      NextTick, { 0.0, 0.0, 0.0 } }),
  at({ .field = "field.isosurface" },
    flag("FieldIsosurface", "", "The surface where the field's scalar has FieldIsovalue is a wall from both sides",
      false)),
  at({ .field = "field.isovalue" },
    { "FieldIsovalue", Number, "", "",
      "Value of the scalar on that surface; while it changes the surface moves under the hand without a step", NextTick,
      { 0.0 } }),
  at({ .field = "field.yield_N" },
    amount("FieldYield", "N", "", "Force at which that surface gives way, as a membrane; 0: a wall", 0.0)),
  at({ .field = "field.follow_N" },
    amount("FieldFollow", "N", "", "Holds the hand on the line of the field's vectors that it is on; 0: off", 0.0)),
  at({ .field = "field.drag_N" },
    amount("FieldDrag", "N", "", "Resists every motion, times the field's resistance where it has one; 0: off", 0.0)),
  at({ .field = "field.detent_N" },
    amount("FieldDetent", "N", "", "Levels of the scalar at equal distances hold the hand; 0: off", 0.0)),
  at({ .field = "field.detent.spacing" },
    { "FieldDetentSpacing", Number, "", "", "From level to level, in values of the scalar", NextTick, { 1.0 }, {}, 0.0,
      none, true }),
  at({ .field = "field.detent.origin" },
    { "FieldDetentOrigin", Number, "", "", "Value of one of these levels", NextTick, { 0.0 } }),
  at({ .field = "field.detent.click" },
    flag("FieldDetentClick", "", "A level holds until its strength and then lets go; off: levels are smooth hollows",
      false)),
  at({ .field = "field.snap_N" },
    amount("FieldSnap", "N", "", "Pulls to the nearest of the field's places, extrema say; 0: off", 0.0)),
  at({ .field = "field.snapReach_u" },
    { "FieldSnapReach", Number, "u", "", "How far such a place reaches", NextTick, { 5.0 }, {}, 0.0, none, true }),
  at({ .field = "field.compare_N" },
    amount("FieldCompare", "N", "", "Resists every motion where the field's two scalars differ; 0: off", 0.0)),
  at({ .field = "field.compareFull" },
    amount("FieldCompareFull", "", "", "Difference at which it does with all of its strength", 1.0)),
  at({ .field = "field.push_N" }, amount("FieldPush", "N", "",
                                    "The field's vectors push the hand: a source of energy, whose power is told; none "
                                    "before force is engaged; 0: off",
                                    0.0, FieldPlan::mostPush_N)),
  at({ .group = "friction", .option = "mu-static" },
    amount("FrictionStatic", "1", "Static",
      "Friction that holds at rest: force along the surface over force into it; 0 is none", 0.0, largestFriction)),
  at({ .group = "friction", .option = "mu-kinetic" },
    amount("FrictionKinetic", "1", "Kinetic", "Friction while it slides; no more than the static one is used", 0.0,
      largestFriction)),
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
  text("RecordFile", "", "File that receives the recording while touching", NextTouch),
  text("ReplayFile", "", "Recording that the device replay plays", NextTouch),
  flag("VirtualTime", "", "Nothing runs by itself: Step computes ticks, in the thread that calls it", false, NextTouch),
  { "Touching", Flag, "", "&Touch",
    "Device on, servo on and force engaged through its ramp; loading a state never moves a device", AtOnce, { 0 }, {},
    -none, none, false, {}, false },
};

} // namespace

std::span<const Setting> sessionSettings()
{
  return settings;
}

const Setting& sessionSetting(std::string_view name)
{
  const auto named = [name](const Setting& setting) { return setting.name == name; };
  const auto found = std::find_if(std::begin(settings), std::end(settings), named);
  if (found == std::end(settings))
  {
    throw std::logic_error("no setting is called " + std::string(name));
  }
  return *found;
}

} // namespace palpate
