// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/MultiresolutionCurve.h"

#include <algorithm>
#include <utility>

#include "haptics/geometry/CurveSimplification.h"

namespace palpate
{
namespace
{

std::uint32_t middle(std::uint32_t from, std::uint32_t to)
{
  return from + (to - from) / 2;
}

} // namespace

MultiresolutionCurve::MultiresolutionCurve(std::vector<Vec3> points_W) : points_W_(std::move(points_W))
{
  if (this->points_W_.size() >= 2)
  {
    this->divide();
    this->bound();
  }
}

void MultiresolutionCurve::divide()
{
  const auto last = static_cast<std::uint32_t>(this->points_W_.size() - 1);
  this->nodes_.reserve(2 * this->points_W_.size());
  this->nodes_.push_back({ 0, last });
  for (std::size_t i = 0; i < this->nodes_.size(); ++i)
  {
    const Node node = this->nodes_[i];
    if (node.to - node.from > 1)
    {
      const std::uint32_t m = middle(node.from, node.to);
      this->nodes_[i].halves = static_cast<std::uint32_t>(this->nodes_.size());
      this->nodes_.push_back({ node.from, m, 0, node.level + 1 });
      this->nodes_.push_back({ m, node.to, 0, node.level + 1 });
    }
  }
}

double MultiresolutionCurve::detail_u(const Node& node) const noexcept
{
  return distanceToSegment(
    this->points_W_[middle(node.from, node.to)], this->points_W_[node.from], this->points_W_[node.to]);
}

void MultiresolutionCurve::bound()
{
  this->levelBound_u_.assign(static_cast<std::size_t>(this->nodes_.back().level) + 1, 0.0);
  for (std::size_t i = this->nodes_.size(); i-- > 0;) // halves lie behind the whole
  {
    Node& node = this->nodes_[i];
    if (node.halves)
    {
      const double halves_u = std::max(this->nodes_[node.halves].bound_u, this->nodes_[node.halves + 1].bound_u);
      node.bound_u = this->detail_u(node) + halves_u;
      double& level_u = this->levelBound_u_[static_cast<std::size_t>(node.level)];
      level_u = std::max(level_u, node.bound_u);
    }
  }
}

template<class Enough>
std::vector<std::uint32_t> MultiresolutionCurve::cut(Enough enough) const
{
  std::vector<std::uint32_t> kept;
  std::vector<std::uint32_t> open;
  if (!this->nodes_.empty())
  {
    kept.push_back(0);
    open.push_back(0);
  }
  while (!open.empty())
  {
    const Node& node = this->nodes_[open.back()];
    open.pop_back();
    if (!node.halves || enough(node))
    {
      kept.push_back(node.to);
      continue;
    }
    open.push_back(node.halves + 1);
    open.push_back(node.halves);
  }
  return kept;
}

std::vector<std::uint32_t> MultiresolutionCurve::level(int level) const
{
  return this->cut([level](const Node& node) { return node.level == level; });
}

std::vector<std::uint32_t> MultiresolutionCurve::choose(const CurveDetail& detail) const
{
  return this->cut(
    [&](const Node& node)
    {
      const double distance_u =
        distanceToSegment(detail.focus_W, this->points_W_[node.from], this->points_W_[node.to]) - node.bound_u;
      return node.bound_u <= detail.allowed_u(distance_u);
    });
}

} // namespace palpate
