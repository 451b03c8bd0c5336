// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/TriangleGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace palpate::test
{
namespace
{

/// Of the coordinates at hand: far more than the rounding of the place where a segment enters a cell.
constexpr double roomShare = 1e-9;

/// The part of [from, to] where start + t * way lies in [low, high]; from > to if there is none.
template<class Span>
Span narrowed(Span span, double start, double way, double low, double high)
{
  if (way == 0.0)
  {
    return start < low || start > high ? Span{ 1.0, 0.0 } : span;
  }
  const double a = (low - start) / way, b = (high - start) / way;
  return { std::max(span.from, std::min(a, b)), std::min(span.to, std::max(a, b)) };
}

} // namespace

TriangleGrid::TriangleGrid(const TriangleMesh& mesh) : mesh_(mesh)
{
  this->low_W_ = this->high_W_ = mesh.vertices_W.at(mesh.triangles.at(0)[0]);
  for (const auto& t : mesh.triangles)
  {
    for (const std::uint32_t corner : t)
    {
      this->low_W_ = this->low_W_.cwiseMin(mesh.vertices_W[corner]);
      this->high_W_ = this->high_W_.cwiseMax(mesh.vertices_W[corner]);
    }
  }
  const Vec3 extent = this->high_W_ - this->low_W_;
  const double cells = std::clamp(1.5 * std::sqrt(static_cast<double>(mesh.triangles.size()) / 6), 1.0, 160.0);
  this->cell_u_ = extent.maxCoeff() / cells;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->sides_[axis] = std::max(1, static_cast<int>(std::ceil(extent[axis] / this->cell_u_)));
  }
  this->begins_.assign(static_cast<std::size_t>(this->sides_[0]) * this->sides_[1] * this->sides_[2] + 1, 0);
  this->forEachTriangle([this](std::size_t cell, std::uint32_t) { ++this->begins_[cell + 1]; });
  std::partial_sum(this->begins_.begin(), this->begins_.end(), this->begins_.begin());
  this->triangles_.resize(this->begins_.back());
  std::vector<std::uint32_t> ends = this->begins_;
  this->forEachTriangle([&](std::size_t cell, std::uint32_t t) { this->triangles_[ends[cell]++] = t; });
}

std::vector<std::uint32_t> TriangleGrid::near(const Vec3& from_W, const Vec3& to_W, double margin_u) const
{
  const Vec3 way = to_W - from_W;
  const double largest = std::max({ from_W.cwiseAbs().maxCoeff(), to_W.cwiseAbs().maxCoeff(),
    this->low_W_.cwiseAbs().maxCoeff(), this->high_W_.cwiseAbs().maxCoeff() });
  const double room_u = margin_u + roomShare * largest;
  const Span inside = this->inside(from_W, to_W, room_u);
  std::vector<std::uint32_t> found;
  if (inside.from > inside.to)
  {
    return found;
  }
  int along = 0;
  way.cwiseAbs().maxCoeff(&along);
  const double first = from_W[along] + inside.from * way[along], last = from_W[along] + inside.to * way[along];
  const int end = this->cellOf(std::max(first, last) + room_u, along);
  for (int layer = this->cellOf(std::min(first, last) - room_u, along); layer <= end; ++layer)
  {
    const double low = this->low_W_[along] + layer * this->cell_u_ - room_u;
    const Span span = narrowed(inside, from_W[along], way[along], low, low + this->cell_u_ + 2 * room_u);
    if (span.from > span.to)
    {
      continue;
    }
    const Vec3 a_W = from_W + span.from * way, b_W = from_W + span.to * way, room = Vec3::Constant(room_u);
    Vec3 low_W = a_W.cwiseMin(b_W) - room, high_W = a_W.cwiseMax(b_W) + room;
    low_W[along] = high_W[along] = this->low_W_[along] + (layer + 0.5) * this->cell_u_;
    this->forEachCell(low_W, high_W,
      [&](std::size_t cell)
      {
        found.insert(found.end(), this->triangles_.begin() + this->begins_[cell],
          this->triangles_.begin() + this->begins_[cell + 1]);
      });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

int TriangleGrid::cellOf(double value, int axis) const noexcept
{
  const double place = this->cell_u_ > 0 ? (value - this->low_W_[axis]) / this->cell_u_ : 0.0;
  return static_cast<int>(std::clamp(place, 0.0, this->sides_[axis] - 1.0));
}

TriangleGrid::Span TriangleGrid::inside(const Vec3& from_W, const Vec3& to_W, double room_u) const noexcept
{
  Span span;
  for (int axis = 0; axis < 3; ++axis)
  {
    span = narrowed(
      span, from_W[axis], to_W[axis] - from_W[axis], this->low_W_[axis] - room_u, this->high_W_[axis] + room_u);
  }
  return span;
}

template<class Visit>
void TriangleGrid::forEachCell(const Vec3& low_W, const Vec3& high_W, Visit visit) const
{
  std::array<int, 3> first{}, last{};
  for (int axis = 0; axis < 3; ++axis)
  {
    first[axis] = this->cellOf(low_W[axis], axis);
    last[axis] = this->cellOf(high_W[axis], axis);
  }
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        visit((static_cast<std::size_t>(k) * this->sides_[1] + j) * this->sides_[0] + i);
      }
    }
  }
}

template<class Visit>
void TriangleGrid::forEachTriangle(Visit visit) const
{
  for (std::uint32_t t = 0; t < this->mesh_.triangles.size(); ++t)
  {
    const auto [a, b, c] = this->mesh_.triangles[t];
    const Vec3 &va = this->mesh_.vertices_W[a], &vb = this->mesh_.vertices_W[b], &vc = this->mesh_.vertices_W[c];
    this->forEachCell(
      va.cwiseMin(vb).cwiseMin(vc), va.cwiseMax(vb).cwiseMax(vc), [&](std::size_t cell) { visit(cell, t); });
  }
}

} // namespace palpate::test
