// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/curves/CoarserCurves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "haptics/geometry/curves/CurveChains.h"
#include "haptics/geometry/curves/CurveSimplification.h"
#include "haptics/geometry/curves/MultiresolutionCurve.h"
#include "haptics/geometry/tree/TreeWalk.h"

namespace palpate
{
namespace
{

using Segment = std::array<std::uint32_t, 2>;

/// A run that was chosen.
struct Piece
{
  std::uint32_t chain = 0, run = 0;
  Segment ends{};
  Vec3 a_W, b_W;
  double reach_u = 0.0; ///< its bound and rounding
  bool coarse = false;  ///< stands for more than one segment

  [[nodiscard]] Box box() const
  {
    const Vec3 reach = Vec3::Constant(this->reach_u);
    return { this->a_W.cwiseMin(this->b_W) - reach, this->a_W.cwiseMax(this->b_W) + reach };
  }
};

bool shareOneEnd(const Segment& p, const Segment& q)
{
  const auto in = [&q](std::uint32_t end) { return end == q[0] || end == q[1]; };
  return in(p[0]) != in(p[1]);
}

double distanceOf(const Piece& p, const Piece& q)
{
  const double least =
    std::min(std::min(distanceToSegment(p.a_W, q.a_W, q.b_W), distanceToSegment(p.b_W, q.a_W, q.b_W)),
      std::min(distanceToSegment(q.a_W, p.a_W, p.b_W), distanceToSegment(q.b_W, p.a_W, p.b_W)));
  const Vec3 u = p.b_W - p.a_W, v = q.b_W - q.a_W, w = q.a_W - p.a_W, normal = u.cross(v);
  const double normal2 = normal.squaredNorm();
  const double s = w.cross(v).dot(normal), t = w.cross(u).dot(normal);
  const bool inside = normal2 > 0.0 && s >= 0.0 && s <= normal2 && t >= 0.0 && t <= normal2;
  return inside ? std::min(least, std::fabs(w.dot(normal)) / std::sqrt(normal2)) : least;
}

/// Of the distances computed from such points.
double roundingOf(std::span<const Vec3> points_W)
{
  constexpr double operations = 16.0;
  double largest_u = 0.0;
  for (const Vec3& p_W : points_W)
  {
    largest_u = std::max(largest_u, p_W.cwiseAbs().maxCoeff());
  }
  return operations * std::numeric_limits<double>::epsilon() * largest_u;
}

/// Pieces of a chain that are near a piece along the chain, before and behind it.
struct Along
{
  std::size_t before = 0, behind = 0;
};

/// All chosen pieces, chain by chain and in their order, and the pairs that come near each other.
class Round
{
public:
  /// `local_u`: within that distance of a piece's end a chain makes no more than a pocket.
  Round(const std::vector<Piece>& pieces, const std::vector<CurveChain>& chains, double rounding_u, double local_u)
    : pieces_(pieces), chains_(chains), rounding_u_(rounding_u), local_u_(local_u), first_(chains.size() + 1, 0)
  {
    std::vector<Box> boxes;
    boxes.reserve(pieces.size());
    for (const Piece& piece : pieces)
    {
      boxes.push_back(piece.box());
      ++this->first_[piece.chain + 1];
    }
    std::partial_sum(this->first_.begin(), this->first_.end(), this->first_.begin());
    this->tree_ = makeBoxTree(boxes);
  }

  [[nodiscard]] bool meetsAny(std::uint32_t i) const
  {
    const Box box = this->pieces_[i].box();
    const Along along = this->along(i);
    const auto near = [&box](const TreeNode& node) {
      return std::array<bool, 2>{ overlap(boxOf(node, 0), box), overlap(boxOf(node, 1), box) };
    };
    return !walkMeeting(
      this->tree_.nodes, [] { return true; }, near, [&](std::uint32_t j) { return !this->meets(i, j, along); });
  }

private:
  [[nodiscard]] std::size_t countOf(std::uint32_t chain) const { return this->first_[chain + 1] - this->first_[chain]; }

  /// How many steps along its chain piece j is behind piece i; none: j is before i, or on another chain.
  [[nodiscard]] std::size_t stepsTo(std::uint32_t i, std::uint32_t j) const
  {
    constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
    const std::uint32_t chain = this->pieces_[i].chain;
    if (this->pieces_[j].chain != chain || (j < i && !this->chains_[chain].closed()))
    {
      return never;
    }
    return j >= i ? j - i : j + this->countOf(chain) - i;
  }

  [[nodiscard]] Along along(std::uint32_t i) const
  {
    const Piece& piece = this->pieces_[i];
    const std::size_t first = this->first_[piece.chain], count = this->countOf(piece.chain);
    const std::size_t place = i - first;
    const bool ring = this->chains_[piece.chain].closed();
    const auto isNear = [&](std::size_t at, const Vec3& end_W)
    {
      const Piece& other = this->pieces_[first + at % count];
      return (other.a_W - end_W).norm() <= this->local_u_ && (other.b_W - end_W).norm() <= this->local_u_;
    };
    const std::size_t mostBehind = ring ? count - 1 : count - 1 - place, mostBefore = ring ? count - 1 : place;
    Along along;
    while (along.behind < mostBehind && (along.behind == 0 || isNear(place + along.behind, piece.b_W)))
    {
      ++along.behind;
    }
    while (along.before < mostBefore && (along.before == 0 || isNear(place + count - along.before, piece.a_W)))
    {
      ++along.before;
    }
    return along;
  }

  [[nodiscard]] bool meets(std::uint32_t i, std::uint32_t j, const Along& along) const
  {
    const Piece &p = this->pieces_[i], &q = this->pieces_[j];
    if (i == j || shareOneEnd(p.ends, q.ends))
    {
      return false;
    }
    const bool local = this->stepsTo(i, j) <= along.behind || this->stepsTo(j, i) <= along.before;
    return distanceOf(p, q) <= (local ? this->rounding_u_ : p.reach_u + q.reach_u);
  }

  const std::vector<Piece>& pieces_;
  const std::vector<CurveChain>& chains_;
  double rounding_u_, local_u_;
  std::vector<std::size_t> first_; ///< piece of a chain
  BoxTree tree_;
};

class Coarsener
{
public:
  Coarsener(std::span<const Vec3> points_W, double limit_u, const std::stop_token& stop)
    : points_W_(points_W), limit_u_(limit_u), rounding_u_(roundingOf(points_W)), stop_(stop)
  {
  }

  [[nodiscard]] CoarserCurves coarsen(std::span<const Segment> segments)
  {
    this->chains_ = joinSegments(segments, this->points_W_.size());
    std::vector<Piece> pieces;
    for (std::uint32_t i = 0; i < this->chains_.size() && !this->stop_.stop_requested(); ++i)
    {
      this->curves_.push_back(this->curveOf(this->chains_[i]));
      this->take(i, 0, pieces);
    }
    while (!this->stop_.stop_requested() && this->halveWhatMeets(pieces))
    {
    }
    return this->stop_.stop_requested() ? CoarserCurves() : resultOf(pieces);
  }

private:
  [[nodiscard]] MultiresolutionCurve curveOf(const CurveChain& chain) const
  {
    std::vector<Vec3> along_W;
    along_W.reserve(chain.points.size());
    for (const std::uint32_t point : chain.points)
    {
      along_W.push_back(this->points_W_[point]);
    }
    return MultiresolutionCurve(std::move(along_W));
  }

  [[nodiscard]] Piece pieceOf(std::uint32_t chain, std::uint32_t index) const
  {
    const CurveRun& run = this->curves_[chain].runs()[index];
    const std::uint32_t a = this->chains_[chain].points[run.from], b = this->chains_[chain].points[run.to];
    const bool coarse = run.halves != 0;
    const double reach_u = (coarse ? run.bound_u : 0.0) + this->rounding_u_;
    return { chain, index, { a, b }, this->points_W_[a], this->points_W_[b], reach_u, coarse };
  }

  /// The coarsest runs of this one that are near enough, from its beginning to its end.
  void take(std::uint32_t chain, std::uint32_t root, std::vector<Piece>& pieces) const
  {
    constexpr int leastLevelOfRing = 2;
    const int leastLevel = this->chains_[chain].closed() ? leastLevelOfRing : 0;
    std::vector<std::uint32_t> open{ root };
    while (!open.empty())
    {
      const std::uint32_t index = open.back();
      const CurveRun& run = this->curves_[chain].runs()[index];
      open.pop_back();
      if (run.halves && (run.level < leastLevel || run.bound_u + this->rounding_u_ > this->limit_u_))
      {
        open.push_back(run.halves + 1);
        open.push_back(run.halves);
        continue;
      }
      pieces.push_back(this->pieceOf(chain, index));
    }
  }

  /// False if there was nothing to halve.
  [[nodiscard]] bool halveWhatMeets(std::vector<Piece>& pieces) const
  {
    if (std::none_of(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.coarse; }))
    {
      return false;
    }
    const Round round(pieces, this->chains_, this->rounding_u_, 2 * this->limit_u_);
    std::vector<Piece> next;
    for (std::uint32_t i = 0; i < pieces.size() && !this->stop_.stop_requested(); ++i)
    {
      const Piece& piece = pieces[i];
      if (!piece.coarse || !round.meetsAny(i))
      {
        next.push_back(piece);
        continue;
      }
      const std::uint32_t halves = this->curves_[piece.chain].runs()[piece.run].halves;
      this->take(piece.chain, halves, next);
      this->take(piece.chain, halves + 1, next);
    }
    const bool halved = next.size() != pieces.size();
    pieces = std::move(next);
    return halved;
  }

  [[nodiscard]] static CoarserCurves resultOf(const std::vector<Piece>& pieces)
  {
    CoarserCurves result;
    result.segments.reserve(pieces.size());
    for (const Piece& piece : pieces)
    {
      result.segments.push_back(piece.ends);
      result.bound_u = std::max(result.bound_u, piece.coarse ? piece.reach_u : 0.0);
    }
    return result;
  }

  std::span<const Vec3> points_W_;
  double limit_u_, rounding_u_;
  const std::stop_token& stop_;
  std::vector<CurveChain> chains_;
  std::vector<MultiresolutionCurve> curves_;
};

} // namespace

CoarserCurves coarsestWithin(
  std::span<const Vec3> points_W, std::span<const Segment> segments, double limit_u, const std::stop_token& stop)
{
  return Coarsener(points_W, limit_u, stop).coarsen(segments);
}

} // namespace palpate
