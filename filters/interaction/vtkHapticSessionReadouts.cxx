// SPDX-License-Identifier: GPL-3.0-or-later
// Read-outs of a session, by name, as of the last Update().
#include <cmath>
#include <limits>
#include <map>
#include <string_view>

#include "vtkHapticContactState.h"
#include "vtkHapticHeldMechanism.h"
#include "vtkHapticPressedBody.h"
#include "vtkHapticRecordings.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticServerSurfaces.h"
#include "vtkHapticSessionInternals.h"
#include "vtkHapticTool.h"
#include "vtkMath.h"

namespace
{
using I = vtkHapticSession::Internals;

constexpr double NoNumber = std::numeric_limits<double>::quiet_NaN();

/// Of the data found at the contact.
double ValueOf(const I& s, const char* name)
{
  return s.Contact.Found ? s.Contact.Found->Number(name) : NoNumber;
}

double IdOf(const I& s, const char* name)
{
  const double id = ValueOf(s, name);
  return std::isnan(id) ? -1.0 : id;
}

double ValueOfField(I& s)
{
  const std::shared_ptr<const palpate::FieldBlock>& brick = s.Core.brick();
  const auto value = brick ? brick->scalarFelt(palpate::Vec3(s.Hand)) : std::nullopt;
  return value.value_or(NoNumber);
}

/// The tip of a wire is elsewhere than the hand, whose spring is stretched along the sheath.
double DepthOf(I& s)
{
  const bool wire = s.State.mechanism.held && s.Mechanism.IsWire();
  const double stiffness_N_per_m = s.State.stiffness_N_per_m;
  const double stretch_m = stiffness_N_per_m > 0.0 ? s.State.force_W.norm() / stiffness_N_per_m : 0.0;
  return wire ? s.Asked.asked().map.scale_u_per_m * stretch_m : (s.State.proxy_W.p - s.State.device_W.p).norm();
}

const std::map<std::string_view, double (*)(I&)> Numbers = {
  { "CappedTicks", [](I& s) { return static_cast<double>(s.Report.cappedTicks); } },
  { "ContactCell", [](I& s) { return IdOf(s, "Cell"); } },
  { "ContactPoint", [](I& s) { return IdOf(s, "Point"); } },
  { "ContactSeconds", [](I& s) { return static_cast<double>(s.Report.contactTicks) * I::PeriodSeconds; } },
  { "ContactThickness", [](I& s) { return ValueOf(s, "Thickness"); } },
  { "Contacts", [](I& s) { return static_cast<double>(s.State.contacts); } },
  { "CostP50", [](I& s) { return s.Report.cost.p50_us; } },
  { "ContactIsNow", [](I& s) { return static_cast<double>(s.State.contacts > 0); } },
  { "CostP99", [](I& s) { return s.Report.cost.p99_us; } },
  { "CostP999", [](I& s) { return s.Report.cost.p999_us; } },
  { "DeliveredEnergy", [](I& s) { return s.State.energy.delivered_J; } },
  { "Depth", DepthOf },
  { "ExcessEnergy", [](I& s) { return s.State.energy.excess_J; } },
  { "FieldAge", [](I& s) { return s.FeltField.age_s(); } },
  { "FieldError", [](I& s) { return s.FeltField.made().error; } },
  { "FieldPushPower", [](I& s) { return 1e3 * s.State.field.pushPower_W; } },
  { "FieldTicksBeyond", [](I& s) { return static_cast<double>(s.State.field.beyondTicks); } },
  { "FieldValue", [](I& s) { return ValueOfField(s); } },
  { "ForceLimited",
    [](I& s) // the torque may be the limited one
    {
      return static_cast<double>(
        s.State.clamped && s.State.force_D.norm() > 0.999 * s.Core.parameters().safety.maxForce_N);
    } },
  { "ForceMagnitude", [](I& s) { return s.State.force_W.norm(); } },
  { "ForceResidual", [](I& s) { return s.Report.forceResidual_N; } },
  { "FrictionKineticUsed", [](I& s) { return s.Asked.asked().contact.friction.kinetic; } },
  { "LargestStiffness", [](I& s) { return s.Limits.largest_N_per_m; } },
  { "LatenessP50", [](I& s) { return s.Report.lateness.p50_us; } },
  { "LatenessP99", [](I& s) { return s.Report.lateness.p99_us; } },
  { "MechanismDepth", [](I& s) { return s.Mechanism.Depth; } },
  { "Missed", [](I& s) { return static_cast<double>(s.Report.missed); } },
  { "MotionLag", [](I& s)
    { return s.Core.running() && s.State.motionLag_s > 0.0 ? s.State.motionLag_s + s.Scene.handOver_s() : 0.0; } },
  { "NumberOfMarks", [](I& s) { return static_cast<double>(s.Contact.Marks.Records.size()); } },
  { "PeakExcessEnergy", [](I& s) { return s.State.energy.peakExcess_J; } },
  { "PeakForce", [](I& s) { return s.Report.peakForce_N; } },
  { "PeakStabiliserForce", [](I& s) { return s.Report.peakStabiliser_N; } },
  { "Periods", [](I& s) { return static_cast<double>(s.Report.periods); } },
  { "RadiusLimit", [](I& s) { return s.Scene.built().largestRadius_u; } },
  { "RadiusUsed", [](I& s) { return s.Asked.touch(s.Scene.built()).plan.radius_u; } },
  { "Rate",
    [](I& s) { return s.Report.elapsed_s > 0.0 ? static_cast<double>(s.Report.ticks) / s.Report.elapsed_s : 0.0; } },
  { "SceneProgress", [](I& s) { return s.Surfaces.Preparing() ? 0.0 : s.Scene.worker().share(); } },
  { "ServerAge", [](I& s) { return s.Server.GetAge(); } },
  { "ServerTicksBeyond", [](I& s) { return static_cast<double>(s.State.known.beyondTicks); } },
  { "SoftAge", [](I& s) { return s.State.soft.age_s; } },
  { "SoftBalanceForce", [](I& s) { return s.State.soft.added_N; } },
  { "SoftPackets", [](I& s) { return s.Soft.PacketsPerSecond; } },
  { "SoftStrain", [](I& s) { return s.Soft.Strain; } },
  { "StabiliserForce", [](I& s) { return s.State.stabiliser_D.norm(); } },
  { "StiffnessLimited", [](I& s) { return static_cast<double>(s.State.stiffnessLimited); } },
  { "StiffnessUsed", [](I& s) { return s.State.stiffness_N_per_m; } },
  { "Ticks", [](I& s) { return static_cast<double>(s.Report.ticks); } },
  { "WirePushed", [](I& s) { return s.Mechanism.Wire().pushed_u; } },
  { "WireTipForce", [](I& s) { return s.Mechanism.Wire().tip_N; } },
  { "WireTurned", [](I& s) { return vtkMath::DegreesFromRadians(s.Mechanism.Wire().turned_rad); } },
  { "WireWallForce", [](I& s) { return s.Mechanism.Wire().wall_N; } },
};

const std::map<std::string_view, const char* (*)(I&)> Texts = {
  { "ContactArrays", [](I& s) { return s.Contact.Arrays.c_str(); } },
  { "ContactSource", [](I& s) { return s.Contact.Found ? s.Contact.Found->Source.c_str() : ""; } },
  { "ContactText", [](I& s) { return s.Contact.Text.c_str(); } },
  { "DeviceButton", [](I& s) { return s.SayDeviceButton(); } },
  { "DeviceKind", [](I& s) { return s.SayDeviceKind(); } },
  { "DeviceNotes", [](I& s) { return s.SayDeviceNotes(); } },
  { "FaultText", [](I& s) { return s.SayFaultText(); } },
  { "FieldText", [](I& s) { return s.SayFieldText(); } },
  { "MaterialText", [](I& s) { return s.SayMaterialText(); } },
  { "FrictionText", [](I& s) { return s.SayFrictionText(); } },
  { "LinkText", [](I& s) { return s.SayLinkText(); } },
  { "LooseText", [](I& s) { return s.SayLooseText(); } },
  { "MarksNote", [](I& s) { return s.Contact.MarksNote.c_str(); } },
  { "MechanismText", [](I& s) { return s.Mechanism.Text.c_str(); } },
  { "PlanText", [](I& s) { return s.SayPlanText(); } },
  { "Problem", [](I& s) { return s.Problem.c_str(); } },
  { "RecordedFile", [](I& s) { return s.Recorded.File.c_str(); } },
  { "RecordingText", [](I& s) { return s.Recorded.Say(); } },
  { "SceneDamage", [](I& s) { return s.Scene.built().damaged.c_str(); } },
  { "SceneRefusal", [](I& s) { return s.Scene.built().refused.c_str(); } },
  { "SceneReport", [](I& s) { return s.Scene.built().report.c_str(); } },
  { "SchedulingReport", [](I& s) { return s.Scheduling.c_str(); } },
  { "ServerText", [](I& s) { return s.Server.GetSentence().c_str(); } },
  { "SoftText", [](I& s) { return s.Soft.Text.c_str(); } },
  { "StabilityText", [](I& s) { return s.StabilityText.c_str(); } },
  { "StateText", [](I& s) { return palpate::name(s.State.engage); } },
  { "ToolContacts", [](I& s) { return s.SayToolContacts(); } },
  { "ToolText", [](I& s) { return s.Tool.Text.c_str(); } },
  { "Warning", [](I& s) { return s.Warning.c_str(); } },
};

const std::map<std::string_view, double* (*)(I&)> Vectors = {
  { "ContactCurvature", [](I& s) { return s.Contact.Curvature; } },
  { "ContactNormal", [](I& s) { return s.Contact.Normal; } },
  { "ContactPosition", [](I& s) { return s.Contact.Position; } },
  { "FieldGradient", [](I& s) { return s.GradientNow(); } },
  { "Force", [](I& s) { return s.Force; } },
  { "ProxyPosition", [](I& s) { return s.Proxy; } },
  { "SoftHandPosition", [](I& s) { return s.Soft.Hand_W.data(); } },
  { "ToolHandPose", [](I& s) { return s.Mechanism.HeldShape() ? s.Mechanism.HandPose : s.Tool.HandPose; } },
  { "ToolPose", [](I& s) { return s.Mechanism.HeldShape() ? s.Mechanism.Pose : s.Tool.Pose; } },
  { "ToolTip", [](I& s) { return s.Tool.Tip; } },
  { "ToolTorque", [](I& s) { return s.Tool.Asked; } },
  { "Torque", [](I& s) { return s.Tool.Given; } },
  { "WireWallPosition", [](I& s) { return s.Mechanism.WallPlace; } },
};
} // namespace

double vtkHapticSession::GetReadout(const char* name) const
{
  return Numbers.at(name)(*this->Impl);
}

const char* vtkHapticSession::GetReadoutText(const char* name) const
{
  return Texts.at(name)(*this->Impl);
}

double* vtkHapticSession::GetReadoutNumbers(const char* name) const
{
  return Vectors.at(name)(*this->Impl);
}
