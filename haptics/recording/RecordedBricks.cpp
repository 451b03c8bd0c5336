// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordedBricks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{

BrickArray readArray(ByteReader& in)
{
  BrickArray array;
  in.get(array.role);
  in.get(array.name);
  array.values.resize(in.count(sizeof(float)));
  for (float& value : array.values)
  {
    in.get(value);
  }
  in.failUnless(array.role <= BrickRole::Axis);
  return array;
}

/// Pieces of lines that the hand snaps to; what was recorded before they were known ends before them.
std::vector<BrickLine> readLines(ByteReader& in)
{
  std::vector<BrickLine> lines_W(in.left() > 0 ? in.count(6 * sizeof(double)) : 0);
  for (BrickLine& line_W : lines_W)
  {
    in.get(line_W[0]);
    in.get(line_W[1]);
  }
  return lines_W;
}

bool isPossible(const GridPlace& place)
{
  constexpr int furthest = 1000000000; // GridPlace::at() has none further out
  return std::all_of(place.cell.begin(), place.cell.end(), [](int at) { return -furthest <= at && at <= furthest; }) &&
         (place.t.array() >= 0.0).all() && (place.t.array() <= 1.0).all();
}

bool isPossible(const Brick& brick, const IsoState& state)
{
  const BrickComponent field = brick.component(BrickRole::Scalar);
  return isPossible(state.x) && isPossible(state.device) && std::isfinite(state.level) && std::abs(state.side) == 1.0 &&
         state.stuck <= IsoState::mostStuck && state.count >= 0 && state.count <= IsoState::mostCells &&
         (state.count == 0 || field.exists()) &&
         std::all_of(state.cells.begin(), state.cells.begin() + state.count,
           [&field](const GridIndex& cell) { return field.holds(cell); });
}

/// All but the finer one.
void putOwnPart(ByteWriter& payload, const Brick& brick)
{
  payload.put(brick.contentHash());
  for (const int points : brick.grid().size)
  {
    payload.put(points);
  }
  payload.put(brick.grid().spacing_u);
  payload.put(brick.grid().pose_W);
  payload.put(static_cast<std::uint64_t>(brick.arrays().size()));
  for (const BrickArray& array : brick.arrays())
  {
    payload.put(array.role);
    payload.put(array.name);
    payload.put(static_cast<std::uint64_t>(array.values.size()));
    for (const float value : array.values)
    {
      payload.put(value);
    }
  }
  payload.put(static_cast<std::uint64_t>(brick.places_W().size()));
  for (const Vec3& place_W : brick.places_W())
  {
    payload.put(place_W);
  }
  payload.put(static_cast<std::uint64_t>(brick.lines_W().size()));
  for (const BrickLine& line_W : brick.lines_W())
  {
    payload.put(line_W[0]);
    payload.put(line_W[1]);
  }
}

/// A brick as its parts, before it is known whether they are one.
struct BrickParts
{
  std::uint64_t contentHash = 0;
  BrickGrid grid;
  std::vector<BrickArray> arrays;
  std::vector<Vec3> places_W;
  std::vector<BrickLine> lines_W;
};

BrickParts readOwnPart(ByteReader& in)
{
  BrickParts parts;
  in.get(parts.contentHash);
  BrickGrid& grid = parts.grid;
  for (int& points : grid.size)
  {
    in.get(points);
  }
  in.get(grid.spacing_u);
  in.get(grid.pose_W);
  const std::uint64_t count = in.count(1);
  for (std::uint64_t i = 0; i < count && in.ok(); ++i)
  {
    parts.arrays.push_back(readArray(in));
  }
  parts.places_W.resize(in.count(3 * sizeof(double)));
  for (Vec3& place_W : parts.places_W)
  {
    in.get(place_W);
  }
  parts.lines_W = readLines(in);
  return parts;
}

std::shared_ptr<const Brick> brickOf(BrickParts parts, std::shared_ptr<const Brick> finer, ByteReader& in)
{
  in.failUnless(Brick::refuse(parts.grid, parts.arrays, std::numeric_limits<std::size_t>::max()).empty());
  if (!in.ok())
  {
    return nullptr;
  }
  auto brick = std::make_shared<const Brick>(
    0, parts.grid, std::move(parts.arrays), std::move(parts.places_W), std::move(parts.lines_W), std::move(finer));
  in.failUnless(brick->contentHash() == parts.contentHash);
  return brick;
}

} // namespace

void putBrick(ByteWriter& payload, const Brick& brick)
{
  putOwnPart(payload, brick);
  const Brick* const finer = brick.finer().get();
  payload.put(finer != nullptr);
  if (finer != nullptr)
  {
    putOwnPart(payload, *finer);
  }
  for (const Brick* part : { &brick, finer })
  {
    if (part != nullptr)
    {
      std::ranges::for_each(part->arrays(), [&payload](const BrickArray& array) { payload.put(array.offset); });
    }
  }
}

std::shared_ptr<const Brick> readBrick(ByteReader& in)
{
  BrickParts parts = readOwnPart(in), finer;
  bool hasFiner = false;
  if (in.left() > 0) // what was recorded before there were finer ones and offsets ends here
  {
    in.get(hasFiner);
    finer = hasFiner ? readOwnPart(in) : finer;
    for (BrickParts* part : { &parts, &finer })
    {
      std::ranges::for_each(part->arrays, [&in](BrickArray& array) { in.get(array.offset); });
    }
  }
  return brickOf(std::move(parts), hasFiner ? brickOf(std::move(finer), nullptr, in) : nullptr, in);
}

void keepCellsWithin(const std::vector<std::shared_ptr<const Brick>>& bricks, FieldState& state)
{
  const Brick* felt = nullptr;
  for (const std::shared_ptr<const Brick>& brick : bricks)
  {
    felt = felt != nullptr ? felt : brick->called(state.brick);
  }
  const bool kept = felt != nullptr && isPossible(*felt, state.surface) && isPossible(*felt, state.click);
  state = kept ? state : FieldState{};
  state.grid = kept ? felt->grid() : BrickGrid{};
}

} // namespace palpate
