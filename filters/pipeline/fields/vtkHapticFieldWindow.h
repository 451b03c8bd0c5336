// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFieldWindow_h
#define vtkHapticFieldWindow_h

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "haptics/field/FieldBlock.h"
#include "haptics/session/scene/FieldSource.h"
#include "vtkHapticFieldData.h"

class vtkDataSet;

/// A box of points of a lattice.
struct vtkHapticFieldWindow
{
  palpate::GridIndex First{};
  palpate::GridIndex Size{};

  /// Of a point that it holds, x fastest.
  std::size_t Index(int i, int j, int k) const
  {
    return static_cast<std::size_t>(i) + static_cast<std::size_t>(this->Size[0]) *
                                           (static_cast<std::size_t>(j) + static_cast<std::size_t>(this->Size[1]) * k);
  }
};

/// An array that a block is to have, and the part of it that a window holds: components together, NaN where there is no
/// value.
struct vtkHapticFieldPart
{
  palpate::FieldBlockRole Role;
  std::string Name;
  int Component = -1;  ///< of a scalar; -1: the length. Of an axis: which eigenvector
  double Offset = 0.0; ///< that its values are less, as they are read
};
using HapticFieldReading = std::function<std::vector<float>(const vtkHapticFieldPart&, const vtkHapticFieldWindow&)>;
/// Values of the cells of data at the points of any grid, NaN without a value.
using HapticFieldCells = std::function<std::vector<float>(const vtkHapticFieldPart&, const palpate::FieldBlockGrid&)>;

/// The points of a window by themselves.
palpate::FieldBlockGrid vtkHapticGridOf(const palpate::FieldBlockGrid& lattice, const vtkHapticFieldWindow& window);

/// Whether all arrays that are asked for are at points.
bool vtkHapticAllAtPoints(vtkDataSet& data, const vtkHapticFieldArrays& arrays);

/// The arrays that are asked for.
std::vector<vtkHapticFieldPart> vtkHapticFieldParts(const vtkHapticFieldArrays& arrays);

/// The block of a lattice around a place. FieldBlocks of one lattice that are smoothed as often have the same values at
/// the same places, whichever window they were made of: the scalar is smoothed with as much around it as smoothing
/// needs.
palpate::MadeFieldBlock vtkHapticFieldBlockAround(const palpate::FieldBlockGrid& lattice,
  const vtkHapticFieldArrays& arrays, const HapticFieldReading& read, const palpate::FieldBlockWish& wish,
  std::size_t mostBytes = palpate::FieldBlock::mostBytes);

#endif
