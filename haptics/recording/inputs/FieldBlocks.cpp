// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/inputs/FieldBlocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{

FieldBlockArray readArray(ByteReader& in)
{
  FieldBlockArray array;
  in.get(array.role);
  in.get(array.name);
  in.get(array.values);
  in.failUnless(array.role <= FieldBlockRole::Axis);
  return array;
}

bool isPossible(const GridPlace& place)
{
  constexpr int furthest = 1000000000; // GridPlace::at() has none further out
  return std::all_of(place.cell.begin(), place.cell.end(), [](int at) { return -furthest <= at && at <= furthest; }) &&
         (place.t.array() >= 0.0).all() && (place.t.array() <= 1.0).all();
}

/// The device of a proxy in the data's own cells is a place in W.
bool isPossible(const FieldCells& cells, const IsoState& state)
{
  return state.device.t.allFinite() && (!state.placed || cells.holds(state.x.cell));
}

bool isPossible(const FieldBlockComponent& field, const IsoState& state)
{
  return isPossible(state.device) && (state.count == 0 || field.exists());
}

template<class Field>
bool isPossibleIn(const Field& field, const IsoState& state)
{
  return isPossible(state.x) && isPossible(field, state) && std::isfinite(state.level) && std::abs(state.side) == 1.0 &&
         state.stuck <= IsoState::mostStuck && state.count >= 0 && state.count <= IsoState::mostCells &&
         std::all_of(state.cells.begin(), state.cells.begin() + state.count,
           [&field](const GridIndex& cell) { return field.holds(cell); });
}

/// All but the finer one.
void putOwnPart(ByteWriter& payload, const FieldBlock& brick)
{
  payload.put(brick.contentHash());
  payload.put(brick.grid().size);
  payload.put(brick.grid().spacing_u);
  payload.put(brick.grid().pose_W);
  payload.put(static_cast<std::uint64_t>(brick.arrays().size()));
  for (const FieldBlockArray& array : brick.arrays())
  {
    payload.put(array.role);
    payload.put(array.name);
    payload.put(array.values);
  }
  payload.put(brick.places_W());
  payload.put(brick.lines_W());
}

void putCells(ByteWriter& payload, const CellParts& parts)
{
  payload.put(static_cast<std::uint64_t>(parts.points_W.size()));
  for (std::size_t i = 0; i < parts.points_W.size(); ++i)
  {
    payload.put(parts.points_W[i]);
    payload.put(parts.values[i]);
  }
  payload.put(parts.corners);
  payload.put(parts.offset);
  payload.put(parts.centre_W);
  payload.put(parts.reach_u);
}

/// The data's own cells; null where the record ends before them.
std::shared_ptr<const FieldCells> readCells(ByteReader& in)
{
  if (in.left() == 0)
  {
    return nullptr;
  }
  CellParts parts;
  parts.points_W.resize(in.count(3 * sizeof(double) + sizeof(float)));
  parts.values.resize(parts.points_W.size());
  for (std::size_t i = 0; i < parts.points_W.size(); ++i)
  {
    in.get(parts.points_W[i]);
    in.get(parts.values[i]);
    in.failUnless(parts.points_W[i].allFinite() && std::isfinite(parts.values[i]));
  }
  in.get(parts.corners);
  const auto isThere = [&parts](std::uint32_t corner) { return corner < parts.points_W.size(); };
  in.failUnless(std::ranges::all_of(
    parts.corners, [&isThere](const CellCorners& cell) { return std::ranges::all_of(cell, isThere); }));
  in.get(parts.offset);
  in.get(parts.centre_W);
  in.get(parts.reach_u);
  in.failUnless(std::isfinite(parts.offset) && parts.centre_W.allFinite() && parts.reach_u >= 0.0);
  in.failUnless(!parts.corners.empty());
  return in.ok() ? std::make_shared<const FieldCells>(std::move(parts)) : nullptr;
}

/// A block as its parts, before it is known whether they are one.
struct FieldBlockParts
{
  std::uint64_t contentHash = 0;
  FieldBlockGrid grid;
  std::vector<FieldBlockArray> arrays;
  std::vector<Vec3> places_W;
  std::vector<FieldBlockLine> lines_W;
};

FieldBlockParts readOwnPart(ByteReader& in)
{
  FieldBlockParts parts;
  in.get(parts.contentHash);
  FieldBlockGrid& grid = parts.grid;
  in.get(grid.size);
  in.get(grid.spacing_u);
  in.get(grid.pose_W);
  const std::uint64_t count = in.count(1);
  for (std::uint64_t i = 0; i < count && in.ok(); ++i)
  {
    parts.arrays.push_back(readArray(in));
  }
  in.get(parts.places_W);
  in.get(parts.lines_W);
  return parts;
}

std::shared_ptr<const FieldBlock> brickOf(FieldBlockParts parts, std::shared_ptr<const FieldBlock> finer,
  std::shared_ptr<const FieldCells> cells, ByteReader& in)
{
  in.failUnless(FieldBlock::refuse(parts.grid, parts.arrays, std::numeric_limits<std::size_t>::max()).empty());
  if (!in.ok())
  {
    return nullptr;
  }
  auto brick = std::make_shared<const FieldBlock>(0, parts.grid, std::move(parts.arrays), std::move(parts.places_W),
    std::move(parts.lines_W), std::move(finer), std::move(cells));
  in.failUnless(brick->contentHash() == parts.contentHash);
  return brick;
}

/// Of a proxy in the data's own cells its place in W is not recorded: it follows from its place in the cell.
void keepPlaces(const FieldCells& cells, FieldState& state)
{
  const bool kept = isPossibleIn(cells, state.surface) && isPossibleIn(cells, state.click);
  state = kept ? state : FieldState{};
  state.grid = FieldBlockGrid{};
  for (IsoState* iso : { &state.surface, &state.click })
  {
    iso->x_W = iso->placed ? cells.toWorld(iso->x) : Vec3(Vec3::Zero());
  }
}

} // namespace

void putFieldBlock(ByteWriter& payload, const FieldBlock& brick)
{
  putOwnPart(payload, brick);
  const FieldBlock* const finer = brick.finer().get();
  payload.put(finer != nullptr);
  if (finer != nullptr)
  {
    putOwnPart(payload, *finer);
  }
  for (const FieldBlock* part : { &brick, finer })
  {
    if (part != nullptr)
    {
      std::ranges::for_each(part->arrays(), [&payload](const FieldBlockArray& array) { payload.put(array.offset); });
    }
  }
  if (brick.cells())
  {
    putCells(payload, brick.cells()->parts());
  }
}

std::shared_ptr<const FieldBlock> readFieldBlock(ByteReader& in)
{
  FieldBlockParts parts = readOwnPart(in), finer;
  bool hasFiner = false;
  in.get(hasFiner);
  finer = hasFiner ? readOwnPart(in) : finer;
  for (FieldBlockParts* part : { &parts, &finer })
  {
    std::ranges::for_each(part->arrays, [&in](FieldBlockArray& array) { in.get(array.offset); });
  }
  std::shared_ptr<const FieldCells> cells = readCells(in);
  return brickOf(
    std::move(parts), hasFiner ? brickOf(std::move(finer), nullptr, nullptr, in) : nullptr, std::move(cells), in);
}

void keepCellsWithin(const std::vector<std::shared_ptr<const FieldBlock>>& bricks, FieldState& state)
{
  for (const std::shared_ptr<const FieldBlock>& brick : bricks)
  {
    if (const FieldCells* const cells = brick->cells().get(); cells && cells->contentHash() == state.brick)
    {
      keepPlaces(*cells, state);
      return;
    }
    if (const FieldBlock* const felt = brick->called(state.brick))
    {
      const FieldBlockComponent field = felt->component(FieldBlockRole::Scalar);
      const bool kept = isPossibleIn(field, state.surface) && isPossibleIn(field, state.click);
      state = kept ? state : FieldState{};
      state.grid = kept ? felt->grid() : FieldBlockGrid{};
      return;
    }
  }
  state = FieldState{};
}

} // namespace palpate
