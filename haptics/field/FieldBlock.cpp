// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/FieldBlock.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "haptics/core/WordHash.h"

namespace palpate
{
namespace
{

std::uint64_t hashOf(const FieldBlockGrid& grid, const std::vector<FieldBlockArray>& arrays,
  const std::vector<Vec3>& places_W, const std::vector<FieldBlockLine>& lines_W, const FieldBlock* finer,
  const FieldCells* cells) noexcept
{
  WordHash hash;
  for (int k = 0; k < 3; ++k)
  {
    hash.add(static_cast<std::uint64_t>(grid.size[k]));
    hash.add(grid.spacing_u[k]);
    hash.add(grid.pose_W.p[k]);
  }
  for (const double number : grid.pose_W.q.coeffs())
  {
    hash.add(number);
  }
  for (const FieldBlockArray& array : arrays)
  {
    hash.add(static_cast<std::uint64_t>(array.role));
    if (array.offset != 0.0)
    {
      hash.add(array.offset);
    }
    for (const float value : array.values)
    {
      hash.add(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(value)));
    }
  }
  const auto addPlace = [&hash](const Vec3& place_W)
  { std::ranges::for_each(place_W, [&](double v) { hash.add(v); }); };
  std::ranges::for_each(places_W, addPlace);
  if (!lines_W.empty())
  {
    hash.add(static_cast<std::uint64_t>(lines_W.size()));
  }
  for (const FieldBlockLine& line_W : lines_W)
  {
    std::ranges::for_each(line_W, addPlace);
  }
  if (finer != nullptr)
  {
    hash.add(finer->contentHash());
  }
  if (cells != nullptr)
  {
    hash.add(cells->contentHash());
  }
  return hash.value();
}

/// So that the number of all points can be counted.
constexpr int mostAlongAxis = 65536;

std::string refuseGrid(const FieldBlockGrid& grid)
{
  for (int k = 0; k < 3; ++k)
  {
    if (grid.size[k] < 2)
    {
      return "a field needs at least two points along each axis; data of one cell or of a plane are too small";
    }
    if (grid.size[k] > mostAlongAxis)
    {
      return "a field may have 65536 points along an axis";
    }
    if (!std::isfinite(grid.spacing_u[k]) || !(grid.spacing_u[k] > 0.0))
    {
      return "the distance between points of a field [scene units] must be larger than 0";
    }
  }
  constexpr double unitRounding = 1e-6;
  return grid.pose_W.p.allFinite() && std::fabs(grid.pose_W.q.norm() - 1.0) < unitRounding
           ? ""
           : "the place of a field [scene units] must be finite and its orientation a rotation";
}

} // namespace

std::optional<GridPlace> FieldBlockComponent::within(GridPlace place) const noexcept
{
  for (int k = 0; k < 3; ++k)
  {
    if (place.cell[k] == this->size_[k] - 1 && place.t[k] == 0.0)
    {
      --place.cell[k];
      place.t[k] = 1.0;
    }
  }
  return this->holds(place.cell) ? std::optional(place) : std::nullopt;
}

Vec3 nearestOn(const FieldBlockLine& line_W, const Vec3& p_W) noexcept
{
  const Vec3 way = line_W[1] - line_W[0];
  const double square = way.squaredNorm();
  const double t = square > 0.0 ? std::clamp((p_W - line_W[0]).dot(way) / square, 0.0, 1.0) : 0.0;
  return line_W[0] + t * way;
}

std::string FieldBlock::refuse(
  const FieldBlockGrid& grid, const std::vector<FieldBlockArray>& arrays, std::size_t mostBytes)
{
  if (std::string problem = refuseGrid(grid); !problem.empty())
  {
    return problem;
  }
  std::size_t components = 0;
  for (const FieldBlockArray& array : arrays)
  {
    const auto wanted = static_cast<std::size_t>(componentsOf(array.role));
    components += wanted;
    if (array.values.size() / wanted != grid.points() || array.values.size() % wanted != 0)
    {
      return "array '" + array.name + "' does not have one value per point of the field";
    }
    if (!std::isfinite(array.offset) || (wanted > 1 && array.offset != 0.0))
    {
      return "array '" + array.name + "' of a field has an offset that is not finite, or a vector array has an offset";
    }
    if (std::ranges::count(arrays, array.role, &FieldBlockArray::role) > 1)
    {
      return "array '" + array.name + "' has the same use as another array; choose one of them";
    }
  }
  if (grid.points() > mostBytes / sizeof(float) / std::max<std::size_t>(components, 1))
  {
    return "the field around the hand would take more than " + std::to_string(mostBytes >> 20) +
           " MB: use fewer points or fewer arrays";
  }
  return {};
}

FieldBlock::FieldBlock(std::uint64_t revision, const FieldBlockGrid& grid, std::vector<FieldBlockArray> arrays,
  std::vector<Vec3> places_W, std::vector<FieldBlockLine> lines_W, std::shared_ptr<const FieldBlock> finer,
  std::shared_ptr<const FieldCells> cells)
  : revision_(revision), grid_(grid), arrays_(std::move(arrays)), places_W_(std::move(places_W)),
    lines_W_(std::move(lines_W)), finer_(std::move(finer)), cells_(std::move(cells))
{
  this->places_W_.resize(std::min(this->places_W_.size(), mostPlaces));
  this->lines_W_.resize(std::min(this->lines_W_.size(), mostPlaces));
  for (FieldBlockArray& array : this->arrays_)
  {
    for (float& value : array.values)
    {
      value = std::isfinite(value) ? value : std::numeric_limits<float>::quiet_NaN();
    }
  }
  this->contentHash_ =
    hashOf(this->grid_, this->arrays_, this->places_W_, this->lines_W_, this->finer_.get(), this->cells_.get());
}

const FieldBlock& FieldBlock::finestAt(const Vec3& p_W) const noexcept
{
  return this->finer_ && this->finer_->grid().roomAt_u(p_W) >= 0.0 ? *this->finer_ : *this;
}

const FieldBlock* FieldBlock::called(std::uint64_t contentHash) const noexcept
{
  const bool isFiner = this->finer_ && this->finer_->contentHash() == contentHash;
  return isFiner ? this->finer_.get() : this->contentHash_ == contentHash ? this : nullptr;
}

std::size_t FieldBlock::bytes() const noexcept
{
  std::size_t bytes = (this->finer_ ? this->finer_->bytes() : 0) + (this->cells_ ? this->cells_->bytes() : 0) +
                      sizeof(FieldBlock) + this->places_W_.size() * sizeof(Vec3) +
                      this->lines_W_.size() * sizeof(FieldBlockLine);
  for (const FieldBlockArray& array : this->arrays_)
  {
    bytes += array.values.size() * sizeof(float);
  }
  return bytes;
}

FieldBlockComponent FieldBlock::component(FieldBlockRole role, int component) const noexcept
{
  for (const FieldBlockArray& array : this->arrays_)
  {
    if (array.role == role)
    {
      return { this->grid_.size, array.values.data() + component, componentsOf(role), array.offset };
    }
  }
  return {};
}

std::optional<double> FieldBlock::scalarFelt(const Vec3& p_W) const noexcept
{
  if (this->cells_ && this->cells_->roomAt_u(p_W) >= 0.0)
  {
    const std::optional<GridPlace> place = this->cells_->locate(p_W);
    return place ? std::optional(this->cells_->cell(place->cell).value(place->t)) : std::nullopt;
  }
  const std::optional<FieldSample> sample = this->finestAt(p_W).sample(FieldBlockRole::Scalar, p_W);
  return sample ? std::optional(sample->value) : std::nullopt;
}

std::optional<FieldSample> FieldBlock::sample(FieldBlockRole role, const Vec3& p_W) const noexcept
{
  const FieldBlockComponent scalar = this->component(role);
  const std::optional<GridPlace> place = scalar.within(GridPlace::at(this->grid_.toIndex(p_W)));
  if (!scalar.exists() || !place)
  {
    return {};
  }
  const TrilinearCell cell = scalar.cell(place->cell);
  return cell.valid()
           ? std::optional<FieldSample>({ cell.value(place->t), this->grid_.gradientToWorld(cell.gradient(place->t)) })
           : std::nullopt;
}

std::optional<Vec3> FieldBlock::nearestPlace_W(const Vec3& p_W, double reach_u) const noexcept
{
  std::optional<Vec3> nearest_W;
  double nearest_u2 = reach_u * reach_u;
  const auto offer = [&](const Vec3& place_W)
  {
    const double far_u2 = (place_W - p_W).squaredNorm();
    if (far_u2 < nearest_u2)
    {
      nearest_u2 = far_u2;
      nearest_W = place_W;
    }
  };
  std::ranges::for_each(this->places_W_, offer);
  std::ranges::for_each(this->lines_W_, [&](const FieldBlockLine& line_W) { offer(nearestOn(line_W, p_W)); });
  return nearest_W;
}

std::optional<Vec3> FieldBlock::vector(const Vec3& p_W) const noexcept
{
  const GridPlace at = GridPlace::at(this->grid_.toIndex(p_W));
  Vec3 v_W;
  for (int k = 0; k < 3; ++k)
  {
    const FieldBlockComponent along = this->component(FieldBlockRole::Vector, k);
    const std::optional<GridPlace> place = along.within(at);
    const TrilinearCell cell = along.exists() && place ? along.cell(place->cell) : TrilinearCell{ { NAN } };
    if (!cell.valid())
    {
      return {};
    }
    v_W[k] = cell.value(place->t);
  }
  return v_W;
}

std::optional<Vec3> FieldBlock::axis(const Vec3& p_W, const Vec3& like) const noexcept
{
  std::array<TrilinearCell, 3> cells;
  Vec3 t = Vec3::Zero(); // alike for all three
  for (int k = 0; k < 3; ++k)
  {
    const FieldBlockComponent along = this->component(FieldBlockRole::Axis, k);
    const std::optional<GridPlace> place = along.within(GridPlace::at(this->grid_.toIndex(p_W)));
    cells[k] = along.exists() && place ? along.cell(place->cell) : TrilinearCell{ { NAN } };
    if (!cells[k].valid())
    {
      return {};
    }
    t = place->t;
  }
  const auto corner = [&cells](std::size_t i)
  { return Vec3(cells[0].corner[i], cells[1].corner[i], cells[2].corner[i]); };
  const Vec3 side = like.isZero(0.0) ? corner(0) : like;
  for (std::size_t i = 0; i < 8; ++i)
  {
    if (corner(i).dot(side) < 0.0)
    {
      std::ranges::for_each(cells, [i](TrilinearCell& cell) { cell.corner[i] = -cell.corner[i]; });
    }
  }
  return Vec3(cells[0].value(t), cells[1].value(t), cells[2].value(t));
}

} // namespace palpate
