// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

#include "haptics/geometry/CurveChains.h"
#include "haptics/geometry/InkLines.h"

namespace palpate
{
namespace
{

std::vector<int> degrees(const LooseLines& lines)
{
  std::vector<int> degree(lines.points_W.size(), 0);
  for (const auto& [a, b] : lines.segments)
  {
    ++degree[a];
    ++degree[b];
  }
  return degree;
}

double length_u(const LooseLines& lines, const CurveChain& chain)
{
  double length = 0.0;
  for (std::size_t i = 1; i < chain.points.size(); ++i)
  {
    length += (lines.points_W[chain.points[i]] - lines.points_W[chain.points[i - 1]]).norm();
  }
  return length;
}

void leaveOutHooks(LooseLines& lines, double gap_u)
{
  const std::vector<int> degree = degrees(lines);
  std::vector<std::array<std::uint32_t, 2>> kept;
  for (const CurveChain& chain : joinSegments(lines.segments, lines.points_W.size()))
  {
    const int a = degree[chain.points.front()], b = degree[chain.points.back()];
    if (std::min(a, b) == 1 && std::max(a, b) > 2 && length_u(lines, chain) < gap_u)
    {
      continue;
    }
    for (std::size_t i = 1; i < chain.points.size(); ++i)
    {
      kept.push_back({ chain.points[i - 1], chain.points[i] });
    }
  }
  lines.segments = std::move(kept);
}

/// Points by square cells as wide as the gap.
class Cells
{
public:
  Cells(const LooseLines& lines, double size_u) : lines_(lines), size_u_(size_u) {}

  void add(std::uint32_t point) { this->cells_[this->key(this->lines_.points_W[point], 0, 0)].push_back(point); }

  /// The nearest point no farther than a cell that `accepts` says yes to; the smaller index of equals.
  template<class Accepts>
  [[nodiscard]] std::optional<std::uint32_t> nearest(std::uint32_t from, Accepts accepts) const
  {
    const Vec3& p_W = this->lines_.points_W[from];
    std::optional<std::uint32_t> found;
    double least_u = this->size_u_;
    for (int cell = 0; cell < 9; ++cell)
    {
      const auto here = this->cells_.find(this->key(p_W, cell % 3 - 1, cell / 3 - 1));
      for (std::size_t i = 0; here != this->cells_.end() && i < here->second.size(); ++i)
      {
        const std::uint32_t other = here->second[i];
        const double distance_u = (this->lines_.points_W[other] - p_W).norm();
        const bool nearer = distance_u < least_u || (distance_u == least_u && (!found || other < *found));
        if (nearer && accepts(other))
        {
          found = other;
          least_u = distance_u;
        }
      }
    }
    return found;
  }

private:
  [[nodiscard]] std::uint64_t key(const Vec3& p_W, int dx, int dy) const
  {
    const auto x = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(p_W.x() / this->size_u_)) + dx);
    const auto y = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(p_W.y() / this->size_u_)) + dy);
    return static_cast<std::uint64_t>(y) << 32 | x;
  }

  const LooseLines& lines_;
  double size_u_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

/// The chain each point is inside of or ends in; of those that meet in a point any.
std::vector<std::uint32_t> chainOfPoints(const std::vector<CurveChain>& chains, std::size_t pointCount)
{
  std::vector<std::uint32_t> chainOf(pointCount, std::numeric_limits<std::uint32_t>::max());
  for (std::uint32_t i = 0; i < chains.size(); ++i)
  {
    for (const std::uint32_t point : chains[i].points)
    {
      chainOf[point] = i;
    }
  }
  return chainOf;
}

} // namespace

void mendGaps(LooseLines& lines, double gap_u)
{
  leaveOutHooks(lines, gap_u);
  const std::vector<int> degree = degrees(lines);
  const std::vector<CurveChain> chains = joinSegments(lines.segments, lines.points_W.size());
  const std::vector<std::uint32_t> chainOf = chainOfPoints(chains, lines.points_W.size());
  Cells cells(lines, gap_u);
  for (std::uint32_t point = 0; point < lines.points_W.size(); ++point)
  {
    if (degree[point] > 0)
    {
      cells.add(point);
    }
  }
  for (const CurveChain& chain : chains)
  {
    for (const bool last : { false, true })
    {
      const std::uint32_t end = last ? chain.points.back() : chain.points.front();
      const std::uint32_t otherEnd = last ? chain.points.front() : chain.points.back();
      const auto accepts = [&](std::uint32_t point)
      { return chainOf[point] != chainOf[end] || (point == otherEnd && length_u(lines, chain) > 2 * gap_u); };
      if (const auto found = degree[end] == 1 ? cells.nearest(end, accepts) : std::nullopt)
      {
        lines.segments.push_back({ end, *found });
      }
    }
  }
}

} // namespace palpate
