// SPDX-License-Identifier: GPL-3.0-or-later
// Written by `ninja -C build tables` from haptics/session/settings/: the settings that are fields of the tick's
// parameters.
#ifndef vtkHapticSessionFields_h
#define vtkHapticSessionFields_h

#include "vtkHapticSessionMacros.h"

// clang-format off
#define vtkHapticFieldsMacro() \
  vtkHapticFieldMacro(DeadManButtons, int); \
  vtkHapticFieldSwitchMacro(DeadManGrip); \
  vtkHapticFieldMacro(Stiffness, double); \
  vtkHapticFieldMacro(Damping, double); \
  vtkHapticFieldMacro(Radius, double); \
  vtkHapticFieldMacro(Scale, double); \
  vtkHapticFieldRotationMacro(Rotation); \
  vtkHapticFieldVectorMacro(Offset); \
  vtkHapticFieldSwitchMacro(ForceShading); \
  vtkHapticFieldVectorMacro(ConstantForce); \
  vtkHapticFieldSwitchMacro(LimitStiffness); \
  vtkHapticFieldSwitchMacro(Passivity); \
  vtkHapticFieldMacro(Delay, int); \
  vtkHapticFieldMacro(VelocityMethod, int); \
  /* the end of the list */
// clang-format on

#endif
