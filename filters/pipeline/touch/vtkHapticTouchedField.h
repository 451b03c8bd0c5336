// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticTouchedField_h
#define vtkHapticTouchedField_h

#include <memory>
#include <string>

#include "haptics/tick/HapticParameters.h"
#include "vtkHapticFieldData.h"

class vtkDataObject;

/// How a filter feels numbers in space: the session's settings whose names begin with "Field".
struct vtkHapticTouchedField
{
  vtkHapticTouchedField();

  vtkHapticFieldArrays Arrays;
  palpate::HapticParameters Parameters; ///< of which the field's plan alone is used
  std::string Levels;                   ///< that are chosen, as text

  /// With those levels, as far as Check() has nothing against them.
  palpate::FieldPlan Plan() const;

  /// Whether somebody wants to feel a field at all.
  bool IsAskedFor() const;
  /// Empty, or the first setting that cannot be.
  std::string Check() const;
};

#endif
