// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/settings/SessionSettings.h"

namespace palpate
{

namespace readout_table // whose names of kinds are not those of the settings
{

using enum Readout::Kind;

const Readout readouts[] = {
  { "DeviceKind", Text, "", "", "What the chosen device is" },
  { "DeviceNotes", Text, "", "", "Why it cannot be used, and what it cannot do" },
  { "LinkText", Text, "", "",
    "The link to a USB device: reports a second, effects renewed before they end, writes that hung, losses, reports "
    "that are none" },
  { "LargestStiffness", Number, "N/m", "",
    "How stiff a wall the chosen device can hold; known before it is touched; infinite where nothing is known to "
    "limit "
    "it" },
  { "StabilitySentence", Text, "", "", "The same, and why" },
  { "StateText", Text, "", "State",
    "safe: no force; armed: waits for a free start; engaged: force flows; fault: no force" },
  { "FaultText", Text, "", "", "Why there is no force, and what to do" },
  { "Warning", Text, "", "", "What needs attention without being a fault, and what to do" },
  { "RecordingText", Text, "", "", "What is recorded, or was, where it is, and what can be done with it" },
  { "RecordedFile", Text, "", "", "The last recording that is whole" },
  { "Problem", Text, "", "", "The last thing that was refused, and why" },
  { "ProxyPosition", Number, "u", "", "Where the proxy is, in W", 3 },
  { "Force", Number, "N", "", "Force on the hand, in W", 3 },
  { "ForceMagnitude", Number, "N", "Force", "Size of the force on the hand now" },
  { "PeakForce", Number, "N", "Force", "The largest so far" },
  { "Depth", Number, "u", "", "How deep the hand is behind the proxy" },
  { "StiffnessUsed", Number, "N/m", "Stiffness", "Stiffness of the spring now, after every limit" },
  { "StiffnessLimited", Flag, "", "Stiffness",
    "Whether that is less than was set because the device or the rate cannot hold it" },
  { "RadiusLimit", Number, "u", "",
    "The largest ball whose work fits into a tick, counted with each new scene; infinite where any does" },
  { "RadiusUsed", Number, "u", "", "The ball that touches" },
  { "DeliveredEnergy", Number, "J", "Energy", "Net work on the hand, negative when taken from it" },
  { "ExcessEnergy", Number, "J", "Energy", "What this contact has given more than its spring holds, now" },
  { "PeakExcessEnergy", Number, "J", "Energy", "The most of that so far" },
  { "StabiliserForce", Number, "N", "Stabiliser",
    "The part of the force that passivity control added, now; none in free air" },
  { "PeakStabiliserForce", Number, "N", "Stabiliser", "The largest of that so far" },
  { "ForceResidual", Number, "N", "",
    "The largest difference between the force and that of spring and stabiliser, of ticks whose force nothing "
    "limited" },
  { "FrictionText", Text, "", "Friction", "sticks or slips; none without contact or friction" },
  { "FrictionKineticUsed", Number, "1", "Friction", "Kinetic friction, no more than the static one" },
  { "Contacts", Count, "", "Contact", "Planes that push now" },
  { "MechanismText", Text, "", "", "What the mechanism becomes, or why it cannot be felt" },
  { "MechanismDepth", Number, "u", "", "The hand's way along what it holds of a mechanism since nothing pushed" },
  { "SoftText", Text, "", "",
    "What gives way and how it is modelled, computed and strained, or why it does not; empty: none is asked for" },
  { "SoftStrain", Number, "1", "", "The largest strain in it, |F - 1|: from 0.1 a linear law is off by some 10 %" },
  { "SoftPackets", Number, "Hz", "", "How often it is computed" },
  { "SoftAge", Number, "s", "", "How old what is felt of it is" },
  { "SoftHandPosition", Number, "u", "",
    "Where the hand was when it, or a mechanism's bodies, was computed last, in W; now where there is none", 3 },
  { "ToolText", Text, "", "", "Which tool is held and how it is, or why none is; empty: none is asked for" },
  { "ToolContacts", Text, "", "", "What pushes the tool, a line each: source, place in W, share of all pushes" },
  { "ToolPose", Number, "", "",
    "Where the tool, or what is held of a mechanism, is: the origin of its data in W [u], and its turn (w, x, y, z)",
    7 },
  { "ToolHandPose", Number, "", "", "Where the hand would have it, likewise", 7 },
  { "ToolTip", Number, "u", "", "Where the tip of a tool is that is held at its handle, in W", 3 },
  { "ToolTorque", Number, "N m", "", "Torque that the tool asks for at the hand, in W; a device may give less", 3 },
  { "Torque", Number, "N m", "", "Torque on the hand, in W", 3 },
  { "ContactText", Text, "", "", "What is touched and what is there, in a line; empty without a contact" },
  { "ContactSource", Text, "", "", "Name of the source that is touched" },
  { "ContactCell", LongCount, "", "", "Its cell at the contact; -1 without" },
  { "ContactPoint", LongCount, "", "", "The point of that cell that counts most there; -1 without" },
  { "ContactPosition", Number, "u", "", "Place of the contact, in W", 3 },
  { "ContactNormal", Number, "1", "", "Unit normal there, to the side of the proxy, in W", 3 },
  { "ContactCurvature", Number, "1/u", "",
    "Largest and least curvature there, above 0 where it bulges towards the hand; not a number where it is not known",
    2 },
  { "ContactThickness", Number, "u", "",
    "How thick the wall behind it is, straight in; not a number where none is met. Not for clinical use" },
  { "ContactArrays", Text, "", "", "All arrays there, a line each" },
  { "NumberOfMarks", Count, "", "", "Marks that were set" },
  { "MarksNote", Text, "", "", "Which marks are stale, for what they were set on has changed since; a line each" },
  { "ContactSeconds", Number, "s", "Contact", "Time in contact" },
  { "MotionLag", Number, "s", "Motion lag",
    "How late moving surfaces are felt: the time between the last two pictures of them; 0 at rest" },
  { "Rate", Number, "Hz", "Rate", "Ticks per second" },
  { "LatenessP50", Number, "us", "Late p50/p99", "How late ticks start, median" },
  { "LatenessP99", Number, "us", "Late p50/p99", "How late ticks start, 99th percentile" },
  { "CostP50", Number, "us", "Cost p50/p99/p99.9", "How long a tick takes, median" },
  { "CostP99", Number, "us", "Cost p50/p99/p99.9", "How long a tick takes, 99th percentile" },
  { "CostP999", Number, "us", "Cost p50/p99/p99.9", "How long one tick in a thousand takes at least" },
  { "Ticks", LongCount, "", "Ticks", "Ticks computed" },
  { "Missed", LongCount, "", "Ticks", "Periods that passed without a tick; they are never caught up" },
  { "Periods", LongCount, "", "", "Both together" },
  { "CappedTicks", LongCount, "", "", "Ticks that met a limit of their work" },
  { "FieldValue", Number, "", "", "Of the field's values at the hand; not a number where there is none" },
  { "FieldGradient", Number, "1/u", "", "How those change there, in W", 3 },
  { "FieldPushPower", Number, "mW", "", "Power that the directions give the hand as a force, now" },
  { "FieldTicksBeyond", LongCount, "", "", "Ticks in which the hand was beyond the numbers that were there around it" },
  { "FieldError", Number, "1", "",
    "Largest difference found between those numbers and the data's own cells, of their range; 0: they are the data's" },
  { "FieldAge", Number, "s", "", "Since when those numbers are felt" },
  { "FieldSentence", Text, "", "",
    "Which numbers are felt as a field, how finely and how far around the hand, or why none are" },
  { "ServerSentence", Text, "", "",
    "Which surfaces of a server are felt, and of each whether it is whole or what is around the hand; empty: none" },
  { "ServerAge", Number, "s", "", "How long ago that was fetched" },
  { "ServerTicksBeyond", LongCount, "", "",
    "Ticks without force because the hand was beyond what is there of them, or the server did not answer" },
  { "SchedulingReport", Text, "", "", "What the operating system granted the servo, and why" },
  { "PlanSentence", Text, "", "",
    "What is felt of the scene and why: how many triangles or segments, by a point or a ball, with what friction, "
    "through a tree or a list" },
  { "SceneProgress", Number, "1", "",
    "How much of what is shown is ready to be touched: 0 while it is read, 1 once nothing is left to do" },
  { "SceneReport", Text, "", "", "What is touched, what was repaired, what is refused and why, a line a surface" },
};

} // namespace readout_table

std::span<const Readout> sessionReadouts()
{
  return readout_table::readouts;
}

} // namespace palpate
