// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFinerField.h"

#include <algorithm>
#include <cmath>
#include <utility>

using palpate::Brick;
using palpate::BrickGrid;
using palpate::MadeBrick;
using palpate::Vec3;

namespace
{
constexpr std::size_t finerBytes = Brick::mostBytes / 8;

/// Every point of the lattice is one of this too.
BrickGrid Halved(const BrickGrid& lattice, int times)
{
  BrickGrid finer = lattice;
  for (int k = 0; k < 3; ++k)
  {
    finer.size[k] = ((lattice.size[k] - 1) << times) + 1;
    finer.spacing_u[k] = std::ldexp(lattice.spacing_u[k], -times);
  }
  return finer;
}

/// Its own places, and those of the other beyond it: a hand in it is drawn to what is near on either side of its rim.
std::vector<Vec3> PlacesOf(const Brick& finer, const Brick& coarse)
{
  std::vector<Vec3> places_W = finer.places_W();
  std::copy_if(coarse.places_W().begin(), coarse.places_W().end(), std::back_inserter(places_W),
    [&finer](const Vec3& place_W) { return finer.grid().roomAt_u(place_W) < 0.0; });
  return places_W;
}

/// With a finer part where there is one.
MadeBrick BrickWithFiner(const BrickGrid& lattice, const vtkHapticFieldArrays& arrays, const HapticFieldCells& cells,
  const vtkHapticCellSizes& sizes, std::size_t mostBytes, const palpate::BrickWish& wish)
{
  const auto brickOf = [&](const BrickGrid& on, const vtkHapticFieldArrays& felt, std::size_t most)
  {
    const auto read = [&](const vtkHapticFieldPart& part, const vtkHapticFieldWindow& window)
    { return cells(part, vtkHapticGridOf(on, window)); };
    return vtkHapticBrickAround(on, felt, read, wish, most);
  };
  const bool varies = std::isfinite(sizes.Reach());
  MadeBrick made = brickOf(lattice, arrays, mostBytes - (varies ? finerBytes : 0));
  const int halvings = made.brick && varies ? sizes.HalvingsAt(wish.centre_W) : 0;
  made.finerReach_u = 2.0 * sizes.Reach(); // of which half may be used up
  if (halvings == 0)
  {
    return made;
  }
  vtkHapticFieldArrays alike = arrays;
  alike.Smoothing = made.smoothness.passes;
  const MadeBrick finer = brickOf(Halved(lattice, halvings), alike, finerBytes);
  made.finerReach_u = std::min(made.finerReach_u, finer.reach_u);
  if (finer.brick)
  {
    const Brick &in = *finer.brick, &around = *made.brick;
    auto part = std::make_shared<const Brick>(wish.revision, in.grid(), in.arrays(), PlacesOf(in, around));
    made.brick = std::make_shared<const Brick>(
      wish.revision, around.grid(), around.arrays(), around.places_W(), around.lines_W(), std::move(part));
  }
  return made;
}
} // namespace

MadeBrick vtkHapticBrickWithFiner(const BrickGrid& lattice, const vtkHapticFieldArrays& arrays,
  const HapticFieldCells& cells, const vtkHapticCellSizes& sizes, const vtkHapticOwnCells* own,
  const palpate::BrickWish& wish)
{
  const std::size_t mostBytes = Brick::mostBytes - (own ? vtkHapticOwnCells::mostBytes : 0);
  MadeBrick made = BrickWithFiner(lattice, arrays, cells, sizes, mostBytes, wish);
  const bool smoothed = made.smoothness.passes > 0; // what is felt then is not what the cells have
  auto near = made.brick && own && (!smoothed || own->AreFlat()) ? own->Around(wish.centre_W) : nullptr;
  made.whyNoCells = own && made.brick && !near ? "its values are smoothed" : "";
  if (near)
  {
    const Brick& around = *made.brick;
    made.finerReach_u = std::min(made.finerReach_u, near->parts().reach_u);
    made.brick = std::make_shared<const Brick>(wish.revision, around.grid(), around.arrays(), around.places_W(),
      around.lines_W(), around.finer(), std::move(near));
  }
  return made;
}
