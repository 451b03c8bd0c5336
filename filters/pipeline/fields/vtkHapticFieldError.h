// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFieldError_h
#define vtkHapticFieldError_h

#include "vtkHapticFieldWindow.h"

/// The largest difference between a block's trilinear values and those of the cells, of the range of the values: in the
/// middle of up to 12 of the block's cells along each axis, where a curved field differs most. Vectors and axes are not
/// looked at: 0.
double vtkHapticFieldError(
  const palpate::FieldBlock& brick, const vtkHapticFieldPart& part, const HapticFieldCells& cells);

#endif
