// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCellSizes_h
#define vtkHapticCellSizes_h

#include <array>
#include <cstdint>
#include <vector>

#include "haptics/core/PointGrid.h"

class vtkDataSet;

/// How small the cells of data are from place to place, by how many points there are in bins of some 64 each: where
/// there are eight times as many as in the mean, cells are half as long.
class vtkHapticCellSizes
{
public:
  /// Of all points of all parts, within low and high x, y, z [u].
  vtkHapticCellSizes(const std::vector<vtkDataSet*>& parts, const std::array<double, 6>& bounds_u);

  /// How often the mean length of a cell has to be halved for the smallest cells near a place; at most `mostHalvings`.
  int HalvingsAt(const palpate::Vec3& p_W) const;
  /// How far from a place on another number may hold [u]; infinite where all cells are as long as the mean.
  double Reach() const;

  static constexpr int mostHalvings = 6;

private:
  int HalvingsOf(std::uint32_t count) const;

  palpate::PointGrid Bins;
  double Mean = 0.0; ///< points a bin
  std::uint32_t Most = 0;
  std::vector<std::uint32_t> Counts;
};

#endif
