// SPDX-License-Identifier: GPL-3.0-or-later
// Declarations of what haptics/session/settings/ describes: one line a setting, one line three read-outs.
#ifndef vtkHapticSessionMacros_h
#define vtkHapticSessionMacros_h

#include "vtkSetGet.h"
#include "vtkWrappingHints.h"

/// A setting of one value, of on and off, of two ends.
#define vtkHapticSettingMacro(name, type)                                                                              \
  void Set##name(type value);                                                                                          \
  type Get##name() const
#define vtkHapticSwitchMacro(name)                                                                                     \
  vtkHapticSettingMacro(name, bool);                                                                                   \
  vtkBooleanMacro(name, bool)
#define vtkHapticRangeMacro(name)                                                                                      \
  void Set##name(double low, double high);                                                                             \
  double* Get##name() VTK_SIZEHINT(2)
/// Three read-outs of a type.
#define vtkHapticReadoutsMacro(type, first, second, third)                                                             \
  type Get##first() const;                                                                                             \
  type Get##second() const;                                                                                            \
  type Get##third() const
/// How an array of a surface is felt.
#define vtkHapticTransferMacro(name)                                                                                   \
  vtkHapticSettingMacro(name##Array, const char*);                                                                     \
  vtkHapticSettingMacro(name##Component, int);                                                                         \
  vtkHapticRangeMacro(name##DataRange);                                                                                \
  vtkHapticRangeMacro(name##FeltRange)

#endif
