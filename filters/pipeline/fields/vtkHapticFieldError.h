// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFieldError_h
#define vtkHapticFieldError_h

#include "vtkHapticFieldWindow.h"

/// The largest difference between a brick's trilinear values and those of the cells, of the range of the values: in the
/// middle of up to 12 of the brick's cells along each axis, where it is largest for what bends. Of vectors and axes it
/// is not looked at: 0.
double vtkHapticFieldError(
  const palpate::FieldBlock& brick, const vtkHapticFieldPart& part, const HapticFieldCells& cells);

#endif
