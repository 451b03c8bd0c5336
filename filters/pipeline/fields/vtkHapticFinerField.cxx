// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFinerField.h"

#include <algorithm>
#include <cmath>
#include <utility>

using palpate::FieldBlock;
using palpate::FieldBlockGrid;
using palpate::MadeFieldBlock;
using palpate::Vec3;

namespace
{
constexpr std::size_t finerBytes = FieldBlock::mostBytes / 8;

/// Every point of the lattice is one of this too.
FieldBlockGrid Halved(const FieldBlockGrid& lattice, int times)
{
  FieldBlockGrid finer = lattice;
  for (int k = 0; k < 3; ++k)
  {
    finer.size[k] = ((lattice.size[k] - 1) << times) + 1;
    finer.spacing_u[k] = std::ldexp(lattice.spacing_u[k], -times);
  }
  return finer;
}

/// Its own places, and those of the other beyond it: a hand in it is drawn to near places on either side of its rim.
std::vector<Vec3> PlacesOf(const FieldBlock& finer, const FieldBlock& coarse)
{
  std::vector<Vec3> places_W = finer.places_W();
  std::copy_if(coarse.places_W().begin(), coarse.places_W().end(), std::back_inserter(places_W),
    [&finer](const Vec3& place_W) { return finer.grid().roomAt_u(place_W) < 0.0; });
  return places_W;
}

/// With a finer part where there is one.
MadeFieldBlock FieldBlockWithFiner(const FieldBlockGrid& lattice, const vtkHapticFieldArrays& arrays,
  const HapticFieldCells& cells, const vtkHapticCellSizes& sizes, std::size_t mostBytes,
  const palpate::FieldBlockWish& wish)
{
  const auto brickOf = [&](const FieldBlockGrid& on, const vtkHapticFieldArrays& felt, std::size_t most)
  {
    const auto read = [&](const vtkHapticFieldPart& part, const vtkHapticFieldWindow& window)
    { return cells(part, vtkHapticGridOf(on, window)); };
    return vtkHapticFieldBlockAround(on, felt, read, wish, most);
  };
  const bool varies = std::isfinite(sizes.Reach());
  MadeFieldBlock made = brickOf(lattice, arrays, mostBytes - (varies ? finerBytes : 0));
  const int halvings = made.brick && varies ? sizes.HalvingsAt(wish.centre_W) : 0;
  made.finerReach_u = 2.0 * sizes.Reach(); // of which half may be used up
  if (halvings == 0)
  {
    return made;
  }
  vtkHapticFieldArrays alike = arrays;
  alike.Smoothing = made.smoothness.passes;
  const MadeFieldBlock finer = brickOf(Halved(lattice, halvings), alike, finerBytes);
  made.finerReach_u = std::min(made.finerReach_u, finer.reach_u);
  if (finer.brick)
  {
    const FieldBlock &in = *finer.brick, &around = *made.brick;
    auto part = std::make_shared<const FieldBlock>(wish.revision, in.grid(), in.arrays(), PlacesOf(in, around));
    made.brick = std::make_shared<const FieldBlock>(
      wish.revision, around.grid(), around.arrays(), around.places_W(), around.lines_W(), std::move(part));
  }
  return made;
}
} // namespace

MadeFieldBlock vtkHapticFieldBlockWithFiner(const FieldBlockGrid& lattice, const vtkHapticFieldArrays& arrays,
  const HapticFieldCells& cells, const vtkHapticCellSizes& sizes, const vtkHapticOwnCells* own,
  const palpate::FieldBlockWish& wish)
{
  const std::size_t mostBytes = FieldBlock::mostBytes - (own ? vtkHapticOwnCells::mostBytes : 0);
  MadeFieldBlock made = FieldBlockWithFiner(lattice, arrays, cells, sizes, mostBytes, wish);
  const bool smoothed = made.smoothness.passes > 0; // the felt values then are not those of the cells
  auto near = made.brick && own && (!smoothed || own->AreFlat()) ? own->Around(wish.centre_W) : nullptr;
  made.whyNoCells = own && made.brick && !near ? "its values are smoothed" : "";
  if (near)
  {
    const FieldBlock& around = *made.brick;
    made.finerReach_u = std::min(made.finerReach_u, near->parts().reach_u);
    made.brick = std::make_shared<const FieldBlock>(wish.revision, around.grid(), around.arrays(), around.places_W(),
      around.lines_W(), around.finer(), std::move(near));
  }
  return made;
}
