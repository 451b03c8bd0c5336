// SPDX-License-Identifier: GPL-3.0-or-later
// Written by `ninja -C build tables` from haptics/session/settings/: what *Touch Along Path* is set to of a field.
#ifndef vtkTouchAlongPathDescribed_h
#define vtkTouchAlongPathDescribed_h

#include "vtkSetGet.h"

/// A setting of the filter's own, and one that is a field of the tick's parameters: of one value, of on and off.
#define vtkHapticTouchSettingMacro(name, type)                                                                         \
  void Set##name(type value);                                                                                          \
  type Get##name() const
#define vtkHapticTouchFieldMacro(name, type)                                                                           \
  void Set##name(type value)                                                                                           \
  {                                                                                                                    \
    this->SetField(#name, static_cast<double>(value));                                                                 \
  }                                                                                                                    \
  type Get##name() const                                                                                               \
  {                                                                                                                    \
    return static_cast<type>(this->GetField(#name));                                                                   \
  }
#define vtkHapticTouchFieldSwitchMacro(name) vtkHapticTouchFieldMacro(name, bool) vtkBooleanMacro(name, bool)

// clang-format off
#define vtkHapticTouchFieldSettingsMacro() \
  vtkHapticTouchSettingMacro(FieldArray, const char*); \
  vtkHapticTouchSettingMacro(FieldComponent, int); \
  vtkHapticTouchSettingMacro(FieldVectors, const char*); \
  vtkHapticTouchSettingMacro(FieldEigenvector, int); \
  vtkHapticTouchSettingMacro(FieldResistance, const char*); \
  vtkHapticTouchSettingMacro(FieldOther, const char*); \
  vtkHapticTouchSettingMacro(FieldSmoothing, int); \
  vtkHapticTouchFieldSwitchMacro(FieldIsosurface); \
  vtkHapticTouchFieldMacro(FieldIsovalue, double); \
  vtkHapticTouchFieldMacro(FieldYield, double); \
  vtkHapticTouchFieldMacro(FieldFollow, double); \
  vtkHapticTouchFieldMacro(FieldDrag, double); \
  vtkHapticTouchFieldMacro(FieldDragNone, double); \
  vtkHapticTouchFieldMacro(FieldDragFull, double); \
  vtkHapticTouchFieldMacro(FieldDetent, double); \
  vtkHapticTouchFieldMacro(FieldDetentOrigin, double); \
  vtkHapticTouchFieldMacro(FieldDetentSpacing, double); \
  vtkHapticTouchSettingMacro(FieldDetentLevels, const char*); \
  vtkHapticTouchFieldSwitchMacro(FieldDetentClick); \
  vtkHapticTouchFieldMacro(FieldSnap, double); \
  vtkHapticTouchFieldMacro(FieldSnapReach, double); \
  vtkHapticTouchFieldMacro(FieldCompare, double); \
  vtkHapticTouchFieldMacro(FieldCompareFull, double); \
  vtkHapticTouchFieldMacro(FieldPush, double); \
  vtkHapticTouchFieldMacro(FieldFullSpeed, double); \
  /* the end of the settings */
// clang-format on

#endif
