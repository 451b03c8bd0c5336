// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <unordered_map>

#include "haptics/geometry/curves/CurveChains.h"
#include "haptics/geometry/ink/InkRims.h"

namespace palpate
{
namespace
{

/// A gap is one where the path along the lines is longer than this many times the straight one.
constexpr double leastDetour = 2.0;
/// So that a gap of three pixels of 0.1 is one of 0.3.
constexpr double rounding = 1e-9;
/// Of the work.
constexpr double rimsShare = 0.5;
constexpr std::size_t endsPerReport = 256;
constexpr double nowhere = std::numeric_limits<double>::infinity();

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

double length_u(const LooseLines& lines, const Ruler& ruler, const CurveChain& chain)
{
  double length = 0.0;
  for (std::size_t i = 1; i < chain.points.size(); ++i)
  {
    length += ruler.length_u(lines.points_W[chain.points[i]], lines.points_W[chain.points[i - 1]]);
  }
  return length;
}

void leaveOutHooks(LooseLines& lines, const Ruler& ruler, double gap_u)
{
  const std::vector<int> degree = degrees(lines);
  std::vector<std::array<std::uint32_t, 2>> kept;
  for (const CurveChain& chain : joinSegments(lines.segments, lines.points_W.size()))
  {
    const int a = degree[chain.points.front()], b = degree[chain.points.back()];
    if (std::min(a, b) == 1 && std::max(a, b) > 2 && length_u(lines, ruler, chain) < gap_u)
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

/// Length of the path along the lines from one point to others: Dijkstra's search, which goes on from where it stands
/// when it is asked for more.
class Ways
{
public:
  Ways(const LooseLines& lines, const Ruler& ruler)
    : lines_(lines), ruler_(ruler), first_(lines.points_W.size() + 1, 0), others_(2 * lines.segments.size())
  {
    for (const auto& [a, b] : lines.segments)
    {
      ++this->first_[a + 1];
      ++this->first_[b + 1];
    }
    std::partial_sum(this->first_.begin(), this->first_.end(), this->first_.begin());
    std::vector<std::size_t> next(this->first_.begin(), this->first_.end() - 1);
    for (const auto& [a, b] : lines.segments)
    {
      this->others_[next[a]++] = b;
      this->others_[next[b]++] = a;
    }
  }

  void startFrom(std::uint32_t point)
  {
    this->done_.clear();
    this->open_ = {};
    this->open_.push({ 0.0, point });
  }

  [[nodiscard]] bool isWithin(std::uint32_t point, double limit_u)
  {
    for (; !this->open_.empty() && this->open_.top().first <= limit_u;)
    {
      const auto [way_u, here] = this->open_.top();
      this->open_.pop();
      if (!this->done_.try_emplace(here, way_u).second)
      {
        continue;
      }
      for (std::size_t i = this->first_[here]; i < this->first_[here + 1]; ++i)
      {
        const std::uint32_t to = this->others_[i];
        this->open_.push({ way_u + this->ruler_.length_u(this->lines_.points_W[here], this->lines_.points_W[to]), to });
      }
    }
    const auto found = this->done_.find(point);
    return found != this->done_.end() && found->second <= limit_u;
  }

private:
  using Step = std::pair<double, std::uint32_t>;

  const LooseLines& lines_;
  const Ruler& ruler_;
  std::vector<std::size_t> first_;    ///< where the neighbours of a point begin
  std::vector<std::uint32_t> others_; ///< the neighbours
  std::unordered_map<std::uint32_t, double> done_;
  std::priority_queue<Step, std::vector<Step>, std::greater<>> open_;
};

/// The rim of each free end: the tip of its stroke.
std::map<std::uint32_t, std::vector<Vec3>> tipsOf(const std::vector<RimPixel>& rims, const std::vector<int>& degree)
{
  std::map<std::uint32_t, std::vector<Vec3>> tips;
  for (const RimPixel& pixel : rims)
  {
    if (degree[pixel.point] == 1)
    {
      tips[pixel.point].push_back(pixel.place);
    }
  }
  return tips;
}

} // namespace

void mendGaps(LooseLines& lines, const Bitmap& drawing, const Eigen::Vector2d& pixel_u, double gap_u, const Goes& goes)
{
  const Ruler ruler(pixel_u);
  leaveOutHooks(lines, ruler, gap_u);
  const std::vector<RimPixel> rims = rimsOf(lines, drawing, ruler, partOf(goes, 0.0, rimsShare));
  const RimCells cells(rims, ruler, gap_u);
  Ways ways(lines, ruler);
  std::vector<std::array<std::uint32_t, 2>> joints;
  const std::map<std::uint32_t, std::vector<Vec3>> tips = tipsOf(rims, degrees(lines));
  const Goes joining = partOf(goes, rimsShare, 1.0);
  Steps steps(joining, endsPerReport);
  std::size_t done = 0;
  for (const auto& [end, tip] : tips)
  {
    if (!steps.go(done++, tips.size()))
    {
      return;
    }
    ways.startFrom(end);
    // Sides of the same stroke, and of one that branches from it, are near but no gap lies between.
    const auto jointLength_u = [&, end = end](std::uint32_t point)
    {
      const double straight_u = ruler.length_u(lines.points_W[end], lines.points_W[point]);
      return ways.isWithin(point, leastDetour * straight_u) ? nowhere : straight_u;
    };
    Joint best{ gap_u * (1.0 + rounding), nowhere, 0 };
    for (const Vec3& pixel : tip)
    {
      cells.lookFrom(pixel, jointLength_u, best);
    }
    if (std::isfinite(best.length_u))
    {
      joints.push_back({ end, best.point });
    }
  }
  lines.segments.insert(lines.segments.end(), joints.begin(), joints.end());
}

} // namespace palpate
