// SPDX-License-Identifier: GPL-3.0-or-later
// Declarations of what haptics/session/settings/ describes: one line a setting, one line three read-outs.
#ifndef vtkHapticSessionMacros_h
#define vtkHapticSessionMacros_h

#include "vtkSetGet.h"
#include "vtkWrappingHints.h"

/// A setting of one value, of on and off, of two ends, of three numbers.
#define vtkHapticSettingMacro(name, type)                                                                              \
  void Set##name(type value);                                                                                          \
  type Get##name() const
#define vtkHapticSwitchMacro(name)                                                                                     \
  vtkHapticSettingMacro(name, bool);                                                                                   \
  vtkBooleanMacro(name, bool)
#define vtkHapticRangeMacro(name)                                                                                      \
  void Set##name(double low, double high);                                                                             \
  double* Get##name() VTK_SIZEHINT(2)
#define vtkHapticVectorMacro(name)                                                                                      \
  void Set##name(double x, double y, double z);                                                                        \
  double* Get##name() VTK_SIZEHINT(3)
/// A setting that is a field of the tick's parameters: of one value, of on and off, of three numbers, of a quaternion
/// (w, x, y, z).
#define vtkHapticFieldMacro(name, type)                                                                                \
  void Set##name(type value)                                                                                           \
  {                                                                                                                    \
    this->SetField(#name, { static_cast<double>(value) });                                                             \
  }                                                                                                                    \
  type Get##name() const                                                                                               \
  {                                                                                                                    \
    return static_cast<type>(*this->GetField(#name));                                                                  \
  }
#define vtkHapticFieldSwitchMacro(name) vtkHapticFieldMacro(name, bool) vtkBooleanMacro(name, bool)
#define vtkHapticFieldVectorMacro(name)                                                                                \
  void Set##name(double x, double y, double z)                                                                         \
  {                                                                                                                    \
    this->SetField(#name, { x, y, z });                                                                                \
  }                                                                                                                    \
  void Set##name(const double xyz[3])                                                                                  \
  {                                                                                                                    \
    this->SetField(#name, { xyz[0], xyz[1], xyz[2] });                                                                 \
  }                                                                                                                    \
  double* Get##name() VTK_SIZEHINT(3)                                                                                  \
  {                                                                                                                    \
    return this->GetField(#name);                                                                                      \
  }
#define vtkHapticFieldRotationMacro(name)                                                                              \
  void Set##name(double w, double x, double y, double z)                                                               \
  {                                                                                                                    \
    this->SetField(#name, { w, x, y, z });                                                                             \
  }                                                                                                                    \
  void Set##name(const double wxyz[4])                                                                                 \
  {                                                                                                                    \
    this->SetField(#name, { wxyz[0], wxyz[1], wxyz[2], wxyz[3] });                                                     \
  }                                                                                                                    \
  double* Get##name() VTK_SIZEHINT(4)                                                                                  \
  {                                                                                                                    \
    return this->GetField(#name);                                                                                      \
  }
/// A read-out of one value, of several numbers; three of a type.
#define vtkHapticReadoutMacro(name, type) type Get##name() const
#define vtkHapticNumbersMacro(name, count) double* Get##name() VTK_SIZEHINT(count)
#define vtkHapticReadoutsMacro(type, first, second, third)                                                             \
  type Get##first() const;                                                                                             \
  type Get##second() const;                                                                                            \
  type Get##third() const

#endif
