// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticLevelScan.h"

#include <algorithm>
#include <cmath>

#include "haptics/field/Smoothing.h"

palpate::LevelBounds vtkHapticLevelsOf(
  const palpate::FieldBlockGrid& lattice, const vtkHapticFieldArrays& arrays, const HapticFieldReading& read, int tile)
{
  // Values that are smoothed only where noise asks for it may be steep: an average of values is no steeper than they
  // are.
  const int passes = std::max(0, arrays.Smoothing), step = tile - 2;
  palpate::LevelBounds bounds;
  const std::vector<vtkHapticFieldPart> parts = vtkHapticFieldParts(arrays);
  const auto scalar = std::find_if(parts.begin(), parts.end(),
    [](const vtkHapticFieldPart& part) { return part.Role == palpate::FieldBlockRole::Scalar; });
  if (scalar == parts.end())
  {
    return bounds;
  }
  vtkHapticFieldWindow window;
  for (int k = 0; k == 0 || k < lattice.size[2] - 2; k += step)
  {
    for (int j = 0; j == 0 || j < lattice.size[1] - 2; j += step)
    {
      for (int i = 0; i == 0 || i < lattice.size[0] - 2; i += step)
      {
        window.First = { i, j, k };
        for (int axis = 0; axis < 3; ++axis)
        {
          window.Size[axis] = std::min(tile, lattice.size[axis] - window.First[axis]);
        }
        const std::vector<float> values = palpate::smoothed(read(*scalar, window), window.Size, passes);
        bounds = bounds.with(palpate::levelBounds(values, window.Size, lattice.spacing_u));
      }
    }
  }
  return bounds;
}

void vtkHapticLevelScan::Tell(palpate::MadeFieldBlock& made, const palpate::FieldBlockWish& wish,
  const palpate::FieldBlockGrid& lattice, const vtkHapticFieldArrays& arrays, const HapticFieldReading& read) const
{
  if (!wish.smoothLevels || !made.brick || std::isinf(made.reach_u) || lattice.points() > mostPoints)
  {
    return;
  }
  constexpr int tile = 130; // 9 MB, as a block
  this->Known = this->Known ? *this->Known : vtkHapticLevelsOf(lattice, arrays, read, tile);
  made.levels = *this->Known;
}
