// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFinerField_h
#define vtkHapticFinerField_h

#include "vtkHapticCellSizes.h"
#include "vtkHapticFieldWindow.h"
#include "vtkHapticOwnCells.h"

/// The block of a lattice around a place, with a finer one in it where the cells there are smaller than those that the
/// lattice is laid out by: its spacing is that of the lattice, halved as often as the cells are, and it reaches as far
/// as an eighth of a block's memory does. `own`: the data's own cells, which it has too unless the scalar is smoothed;
/// null: they are none that can be had.
palpate::MadeFieldBlock vtkHapticFieldBlockWithFiner(const palpate::FieldBlockGrid& lattice,
  const vtkHapticFieldArrays& arrays, const HapticFieldCells& cells, const vtkHapticCellSizes& sizes,
  const vtkHapticOwnCells* own, const palpate::FieldBlockWish& wish);

#endif
