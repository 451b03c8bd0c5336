// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticLevelScan_h
#define vtkHapticLevelScan_h

#include <optional>

#include "vtkHapticFieldWindow.h"

/// How steep a scalar is at most on all of a lattice, looked up once, where a block holds a part of it alone: smooth
/// levels have one strength, whichever block the hand is in.
class vtkHapticLevelScan
{
public:
  /// Points of the largest lattice that is looked through, which takes up to some ten seconds of a worker. Smooth
  /// levels of larger ones do not hold.
  static constexpr std::size_t mostPoints = std::size_t{ 1 } << 27;

  /// Says it of a block where it was wished for, and the block does not say it itself. Asked by one thread at a time.
  void Tell(palpate::MadeFieldBlock& made, const palpate::FieldBlockWish& wish, const palpate::FieldBlockGrid& lattice,
    const vtkHapticFieldArrays& arrays, const HapticFieldReading& read) const;

private:
  mutable std::optional<palpate::LevelBounds> Known;
};

/// Those of all windows of the lattice together; `tile`: points of a window along each axis, more than 2.
palpate::LevelBounds vtkHapticLevelsOf(
  const palpate::FieldBlockGrid& lattice, const vtkHapticFieldArrays& arrays, const HapticFieldReading& read, int tile);

#endif
