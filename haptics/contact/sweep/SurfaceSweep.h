// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

#include "haptics/contact/sweep/DiscFilter.h"
#include "haptics/contact/sweep/Work.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/contact/view/SweepQuery.h"
#include "haptics/contact/view/SweptBall.h"
#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/tree/SegmentTriangle.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

/// From so many squared radii on a way is long.
inline constexpr double longWay2 = 1e4;

[[nodiscard]] inline bool isTouched(const SweepQuery& query, const ActiveFeature& f) noexcept
{
  return std::any_of(query.touched.begin(), query.touched.end(),
    [&f](const ActiveFeature& a) { return a.surface == f.surface && a.kind == f.kind && a.a == f.a && a.b == f.b; });
}

/// True if the way surely keeps clear of a triangle where it is now. A triangle on its way has a ball where others have
/// a disc, so many that are asked for are not near; and to make a whole face of each would be most of a tick, unless it
/// is kept for the next question.
[[nodiscard]] inline bool isClear(const BentSurface& shape, std::uint32_t triangle, const SweptBall& m) noexcept
{
  if (!shape.bends() || shape.keepsFaces())
  {
    return false;
  }
  const auto [a, b, c] = shape.cornersOf(triangle);
  const Vec3 reach = Vec3::Constant(m.r + m.tol);
  const Vec3 low = m.x_W.cwiseMin(m.e_W) - reach, high = m.x_W.cwiseMax(m.e_W) + reach;
  if ((a.cwiseMin(b).cwiseMin(c).array() > high.array()).any() ||
      (a.cwiseMax(b).cwiseMax(c).array() < low.array()).any())
  {
    return true;
  }
  constexpr double thin = 1e-6, rounding = 1e-9; // the normal of any thicker triangle is told better than that
  const Vec3 e = b - a, f = c - a, cross = e.cross(f);
  const double area2 = cross.squaredNorm(), d0 = cross.dot(m.x_W - a), d1 = d0 + cross.dot(m.d);
  const double least2 = (1.0 + rounding) * m.r * m.r * area2;
  return m.r > 0.0 && area2 > thin * e.squaredNorm() * f.squaredNorm() && (d0 > 0.0) == (d1 > 0.0) &&
         d0 * d0 > least2 && d1 * d1 > least2;
}
[[nodiscard]] inline bool isClear(const SurfaceData&, std::uint32_t, const SweptBall&) noexcept
{
  return false;
}

/// The exact tests of one surface's faces, edges and vertices, and the best hit so far. All in the surface's own frame:
/// a point is mapped there the same way each time, so that a proven path stays free.
template<class Shape>
class SurfaceSweep
{
public:
  SurfaceSweep(const Shape& shape, std::uint32_t surface, const SweepQuery& query, const SweptBall& m, SweepHit& best)
    : shape_(shape), data_(dataOf(shape)), surface_(surface), query_(query), m_(m), best_(best)
  {
  }

  void testLeaf(std::uint32_t index) noexcept
  {
    const Leaf& leaf = this->data_.leaves[index];
    const DiscFilter filter(this->m_, leaf.origin_W, leaf.perUnit);
    int lanes = filter.touched(discsOf(this->shape_, 2 * index));
    if (leaf.count > 4)
    {
      lanes |= filter.touched(discsOf(this->shape_, 2 * index + 1)) << 4;
    }
    lanes &= (1 << leaf.count) - 1;
    forEachLane(lanes, [&](std::uint32_t lane) noexcept { this->testTriangle(leaf.first + lane); });
  }

  void testTriangle(std::uint32_t triangle) noexcept
  {
    this->best_.work += work::faceTest;
    if (!isClear(this->shape_, triangle, this->m_))
    {
      this->m_.r > 0.0 ? this->testBall(triangle) : this->testPoint(triangle);
    }
  }

private:
  void testBall(std::uint32_t triangle) noexcept
  {
    const FaceRecord& face = this->shape_.face(triangle);
    if (hasArea(this->shape_, face))
    {
      if (this->staysAbove(face))
      {
        return;
      }
      this->testFace(triangle, face);
    }
    const auto& corners = this->data_.corners(triangle);
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      if (face.owned & (ownsEdge0 << k))
      {
        const auto [low, high] = corners[k] < corners[next] ? std::array{ k, next } : std::array{ next, k };
        this->testEdge(corners[low], corners[high], face.corner_W[low], face.corner_W[high]);
      }
      if (face.owned & (ownsVertex0 << k))
      {
        this->testVertex(corners[k], face.corner_W[k]);
      }
    }
  }

  /// True if the ball keeps so far from the plane of a face that it surely gets to neither face nor border: the quick
  /// answer for most features beside a sliding ball.
  [[nodiscard]] bool staysAbove(const FaceRecord& face) const noexcept
  {
    const SweptBall& m = this->m_;
    const Vec3 away = m.x_W - face.corner_W[0];
    const double d0 = face.normal_W.dot(away), d1 = d0 + face.normal_W.dot(m.d);
    const double least = m.r - 0.5 * m.tol;
    if (!((d0 >= least && d1 >= least) || (d0 <= -least && d1 <= -least)))
    {
      return false;
    }
    const double rounding =
      8 * std::numeric_limits<double>::epsilon() * double(face.sliver) * (away.cwiseAbs().sum() + m.d.cwiseAbs().sum());
    return rounding <= 0.5 * m.tol;
  }

  void testFace(std::uint32_t triangle, const FaceRecord& face) noexcept
  {
    const SweptBall& m = this->m_;
    const double signedDistance = face.normal_W.dot(m.x_W - face.corner_W[0]);
    const double side = signedDistance >= 0.0 ? 1.0 : -1.0;
    const double distance = side * signedDistance;
    const double rate = side * face.normal_W.dot(m.d);
    if (rate >= 0.0 || distance + rate >= m.r - m.tol || distance <= 0.5 * m.r)
    {
      return;
    }
    double t = std::max(0.0, (distance - m.r) / -rate);
    if (t <= this->best_.t && (this->isOver(face, t) || this->comesOver(face, distance, rate, t)))
    {
      this->offer(t, { this->surface_, triangle, 0, FeatureKind::Face, static_cast<std::int8_t>(side), false });
    }
  }

  /// True if the centre projects into the face at t.
  [[nodiscard]] bool isOver(const FaceRecord& face, double t) const noexcept
  {
    const Vec3 centre_W = this->m_.x_W + t * this->m_.d;
    for (int k = 0; k < 3; ++k)
    {
      const Vec3& a = face.corner_W[k];
      const Vec3 e = face.corner_W[(k + 1) % 3] - a;
      if (e.cross(face.normal_W).dot(centre_W - a) > 0.0)
      {
        return false;
      }
    }
    return true;
  }

  /// A ball that hardly sinks may reach the plane of a face before it is over the face, too little below the plane to
  /// meet the border, and get deeper than rounding later. Contact is then the moment when the ball comes over the face.
  /// t: in, when the plane is reached; out, that moment.
  [[nodiscard]] bool comesOver(const FaceRecord& face, double distance, double rate, double& t) const noexcept
  {
    const SweptBall& m = this->m_;
    const double limit = m.r - m.tol;
    double out = 1.0;
    for (int k = 0; k < 3; ++k)
    {
      const Vec3& a = face.corner_W[k];
      const Vec3 outward = (face.corner_W[(k + 1) % 3] - a).cross(face.normal_W);
      const double outside = outward.dot(m.x_W - a), leaving = outward.dot(m.d);
      if (outside + t * leaving > 0.0)
      {
        t = leaving < 0.0 ? -outside / leaving : 2.0;
        if (t > 1.0 || distance + t * rate < limit - m.tol)
        {
          return false; // never, or surely deep enough to meet the border first
        }
      }
      else if (leaving > 0.0)
      {
        out = std::min(out, -outside / leaving);
      }
    }
    return out > t && distance + out * rate < limit;
  }

  /// a, b: the places of vertices i and j.
  void testEdge(std::uint32_t i, std::uint32_t j, const Vec3& a, const Vec3& b) noexcept
  {
    const SweptBall& m = this->m_;
    const Vec3 e = b - a;
    const double length2 = e.squaredNorm();
    const Vec3 away = m.x_W - a;
    if (this->keepsFromLine(away, e, length2))
    {
      return;
    }
    const double awayAlong = away.dot(e) / length2, dAlong = m.d.dot(e) / length2;
    const Vec3 w = away - awayAlong * e, d = m.d - dAlong * e;
    double t = this->roundHit(w, d);
    const double along = awayAlong + t * dAlong;
    if ((along >= 0.0 && along <= 1.0) || this->comesBeside(w, d, awayAlong, dAlong, t))
    {
      this->offer(t, { this->surface_, i, j, FeatureKind::Edge, 1, false });
    }
  }

  /// True if the ball surely goes away from the line of an edge, or keeps further from it than its radius: the quick
  /// answer for most edges beside the ball, without a division by their length. All is multiplied by length2.
  [[nodiscard]] bool keepsFromLine(const Vec3& away, const Vec3& e, double length2) const noexcept
  {
    constexpr double sure = 1e-9; // share of a summand: a million times its rounding
    const SweptBall& m = this->m_;
    const double along = away.dot(e), rate = m.d.dot(e), away2 = away.squaredNorm();
    const double towards = away.dot(m.d) * length2 - along * rate;
    if (towards > 0.0 && towards * towards > sure * sure * away2 * m.dd * length2 * length2)
    {
      return true;
    }
    const double ww = away2 * length2 - along * along, dd = m.dd * length2 - rate * rate;
    const double excess = ww - (m.r * m.r + sure * (away2 + m.dd)) * length2;
    return -towards >= dd ? excess + 2 * towards + dd > 0.0 : excess > 0.0 && excess * dd > towards * towards;
  }

  /// A ball that goes nearly along an edge may be at the distance of its line before the ball is beside the edge, too
  /// little nearer to meet the end, and get deeper than rounding later. Contact is then the moment when the ball comes
  /// beside the edge. w, d: as in roundHit(), across the edge; along it the way goes from `along` by `rate` edges. t:
  /// in, when the line is reached, NaN if it is not; out, that moment.
  [[nodiscard]] bool comesBeside(const Vec3& w, const Vec3& d, double along, double rate, double& t) const noexcept
  {
    const double enters = (rate > 0.0 ? -along : 1.0 - along) / rate,
                 leaves = (rate > 0.0 ? 1.0 - along : -along) / rate;
    if (!(enters > t && enters <= 1.0))
    {
      return false;
    }
    t = enters;
    const double limit = this->m_.r - this->m_.tol, surelyMet = limit - this->m_.tol;
    const double nearest = std::clamp(-w.dot(d) / d.squaredNorm(), enters, std::min(leaves, 1.0));
    return (w + enters * d).squaredNorm() >= surelyMet * surelyMet && (w + nearest * d).squaredNorm() < limit * limit;
  }

  void testVertex(std::uint32_t v, const Vec3& corner_W) noexcept
  {
    this->offer(
      this->roundHit(this->m_.x_W - corner_W, this->m_.d), { this->surface_, v, 0, FeatureKind::Vertex, 1, false });
  }

  /// First t at which |w + t d| = r for a way that gets nearer than r - tol; NaN if it does not.
  [[nodiscard, gnu::always_inline]] double roundHit(const Vec3& w, const Vec3& d) const noexcept
  {
    constexpr double miss = std::numeric_limits<double>::quiet_NaN();
    const SweptBall& m = this->m_;
    const double b = w.dot(d), a = d.squaredNorm(), ww = w.squaredNorm();
    if (b >= 0.0)
    {
      return miss;
    }
    const double nearest = std::min(1.0, -b / a);
    const double limit = m.r - m.tol;
    if ((w + nearest * d).squaredNorm() >= limit * limit)
    {
      return miss;
    }
    if (a > longWay2 * m.r * m.r)
    {
      return this->timeOfEntry(w, d, a);
    }
    const double distance = std::sqrt(ww);
    const double c = (distance - m.r) * (distance + m.r);
    return c <= 0.0 ? 0.0 : c / (-b + std::sqrt(std::max(0.0, b * b - a * c)));
  }

  /// The same for a way that is so long against the ball that squares of it would lose the radius: from where it comes
  /// nearest, back by the rest of the radius there.
  [[nodiscard]] double timeOfEntry(const Vec3& w, const Vec3& d, double a) const noexcept
  {
    double t = -w.dot(d) / a;
    Vec3 foot = w + t * d;
    t -= foot.dot(d) / a;
    foot = w + t * d;
    const double r = this->m_.r;
    return std::max(0.0, t - std::sqrt(std::max(0.0, (r - foot.norm()) * (r + foot.norm()) / a)));
  }

  /// The closed way against the closed triangle, exactly.
  void testPoint(std::uint32_t triangle) noexcept
  {
    const SweptBall& m = this->m_;
    const FaceRecord& face = this->shape_.face(triangle);
    if (!hasArea(this->shape_, face))
    {
      return;
    }
    const auto& [a, b, c] = face.corner_W;
    const double s0 = face.normal_W.dot(m.x_W - a), s1 = face.normal_W.dot(m.e_W - a);
    const double largest =
      std::max({ m.magnitude, a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff() });
    const double unsure = 8 * std::numeric_limits<double>::epsilon() * double(face.sliver) * largest;
    if ((s0 > unsure && s1 > unsure) || (s0 < -unsure && s1 < -unsure))
    {
      return;
    }
    const int o0 = orientation(a, b, c, m.x_W), o1 = orientation(a, b, c, m.e_W);
    this->best_.work += o0 != 0 && o1 != 0 ? work::pointTest : work::exactTest;
    if (o0 != 0 && o0 == o1)
    {
      return;
    }
    const bool flat = o0 == 0 && o1 == 0;
    if (flat ? !meetsInPlane(m.x_W, m.e_W, face) : !linePassesThrough(m.x_W, m.e_W, face))
    {
      return;
    }
    const int side = o0 != 0 ? o0 : (o1 != 0 ? -o1 : 1);
    const double span = std::fabs(s0) + std::fabs(s1);
    const double t = o0 == 0 || span == 0.0 ? 0.0 : std::min(1.0, std::fabs(s0) / span);
    this->offer(t, { this->surface_, triangle, 0, FeatureKind::Face, static_cast<std::int8_t>(side), false });
  }

  void offer(double t, const ActiveFeature& f) noexcept
  {
    const auto key = [](const ActiveFeature& g) { return std::tie(g.kind, g.surface, g.a, g.b); };
    if (!(t <= this->best_.t) || (t == this->best_.t && this->best_.hit && !(key(f) < key(this->best_.feature))))
    {
      return;
    }
    if (isTouched(this->query_, f))
    {
      return;
    }
    this->best_.hit = true;
    this->best_.t = t;
    this->best_.feature = f;
  }

  const Shape& shape_;
  const SurfaceData& data_;
  std::uint32_t surface_;
  const SweepQuery& query_;
  const SweptBall& m_;
  SweepHit& best_;
};

} // namespace palpate
