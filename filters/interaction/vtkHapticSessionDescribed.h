// SPDX-License-Identifier: GPL-3.0-or-later
// Written by `ninja -C build tables` from haptics/session/settings/: what a session is set to, and what is read of it.
#ifndef vtkHapticSessionDescribed_h
#define vtkHapticSessionDescribed_h

#include "vtkHapticSessionMacros.h"

// clang-format off
#define vtkHapticSettingsMacro() \
  vtkHapticSettingMacro(DeviceName, const char*); \
  vtkHapticSettingMacro(Hand, const char*); \
  vtkHapticSwitchMacro(Wheel); \
  vtkHapticFieldMacro(DeadManButtons, int); \
  vtkHapticFieldSwitchMacro(DeadManGrip); \
  vtkHapticSettingMacro(PressDepth, double); \
  vtkHapticFieldMacro(Stiffness, double); \
  vtkHapticFieldMacro(Damping, double); \
  vtkHapticFieldMacro(Radius, double); \
  vtkHapticSwitchMacro(LimitRadius); \
  vtkHapticSettingMacro(LineRadius, double); \
  vtkHapticSettingMacro(PointRadius, double); \
  vtkHapticSettingMacro(ServerLimit, int); \
  vtkHapticFieldMacro(Scale, double); \
  vtkHapticFieldRotationMacro(Rotation); \
  vtkHapticFieldVectorMacro(Offset); \
  vtkHapticSwitchMacro(FitOnTouch); \
  vtkHapticSettingMacro(ViewAlignment, int); \
  vtkHapticSettingMacro(PrecisionFactor, double); \
  vtkHapticSettingMacro(PrecisionButton, int); \
  vtkHapticSettingMacro(ClutchButton, int); \
  vtkHapticSwitchMacro(ShowWorkspace); \
  vtkHapticFieldSwitchMacro(ForceShading); \
  vtkHapticFieldVectorMacro(ConstantForce); \
  vtkHapticSettingMacro(FrictionStatic, double); \
  vtkHapticSettingMacro(FrictionKinetic, double); \
  vtkHapticSettingMacro(SoftSource, const char*); \
  vtkHapticSettingMacro(SoftRate, double); \
  vtkHapticSettingMacro(MechanismSource, const char*); \
  vtkHapticSettingMacro(MechanismLaws, const char*); \
  vtkHapticFieldMacro(MechanismTurning, double); \
  vtkHapticSwitchMacro(ShowSoftHand); \
  vtkHapticSettingMacro(ToolSource, const char*); \
  vtkHapticSettingMacro(ToolHandle, int); \
  vtkHapticVectorMacro(ToolHandlePoint); \
  vtkHapticVectorMacro(ToolTipPoint); \
  vtkHapticSettingMacro(ToolLever, double); \
  vtkHapticFieldMacro(ToolCoupling, int); \
  vtkHapticSettingMacro(StiffnessArray, const char*); \
  vtkHapticSettingMacro(StiffnessComponent, int); \
  vtkHapticRangeMacro(StiffnessDataRange); \
  vtkHapticRangeMacro(StiffnessFeltRange); \
  vtkHapticSettingMacro(FrictionArray, const char*); \
  vtkHapticSettingMacro(FrictionComponent, int); \
  vtkHapticRangeMacro(FrictionDataRange); \
  vtkHapticRangeMacro(FrictionFeltRange); \
  vtkHapticSettingMacro(TextureArray, const char*); \
  vtkHapticSettingMacro(TextureComponent, int); \
  vtkHapticRangeMacro(TextureDataRange); \
  vtkHapticRangeMacro(TextureFeltRange); \
  vtkHapticSettingMacro(FeltSource, const char*); \
  vtkHapticSettingMacro(FieldArray, const char*); \
  vtkHapticSettingMacro(FieldComponent, int); \
  vtkHapticSettingMacro(FieldVectors, const char*); \
  vtkHapticSettingMacro(FieldEigenvector, int); \
  vtkHapticSettingMacro(FieldResistance, const char*); \
  vtkHapticSettingMacro(FieldOther, const char*); \
  vtkHapticSettingMacro(CompareSource, const char*); \
  vtkHapticSettingMacro(FieldSmoothing, int); \
  vtkHapticFieldSwitchMacro(FieldIsosurface); \
  vtkHapticFieldMacro(FieldIsovalue, double); \
  vtkHapticFieldMacro(FieldYield, double); \
  vtkHapticFieldMacro(FieldFollow, double); \
  vtkHapticFieldMacro(FieldDrag, double); \
  vtkHapticFieldMacro(FieldDragNone, double); \
  vtkHapticFieldMacro(FieldDragFull, double); \
  vtkHapticFieldMacro(FieldDetent, double); \
  vtkHapticFieldMacro(FieldDetentOrigin, double); \
  vtkHapticFieldMacro(FieldDetentSpacing, double); \
  vtkHapticSettingMacro(FieldDetentLevels, const char*); \
  vtkHapticFieldSwitchMacro(FieldDetentClick); \
  vtkHapticFieldMacro(FieldSnap, double); \
  vtkHapticFieldMacro(FieldSnapReach, double); \
  vtkHapticSettingMacro(SnapSource, const char*); \
  vtkHapticFieldMacro(FieldCompare, double); \
  vtkHapticFieldMacro(FieldCompareFull, double); \
  vtkHapticFieldMacro(FieldPush, double); \
  vtkHapticFieldMacro(FieldFullSpeed, double); \
  vtkHapticFieldSwitchMacro(LimitStiffness); \
  vtkHapticFieldSwitchMacro(Passivity); \
  vtkHapticFieldMacro(Delay, int); \
  vtkHapticFieldMacro(VelocityMethod, int); \
  vtkHapticSettingMacro(Simplify, int); \
  vtkHapticSettingMacro(LinesAsWalls, int); \
  vtkHapticSwitchMacro(HoldWalls); \
  vtkHapticSettingMacro(WallRate, double); \
  vtkHapticSwitchMacro(PlaneGuide); \
  vtkHapticSettingMacro(StrokeSpeed, double); \
  vtkHapticSwitchMacro(Inspect); \
  vtkHapticSettingMacro(MarkButton, int); \
  vtkHapticSettingMacro(MarksText, const char*); \
  vtkHapticSettingMacro(SourcesText, const char*); \
  vtkHapticSettingMacro(RecordFile, const char*); \
  vtkHapticSettingMacro(ReplayFile, const char*); \
  vtkHapticSwitchMacro(VirtualTime); \
  vtkHapticSwitchMacro(Recording); \
  vtkHapticSwitchMacro(Precision); \
  vtkHapticSwitchMacro(Clutch); \
  vtkHapticSwitchMacro(Touching); \
  /* the end of the settings */
#define vtkHapticTableReadoutsMacro() \
  vtkHapticReadoutMacro(DeviceKind, const char*); \
  vtkHapticReadoutMacro(DeviceNotes, const char*); \
  vtkHapticReadoutMacro(LinkText, const char*); \
  vtkHapticReadoutMacro(LargestStiffness, double); \
  vtkHapticReadoutMacro(StabilitySentence, const char*); \
  vtkHapticReadoutMacro(StateText, const char*); \
  vtkHapticReadoutMacro(FaultText, const char*); \
  vtkHapticReadoutMacro(Warning, const char*); \
  vtkHapticReadoutMacro(RecordingText, const char*); \
  vtkHapticReadoutMacro(RecordedFile, const char*); \
  vtkHapticReadoutMacro(Problem, const char*); \
  vtkHapticNumbersMacro(ProxyPosition, 3); \
  vtkHapticNumbersMacro(Force, 3); \
  vtkHapticReadoutMacro(ForceMagnitude, double); \
  vtkHapticReadoutMacro(PeakForce, double); \
  vtkHapticReadoutMacro(Depth, double); \
  vtkHapticReadoutMacro(StiffnessUsed, double); \
  vtkHapticReadoutMacro(StiffnessLimited, bool); \
  vtkHapticReadoutMacro(RadiusLimit, double); \
  vtkHapticReadoutMacro(RadiusUsed, double); \
  vtkHapticReadoutMacro(DeliveredEnergy, double); \
  vtkHapticReadoutMacro(ExcessEnergy, double); \
  vtkHapticReadoutMacro(PeakExcessEnergy, double); \
  vtkHapticReadoutMacro(StabiliserForce, double); \
  vtkHapticReadoutMacro(PeakStabiliserForce, double); \
  vtkHapticReadoutMacro(ForceResidual, double); \
  vtkHapticReadoutMacro(FrictionText, const char*); \
  vtkHapticReadoutMacro(FrictionKineticUsed, double); \
  vtkHapticReadoutMacro(Contacts, int); \
  vtkHapticReadoutMacro(MechanismText, const char*); \
  vtkHapticReadoutMacro(MechanismDepth, double); \
  vtkHapticReadoutMacro(SoftText, const char*); \
  vtkHapticReadoutMacro(SoftStrain, double); \
  vtkHapticReadoutMacro(SoftPackets, double); \
  vtkHapticReadoutMacro(SoftAge, double); \
  vtkHapticNumbersMacro(SoftHandPosition, 3); \
  vtkHapticReadoutMacro(ToolText, const char*); \
  vtkHapticReadoutMacro(ToolContacts, const char*); \
  vtkHapticNumbersMacro(ToolPose, 7); \
  vtkHapticNumbersMacro(ToolHandPose, 7); \
  vtkHapticNumbersMacro(ToolTip, 3); \
  vtkHapticNumbersMacro(ToolTorque, 3); \
  vtkHapticNumbersMacro(Torque, 3); \
  vtkHapticReadoutMacro(ContactText, const char*); \
  vtkHapticReadoutMacro(ContactSource, const char*); \
  vtkHapticReadoutMacro(ContactCell, vtkIdType); \
  vtkHapticReadoutMacro(ContactPoint, vtkIdType); \
  vtkHapticNumbersMacro(ContactPosition, 3); \
  vtkHapticNumbersMacro(ContactNormal, 3); \
  vtkHapticNumbersMacro(ContactCurvature, 2); \
  vtkHapticReadoutMacro(ContactThickness, double); \
  vtkHapticReadoutMacro(ContactArrays, const char*); \
  vtkHapticReadoutMacro(NumberOfMarks, int); \
  vtkHapticReadoutMacro(MarksNote, const char*); \
  vtkHapticReadoutMacro(ContactSeconds, double); \
  vtkHapticReadoutMacro(MotionLag, double); \
  vtkHapticReadoutMacro(Rate, double); \
  vtkHapticReadoutMacro(LatenessP50, double); \
  vtkHapticReadoutMacro(LatenessP99, double); \
  vtkHapticReadoutMacro(CostP50, double); \
  vtkHapticReadoutMacro(CostP99, double); \
  vtkHapticReadoutMacro(CostP999, double); \
  vtkHapticReadoutMacro(Ticks, vtkIdType); \
  vtkHapticReadoutMacro(Missed, vtkIdType); \
  vtkHapticReadoutMacro(Periods, vtkIdType); \
  vtkHapticReadoutMacro(CappedTicks, vtkIdType); \
  vtkHapticReadoutMacro(FieldValue, double); \
  vtkHapticNumbersMacro(FieldGradient, 3); \
  vtkHapticReadoutMacro(FieldPushPower, double); \
  vtkHapticReadoutMacro(FieldTicksBeyond, vtkIdType); \
  vtkHapticReadoutMacro(FieldError, double); \
  vtkHapticReadoutMacro(FieldAge, double); \
  vtkHapticReadoutMacro(FieldSentence, const char*); \
  vtkHapticReadoutMacro(ServerSentence, const char*); \
  vtkHapticReadoutMacro(ServerAge, double); \
  vtkHapticReadoutMacro(ServerTicksBeyond, vtkIdType); \
  vtkHapticReadoutMacro(SchedulingReport, const char*); \
  vtkHapticReadoutMacro(PlanSentence, const char*); \
  vtkHapticReadoutMacro(SceneProgress, double); \
  vtkHapticReadoutMacro(SceneReport, const char*); \
  /* the end of the read-outs */
// clang-format on

#endif
