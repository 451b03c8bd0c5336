// SPDX-License-Identifier: GPL-3.0-or-later
// Written by `ninja -C build tables` from haptics/session/settings/: the read-outs of a session.
#ifndef vtkHapticSessionDescribed_h
#define vtkHapticSessionDescribed_h

#include "vtkHapticSessionMacros.h"

// clang-format off
#define vtkHapticTableReadoutsMacro() \
  vtkHapticTextMacro(DeviceKind) \
  vtkHapticTextMacro(DeviceNotes) \
  vtkHapticTextMacro(LinkText) \
  vtkHapticTextMacro(DeviceButton) \
  vtkHapticReadoutMacro(LargestStiffness, double) \
  vtkHapticTextMacro(StabilityText) \
  vtkHapticTextMacro(StateText) \
  vtkHapticTextMacro(FaultText) \
  vtkHapticTextMacro(Warning) \
  vtkHapticTextMacro(RecordingText) \
  vtkHapticTextMacro(RecordedFile) \
  vtkHapticTextMacro(Problem) \
  vtkHapticNumbersMacro(ProxyPosition, 3) \
  vtkHapticNumbersMacro(Force, 3) \
  vtkHapticReadoutMacro(ForceMagnitude, double) \
  vtkHapticReadoutMacro(ForceLimited, bool) \
  vtkHapticReadoutMacro(PeakForce, double) \
  vtkHapticReadoutMacro(Depth, double) \
  vtkHapticReadoutMacro(StiffnessUsed, double) \
  vtkHapticReadoutMacro(StiffnessLimited, bool) \
  vtkHapticReadoutMacro(RadiusLimit, double) \
  vtkHapticReadoutMacro(RadiusUsed, double) \
  vtkHapticReadoutMacro(DeliveredEnergy, double) \
  vtkHapticReadoutMacro(ExcessEnergy, double) \
  vtkHapticReadoutMacro(PeakExcessEnergy, double) \
  vtkHapticReadoutMacro(StabiliserForce, double) \
  vtkHapticReadoutMacro(PeakStabiliserForce, double) \
  vtkHapticReadoutMacro(ForceResidual, double) \
  vtkHapticTextMacro(MaterialText) \
  vtkHapticTextMacro(FrictionText) \
  vtkHapticReadoutMacro(FrictionKineticUsed, double) \
  vtkHapticReadoutMacro(Contacts, int) \
  vtkHapticTextMacro(MechanismText) \
  vtkHapticReadoutMacro(MechanismDepth, double) \
  vtkHapticReadoutMacro(WirePushed, double) \
  vtkHapticReadoutMacro(WireTurned, double) \
  vtkHapticReadoutMacro(WireTipForce, double) \
  vtkHapticReadoutMacro(WireWallForce, double) \
  vtkHapticNumbersMacro(WireWallPosition, 3) \
  vtkHapticTextMacro(LooseText) \
  vtkHapticTextMacro(SoftText) \
  vtkHapticReadoutMacro(SoftStrain, double) \
  vtkHapticReadoutMacro(SoftPackets, double) \
  vtkHapticReadoutMacro(SoftAge, double) \
  vtkHapticReadoutMacro(SoftBalanceForce, double) \
  vtkHapticNumbersMacro(SoftHandPosition, 3) \
  vtkHapticTextMacro(ToolText) \
  vtkHapticTextMacro(ToolContacts) \
  vtkHapticNumbersMacro(ToolPose, 7) \
  vtkHapticNumbersMacro(ToolHandPose, 7) \
  vtkHapticNumbersMacro(ToolTip, 3) \
  vtkHapticNumbersMacro(ToolTorque, 3) \
  vtkHapticNumbersMacro(Torque, 3) \
  vtkHapticReadoutMacro(ContactIsNow, bool) \
  vtkHapticTextMacro(ContactText) \
  vtkHapticTextMacro(ContactSource) \
  vtkHapticReadoutMacro(ContactCell, vtkIdType) \
  vtkHapticReadoutMacro(ContactPoint, vtkIdType) \
  vtkHapticNumbersMacro(ContactPosition, 3) \
  vtkHapticNumbersMacro(ContactNormal, 3) \
  vtkHapticNumbersMacro(ContactCurvature, 2) \
  vtkHapticReadoutMacro(ContactThickness, double) \
  vtkHapticTextMacro(ContactArrays) \
  vtkHapticReadoutMacro(NumberOfMarks, int) \
  vtkHapticTextMacro(MarksNote) \
  vtkHapticReadoutMacro(ContactSeconds, double) \
  vtkHapticReadoutMacro(MotionLag, double) \
  vtkHapticReadoutMacro(Rate, double) \
  vtkHapticReadoutMacro(LatenessP50, double) \
  vtkHapticReadoutMacro(LatenessP99, double) \
  vtkHapticReadoutMacro(CostP50, double) \
  vtkHapticReadoutMacro(CostP99, double) \
  vtkHapticReadoutMacro(CostP999, double) \
  vtkHapticReadoutMacro(Ticks, vtkIdType) \
  vtkHapticReadoutMacro(Missed, vtkIdType) \
  vtkHapticReadoutMacro(Periods, vtkIdType) \
  vtkHapticReadoutMacro(CappedTicks, vtkIdType) \
  vtkHapticReadoutMacro(FieldValue, double) \
  vtkHapticNumbersMacro(FieldGradient, 3) \
  vtkHapticReadoutMacro(FieldPushPower, double) \
  vtkHapticReadoutMacro(FieldTicksBeyond, vtkIdType) \
  vtkHapticReadoutMacro(FieldError, double) \
  vtkHapticReadoutMacro(FieldAge, double) \
  vtkHapticTextMacro(FieldText) \
  vtkHapticTextMacro(ServerText) \
  vtkHapticReadoutMacro(ServerAge, double) \
  vtkHapticReadoutMacro(ServerTicksBeyond, vtkIdType) \
  vtkHapticTextMacro(SchedulingReport) \
  vtkHapticTextMacro(PlanText) \
  vtkHapticReadoutMacro(SceneProgress, double) \
  vtkHapticTextMacro(SceneDamage) \
  vtkHapticTextMacro(SceneRefusal) \
  vtkHapticTextMacro(SceneReport) \
  /* the end of the read-outs */
// clang-format on

#endif
