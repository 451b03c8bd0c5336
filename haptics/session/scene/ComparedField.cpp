// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/scene/ComparedField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{

/// The values of a block's scalar at the points of another grid, less an offset; NaN where it has none.
std::vector<float> sampledAt(const FieldBlockGrid& grid, const FieldBlock* values, double offset)
{
  std::vector<float> sampled(grid.points(), std::numeric_limits<float>::quiet_NaN());
  std::size_t at = 0;
  for (int z = 0; z < grid.size[2]; ++z)
  {
    for (int y = 0; y < grid.size[1]; ++y)
    {
      for (int x = 0; x < grid.size[0]; ++x, ++at)
      {
        const auto sample =
          values ? values->sample(FieldBlockRole::Scalar, grid.toWorld({ 1.0 * x, 1.0 * y, 1.0 * z })) : std::nullopt;
        sampled[at] = sample ? static_cast<float>(sample->value - offset) : sampled[at];
      }
    }
  }
  return sampled;
}

class ComparedField : public FieldSource
{
public:
  ComparedField(std::shared_ptr<const FieldSource> field, std::shared_ptr<const FieldSource> other)
    : field_(std::move(field)), other_(std::move(other))
  {
  }

  [[nodiscard]] MadeFieldBlock brickAround(const FieldBlockWish& wish) const override
  {
    MadeFieldBlock made = this->field_->brickAround(wish);
    if (made.brick)
    {
      const std::shared_ptr<const FieldBlock>& finer = made.brick->finer();
      made.brick = this->withOther(*made.brick, finer ? this->withOther(*finer, nullptr, made) : nullptr, made);
    }
    return made;
  }
  [[nodiscard]] bool answersAnyThread() const override
  {
    return this->field_->answersAnyThread() && this->other_->answersAnyThread();
  }

private:
  std::shared_ptr<const FieldBlock> withOther(
    const FieldBlock& brick, std::shared_ptr<const FieldBlock> finer, MadeFieldBlock& made) const
  {
    const FieldBlockGrid& grid = brick.grid();
    const Vec3 last(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
    FieldBlockWish beside{ grid.toWorld(0.5 * last), 0.5 * last.cwiseProduct(grid.spacing_u).norm(), brick.revision(),
      {} };
    const MadeFieldBlock other = this->other_->brickAround(beside);
    std::vector<FieldBlockArray> arrays = brick.arrays();
    const auto scalar = std::ranges::find(arrays, FieldBlockRole::Scalar, &FieldBlockArray::role);
    const double offset = scalar == arrays.end() ? 0.0 : scalar->offset;
    arrays.push_back(
      { FieldBlockRole::Other, "that of the other", sampledAt(grid, other.brick.get(), offset), offset });
    made.error = std::max(made.error, other.error);
    return std::make_shared<const FieldBlock>(
      brick.revision(), grid, std::move(arrays), brick.places_W(), brick.lines_W(), std::move(finer), brick.cells());
  }

  std::shared_ptr<const FieldSource> field_, other_;
};

double squareTo(const Vec3& point_W, const Vec3& from_W) noexcept
{
  return (point_W - from_W).squaredNorm();
}

double squareTo(const FieldBlockLine& line_W, const Vec3& from_W) noexcept
{
  return squareTo(nearestOn(line_W, from_W), from_W);
}

/// The nearest of them that a block can hold. Where some are left out, `reach_u` becomes at most half of the distance
/// to the first of those: a hand that comes nearer to them has another block.
template<class Place>
std::vector<Place> nearestOf(std::vector<Place> places, const Vec3& from_W, double& reach_u)
{
  const auto far2 = [&from_W](const Place& place) { return squareTo(place, from_W); };
  if (places.size() > FieldBlock::mostPlaces)
  {
    const auto most = places.begin() + FieldBlock::mostPlaces;
    std::ranges::nth_element(places, most, {}, far2);
    reach_u = std::min(reach_u, 0.5 * std::sqrt(far2(*most)));
    places.erase(most, places.end());
  }
  return places;
}

class SnappingField : public FieldSource
{
public:
  SnappingField(std::shared_ptr<const FieldSource> field, SnapPlaces places)
    : field_(std::move(field)), places_(std::move(places))
  {
  }

  [[nodiscard]] MadeFieldBlock brickAround(const FieldBlockWish& wish) const override
  {
    MadeFieldBlock made = this->field_->brickAround(wish);
    if (made.brick)
    {
      const std::vector<Vec3> points_W = nearestOf(this->places_.points_W, wish.centre_W, made.reach_u);
      const std::vector<FieldBlockLine> lines_W = nearestOf(this->places_.lines_W, wish.centre_W, made.reach_u);
      const auto snapping = [&](const FieldBlock& brick, std::shared_ptr<const FieldBlock> finer)
      {
        return std::make_shared<const FieldBlock>(
          wish.revision, brick.grid(), brick.arrays(), points_W, lines_W, std::move(finer), brick.cells());
      };
      const std::shared_ptr<const FieldBlock>& finer = made.brick->finer();
      made.brick = snapping(*made.brick, finer ? snapping(*finer, nullptr) : nullptr);
    }
    return made;
  }
  [[nodiscard]] bool answersAnyThread() const override { return this->field_->answersAnyThread(); }

private:
  std::shared_ptr<const FieldSource> field_;
  SnapPlaces places_;
};

} // namespace

std::shared_ptr<const FieldSource> comparedWith(
  std::shared_ptr<const FieldSource> field, std::shared_ptr<const FieldSource> other)
{
  return std::make_shared<ComparedField>(std::move(field), std::move(other));
}

std::shared_ptr<const FieldSource> snappingTo(std::shared_ptr<const FieldSource> field, SnapPlaces places)
{
  return std::make_shared<SnappingField>(std::move(field), std::move(places));
}

} // namespace palpate
