// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/settings/SessionSettings.h"

namespace palpate
{

namespace readout_table // whose names of kinds are not those of the settings
{

using enum Readout::Kind;

const Readout readouts[] = {
  { "DeviceKind", Text, "", "", "Kind of the chosen device" },
  { "DeviceNotes", Text, "", "", "Reason why the device cannot be used, and functions it lacks" },
  { "LinkText", Text, "", "",
    "USB link: reports per second, effects re-armed before expiry, stalled writes, disconnects, malformed reports" },
  { "DeviceButton", Text, "", "", "Button for the step that the device waits for; empty without such a step" },
  { "LargestStiffness", Number, "N/m", "",
    "Largest wall stiffness that the chosen device can render stably, known before touching; infinite without a known "
    "limit" },
  { "StabilityText", Text, "", "", "Largest stable stiffness and the reason for the limit" },
  { "StateText", Text, "", "State",
    "safe: no force; armed: waits until the hand is free of contact; engaged: force flows; fault: no force" },
  { "FaultText", Text, "", "", "Reason why there is no force, and the remedy" },
  { "Warning", Text, "", "", "Condition that needs attention without being a fault, and the remedy" },
  { "RecordingText", Text, "", "", "State of the recording, its file, and the possible actions" },
  { "RecordedFile", Text, "", "", "Last complete recording" },
  { "Problem", Text, "", "", "Last rejected request, and the reason" },
  { "ProxyPosition", Number, "u", "", "Proxy position (world frame)", 3 },
  { "Force", Number, "N", "", "Force on the hand (world frame)", 3 },
  { "ForceMagnitude", Number, "N", "Force", "Magnitude of the current force on the hand" },
  { "ForceLimited", Flag, "", "Force", "1 if the contact asks for more force than the largest that is given" },
  { "PeakForce", Number, "N", "Force", "Largest force so far" },
  { "Depth", Number, "u", "", "Distance from the hand to the proxy" },
  { "StiffnessUsed", Number, "N/m", "Stiffness", "Current stiffness of the spring, after all limits" },
  { "StiffnessLimited", Flag, "", "Stiffness",
    "1 if the stiffness is below the setting because of the device or the rate" },
  { "RadiusLimit", Number, "u", "",
    "Largest proxy radius that can be computed within one tick, evaluated for each scene; infinite without a limit" },
  { "RadiusUsed", Number, "u", "", "Radius of the proxy" },
  { "DeliveredEnergy", Number, "J", "Energy", "Net work done on the hand; negative if the hand did work" },
  { "ExcessEnergy", Number, "J", "Energy",
    "Energy this contact has returned in excess of the energy stored in its spring" },
  { "PeakExcessEnergy", Number, "J", "Energy", "Largest excess energy so far" },
  { "StabiliserForce", Number, "N", "Stabiliser",
    "Part of the current force that the passivity controller adds; zero in free air" },
  { "PeakStabiliserForce", Number, "N", "Stabiliser", "Largest force of the passivity controller so far" },
  { "ForceResidual", Number, "N", "",
    "Largest difference between the force and the sum of spring and passivity controller, over ticks without a force "
    "limit" },
  { "MaterialText", Text, "", "", "That the spring cuts stiffness which data give; empty where it does not" },
  { "FrictionText", Text, "", "Friction", "State of friction: sticks or slips; empty without contact or friction" },
  { "FrictionKineticUsed", Number, "1", "Friction", "Kinetic friction coefficient in use, at most the static one" },
  { "Contacts", Count, "", "Contact", "Number of contact planes that carry force" },
  { "MechanismText", Text, "", "", "State of the mechanism, or the reason why it cannot be touched" },
  { "MechanismDepth", Number, "u", "",
    "Displacement of the hand along the held body since the last tick without contact force" },
  { "WirePushed", Number, "u", "", "Length of a held wire that is out of its sheath" },
  { "WireTurned", Number, "deg", "", "Turn of a held wire's outer end about its sheath" },
  { "WireTipForce", Number, "N", "", "Force of the wall on the last beam of a held wire" },
  { "WireWallForce", Number, "N", "", "Largest force of the wall on a held wire" },
  { "WireWallPosition", Number, "u", "", "Where the largest force of the wall on a held wire is (world frame)", 3 },
  { "SoftText", Text, "", "",
    "Soft body: model, solver rate and strain, or the reason why it cannot be touched; empty if none is chosen" },
  { "SoftStrain", Number, "1", "",
    "Largest strain |F - 1| in the soft body; from 0.1 on a linear model errs by about 10 %" },
  { "SoftPackets", Number, "Hz", "", "Solves of the soft body per second" },
  { "SoftAge", Number, "s", "", "Age of the soft-body solution in use" },
  { "SoftBalanceForce", Number, "N", "",
    "Force that the energy balance of a soft body adds along the spring between hand and proxy, so that the hand gets "
    "back no more energy than it gave; zero at rest" },
  { "SoftHandPosition", Number, "u", "",
    "Hand position used by the last soft-body solve (world frame). Equals the current position when no soft body is "
    "active",
    3 },
  { "ToolText", Text, "", "", "State of the tool, or the reason why it cannot be used; empty if none is chosen" },
  { "ToolContacts", Text, "", "",
    "Contacts of the tool, one per line: source, position (world frame), share of the total contact force" },
  { "ToolPose", Number, "", "",
    "Pose of the tool or held body: origin of its data (world frame, scene units) and rotation (w, x, y, z)", 7 },
  { "ToolHandPose", Number, "", "",
    "Pose at which the hand would hold the tool without contact, in the format of ToolPose", 7 },
  { "ToolTip", Number, "u", "", "Position of the tip of a tool held at its handle (world frame)", 3 },
  { "ToolTorque", Number, "N m", "",
    "Torque requested by the tool at the hand (world frame); the device may render less", 3 },
  { "Torque", Number, "N m", "", "Torque on the hand (world frame)", 3 },
  { "ContactIsNow", Flag, "", "",
    "1 during contact; 0: the data at the contact are those of the last contact in this scene" },
  { "ContactText", Text, "", "",
    "Source and data at the contact, or at the last one, in one line; empty before the first contact" },
  { "ContactSource", Text, "", "", "Name of the touched source" },
  { "ContactCell", LongCount, "", "", "Number of the touched cell; -1 before the first contact" },
  { "ContactPoint", LongCount, "", "",
    "Number of the cell's point with the largest weight at the contact; -1 before the first contact" },
  { "ContactPosition", Number, "u", "", "Position of the contact (world frame)", 3 },
  { "ContactNormal", Number, "1", "", "Unit normal at the contact, towards the proxy (world frame)", 3 },
  { "ContactCurvature", Number, "1/u", "",
    "Largest and smallest principal curvature at the contact, positive where the surface is convex; NaN if unknown",
    2 },
  { "ContactThickness", Number, "u", "",
    "Wall thickness behind the contact, measured along the inward normal; NaN if there is no far wall. Not for "
    "clinical use" },
  { "ContactArrays", Text, "", "", "Values of all arrays at the contact, one array per line" },
  { "NumberOfMarks", Count, "", "", "Number of marks" },
  { "MarksNote", Text, "", "", "Stale marks (the data they were set on has changed), one per line" },
  { "ContactSeconds", Number, "s", "Contact", "Time in contact" },
  { "MotionLag", Number, "s", "Motion lag",
    "Delay of moving surfaces: time between the last two frames of their motion; 0 at rest" },
  { "Rate", Number, "Hz", "Rate", "Ticks per second" },
  { "LatenessP50", Number, "us", "Late p50/p99", "Lateness of ticks, median" },
  { "LatenessP99", Number, "us", "Late p50/p99", "Lateness of ticks, 99th percentile" },
  { "CostP50", Number, "us", "Cost p50/p99/p99.9", "Duration of a tick, median" },
  { "CostP99", Number, "us", "Cost p50/p99/p99.9", "Duration of a tick, 99th percentile" },
  { "CostP999", Number, "us", "Cost p50/p99/p99.9", "Duration of a tick, 99.9th percentile" },
  { "Ticks", LongCount, "", "Ticks", "Number of computed ticks" },
  { "Missed", LongCount, "", "Ticks", "Number of periods without a tick; missed ticks are never caught up" },
  { "Periods", LongCount, "", "", "Sum of Ticks and Missed" },
  { "CappedTicks", LongCount, "", "", "Number of ticks that reached the limit of their work" },
  { "FieldValue", Number, "", "", "Field value at the hand; NaN if there is none" },
  { "FieldGradient", Number, "1/u", "", "Gradient of the field values at the hand (world frame)", 3 },
  { "FieldPushPower", Number, "mW", "", "Power injected by Push" },
  { "FieldTicksBeyond", LongCount, "", "", "Number of ticks spent outside the sampled region around the hand" },
  { "FieldError", Number, "1", "",
    "Largest error of the sampled field against the data's own cells, divided by the data range; 0: no sampling "
    "error" },
  { "FieldAge", Number, "s", "", "Age of the sampled field around the hand" },
  { "FieldText", Text, "", "",
    "Sampled field: arrays, spacing and extent around the hand, or the reason why there is no field" },
  { "ServerText", Text, "", "", "Remote surfaces, each fetched whole or around the hand; empty: none" },
  { "ServerAge", Number, "s", "", "Age of the fetched part of remote surfaces" },
  { "ServerTicksBeyond", LongCount, "", "",
    "Number of ticks without force because the hand left the fetched part of a remote surface or the server did not "
    "answer" },
  { "SchedulingReport", Text, "", "", "Scheduling granted to the servo by the operating system, and the reason" },
  { "PlanText", Text, "", "",
    "Rendering plan of the scene: number of triangles or segments, proxy (point or sphere), friction, search by tree "
    "or list" },
  { "SceneProgress", Number, "1", "",
    "Share of the visible data that is ready to be touched: 0 while data are read, 1 when complete" },
  { "SceneDamage", Text, "", "",
    "First surface that is felt without elements whose coordinates are not numbers, and how many these are" },
  { "SceneRefusal", Text, "", "",
    "First surface that was refused and the reason, while nothing that is shown can be touched" },
  { "SceneReport", Text, "", "", "Touchable surfaces, repairs, and refusals with their reasons, one line per surface" },
};

} // namespace readout_table

std::span<const Readout> sessionReadouts()
{
  return readout_table::readouts;
}

} // namespace palpate
