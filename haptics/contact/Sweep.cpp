// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/Sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include <emmintrin.h>

#include "haptics/geometry/ExactPredicates.h"
#include "haptics/geometry/SurfaceData.h"

namespace palpate
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What of a query does not change from leaf to leaf.
struct Motion
{
  Vec3 x_W, e_W, d;
  Vec3 low_W, high_W;      ///< box of the swept ball, grown by what rounding may hide
  Vec3 inverse, zeroBias;  ///< 1 / d, and an infinity where d is zero
  double r, del, tol, magnitude;
  double dd;               ///< |d|^2
};

Motion motionOf(const SweepQuery& q) noexcept
{
  Motion m;
  m.x_W = q.from_W;
  m.e_W = q.to_W;
  m.d = q.to_W - q.from_W;
  m.r = q.radius_u;
  m.del = q.resolution.del();
  m.tol = q.resolution.tol();
  m.magnitude = q.resolution.magnitude;
  m.dd = m.d.squaredNorm();
  const Vec3 reach = Vec3::Constant(m.r + m.tol);
  m.low_W = m.x_W.cwiseMin(m.e_W) - reach;
  m.high_W = m.x_W.cwiseMax(m.e_W) + reach;
  for (int k = 0; k < 3; ++k)
  {
    const bool moves = std::fabs(m.d[k]) > 1e-290;
    m.inverse[k] = moves ? 1.0 / m.d[k] : 0.0;
    m.zeroBias[k] = moves ? 0.0 : infinity;
  }
  return m;
}

/// Earliest fraction of the way at which the swept ball can touch the box, or infinity.
double entryTime(const Motion& m, const Vec3& low_W, const Vec3& high_W) noexcept
{
  if ((low_W.array() > m.high_W.array()).any() || (high_W.array() < m.low_W.array()).any())
  {
    return infinity;
  }
  const double grow = m.r + m.tol;
  double entry = 0.0, exit = 1.0;
  for (int k = 0; k < 3; ++k)
  {
    const double t0 = (low_W[k] - grow - m.x_W[k]) * m.inverse[k];
    const double t1 = (high_W[k] + grow - m.x_W[k]) * m.inverse[k];
    entry = std::max(entry, std::min(t0, t1) - m.zeroBias[k]);
    exit = std::min(exit, std::max(t0, t1) + m.zeroBias[k]);
  }
  // The slab arithmetic rounds; a box is only passed over when it is missed by more than that.
  constexpr double roundOff = 1e-12;
  return entry <= exit + roundOff ? std::max(0.0, entry - roundOff) : infinity;
}

/// Four discs against the swept ball in single precision; bit k is set where lane k may be touched.
class DiscFilter
{
public:
  DiscFilter(const Motion& m, const Vec3& origin_W) noexcept
  {
    const Vec3 q = m.x_W - origin_W;
    this->q_ = { _mm_set1_ps(float(q.x())), _mm_set1_ps(float(q.y())), _mm_set1_ps(float(q.z())) };
    this->d_ = { _mm_set1_ps(float(m.d.x())), _mm_set1_ps(float(m.d.y())), _mm_set1_ps(float(m.d.z())) };
    this->dd_ = _mm_set1_ps(float(m.dd));
    // Single precision loses 1e-7 of the numbers it handles; a hundred times that is allowed for.
    const double lost = 1e-5 * (q.cwiseAbs().maxCoeff() + m.d.cwiseAbs().maxCoeff() + m.r);
    this->lost_ = _mm_set1_ps(float(lost));
    this->reach_ = _mm_set1_ps(float(m.r + m.tol + lost));
  }

  [[nodiscard]] int touched(const DiscQuad& quad) const noexcept
  {
    const Triple n = { _mm_load_ps(quad.nx.data()), _mm_load_ps(quad.ny.data()), _mm_load_ps(quad.nz.data()) };
    const Triple q = { _mm_sub_ps(this->q_.x, _mm_load_ps(quad.cx.data())),
      _mm_sub_ps(this->q_.y, _mm_load_ps(quad.cy.data())), _mm_sub_ps(this->q_.z, _mm_load_ps(quad.cz.data())) };
    const __m128 zero = _mm_setzero_ps();
    const __m128 h0 = dot(n, q), hd = dot(n, this->d_);
    const __m128 h1 = _mm_add_ps(h0, hd);
    const __m128 crosses = _mm_cmple_ps(_mm_mul_ps(h0, h1), zero);
    __m128 h = _mm_andnot_ps(crosses, _mm_min_ps(absolute(h0), absolute(h1)));
    h = _mm_max_ps(zero, _mm_sub_ps(h, this->lost_));
    // Distance of the way from the disc's axis, in the disc's plane.
    const __m128 qd = _mm_sub_ps(dot(q, this->d_), _mm_mul_ps(h0, hd));
    const __m128 ddLateral = _mm_max_ps(_mm_sub_ps(this->dd_, _mm_mul_ps(hd, hd)), zero);
    const __m128 safe = _mm_max_ps(ddLateral, _mm_set1_ps(std::numeric_limits<float>::min()));
    const __m128 t = _mm_min_ps(_mm_max_ps(_mm_div_ps(_mm_sub_ps(zero, qd), safe), zero), _mm_set1_ps(1.0f));
    const Triple c = { at(q.x, this->d_.x, t), at(q.y, this->d_.y, t), at(q.z, this->d_.z, t) };
    const __m128 hc = _mm_add_ps(h0, _mm_mul_ps(t, hd));
    const Triple lateral = { at(c.x, n.x, _mm_sub_ps(zero, hc)), at(c.y, n.y, _mm_sub_ps(zero, hc)),
      at(c.z, n.z, _mm_sub_ps(zero, hc)) };
    const __m128 radius = _mm_add_ps(_mm_load_ps(quad.radius.data()), this->lost_);
    const __m128 excess = _mm_max_ps(zero, _mm_sub_ps(_mm_sqrt_ps(dot(lateral, lateral)), radius));
    const __m128 distance2 = _mm_add_ps(_mm_mul_ps(h, h), _mm_mul_ps(excess, excess));
    const __m128 clear = _mm_cmpgt_ps(distance2, _mm_mul_ps(this->reach_, this->reach_));
    return ~_mm_movemask_ps(clear) & 15;
  }

private:
  struct Triple
  {
    __m128 x, y, z;
  };
  static __m128 dot(const Triple& a, const Triple& b) noexcept
  {
    return _mm_add_ps(_mm_add_ps(_mm_mul_ps(a.x, b.x), _mm_mul_ps(a.y, b.y)), _mm_mul_ps(a.z, b.z));
  }
  static __m128 at(__m128 q, __m128 d, __m128 t) noexcept { return _mm_add_ps(q, _mm_mul_ps(t, d)); }
  static __m128 absolute(__m128 v) noexcept { return _mm_andnot_ps(_mm_set1_ps(-0.0f), v); }

  Triple q_, d_;
  __m128 dd_, lost_, reach_;
};

bool isTouched(const SweepQuery& query, const ActiveFeature& f) noexcept
{
  return std::any_of(query.touched.begin(), query.touched.end(),
    [&f](const ActiveFeature& a)
    { return a.surface == f.surface && a.kind == f.kind && a.a == f.a && a.b == f.b; });
}

/// The exact tests of one surface's faces, edges and vertices, and the best hit so far.
class SurfaceSweep
{
public:
  SurfaceSweep(const SurfaceData& data, std::uint32_t surface, const SweepQuery& query, const Motion& m, SweepHit& best)
    : data_(data)
    , surface_(surface)
    , query_(query)
    , m_(m)
    , best_(best)
  {
  }

  void testLeaf(std::uint32_t index) noexcept
  {
    const Leaf& leaf = this->data_.leaves[index];
    const DiscFilter filter(this->m_, leaf.origin_W);
    int lanes = filter.touched(this->data_.discs[2 * index]);
    if (leaf.count > 4)
    {
      lanes |= filter.touched(this->data_.discs[2 * index + 1]) << 4;
    }
    lanes &= (1 << leaf.count) - 1;
    for (; lanes != 0; lanes &= lanes - 1)
    {
      const std::uint32_t triangle = leaf.first + static_cast<std::uint32_t>(__builtin_ctz(static_cast<unsigned>(lanes)));
      this->m_.r > 0.0 ? this->testBall(triangle) : this->testPoint(triangle);
    }
  }

private:
  void testBall(std::uint32_t triangle) noexcept
  {
    const FaceRecord& face = this->data_.faces[triangle];
    this->testFace(triangle, face);
    const auto& corners = this->data_.mesh.triangles[triangle];
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      if (face.owned & (ownsEdge0 << k))
      {
        this->testEdge(std::min(corners[k], corners[next]), std::max(corners[k], corners[next]));
      }
      if (face.owned & (ownsVertex0 << k))
      {
        this->testVertex(corners[k], face.corner_W[k]);
      }
    }
  }

  void testFace(std::uint32_t triangle, const FaceRecord& face) noexcept
  {
    const Motion& m = this->m_;
    const double signedDistance = face.normal_W.dot(m.x_W - face.corner_W[0]);
    const double side = signedDistance >= 0.0 ? 1.0 : -1.0;
    const double distance = side * signedDistance;
    const double rate = side * face.normal_W.dot(m.d);
    if (rate >= 0.0 || distance + rate >= m.r - m.tol || distance <= 0.5 * m.r)
    {
      return;
    }
    const double t = std::max(0.0, (distance - m.r) / -rate);
    if (t > this->best_.t)
    {
      return;
    }
    const Vec3 centre_W = m.x_W + t * m.d;
    for (int k = 0; k < 3; ++k)
    {
      const Vec3& a = face.corner_W[k];
      const Vec3 e = face.corner_W[(k + 1) % 3] - a;
      if (e.cross(face.normal_W).dot(centre_W - a) > 0.0)
      {
        return;
      }
    }
    this->offer(t, { this->surface_, triangle, 0, FeatureKind::Face, static_cast<std::int8_t>(side), false });
  }

  void testEdge(std::uint32_t i, std::uint32_t j) noexcept
  {
    const Motion& m = this->m_;
    const Vec3& a = this->data_.vertex(i);
    const Vec3 e = this->data_.vertex(j) - a;
    const double length2 = e.squaredNorm();
    const Vec3 away = m.x_W - a;
    const double awayAlong = away.dot(e) / length2, dAlong = m.d.dot(e) / length2;
    const double t = this->roundHit(away - awayAlong * e, m.d - dAlong * e);
    const double along = awayAlong + t * dAlong;
    if (along >= 0.0 && along <= 1.0)
    {
      this->offer(t, { this->surface_, i, j, FeatureKind::Edge, 1, false });
    }
  }

  void testVertex(std::uint32_t v, const Vec3& corner_W) noexcept
  {
    this->offer(this->roundHit(this->m_.x_W - corner_W, this->m_.d),
      { this->surface_, v, 0, FeatureKind::Vertex, 1, false });
  }

  /// First t at which |w + t d| = r for a way that gets nearer than r - tol; NaN if it does not.
  [[nodiscard]] double roundHit(const Vec3& w, const Vec3& d) const noexcept
  {
    constexpr double miss = std::numeric_limits<double>::quiet_NaN();
    const Motion& m = this->m_;
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
    const double distance = std::sqrt(ww);
    const double c = (distance - m.r) * (distance + m.r);
    return c <= 0.0 ? 0.0 : c / (-b + std::sqrt(std::max(0.0, b * b - a * c)));
  }

  /// The closed way against the closed triangle, exactly.
  void testPoint(std::uint32_t triangle) noexcept
  {
    const Motion& m = this->m_;
    const FaceRecord& face = this->data_.faces[triangle];
    const auto& [a, b, c] = face.corner_W;
    const double s0 = face.normal_W.dot(m.x_W - a), s1 = face.normal_W.dot(m.e_W - a);
    const double largest = std::max({ m.magnitude, a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff() });
    const double unsure = 8 * std::numeric_limits<double>::epsilon() * double(face.sliver) * largest;
    if ((s0 > unsure && s1 > unsure) || (s0 < -unsure && s1 < -unsure))
    {
      return;
    }
    const int o0 = orientation(a, b, c, m.x_W), o1 = orientation(a, b, c, m.e_W);
    if (o0 != 0 && o0 == o1)
    {
      return;
    }
    if (o0 == 0 && o1 == 0 ? !meetsInPlane(face) : !this->passesThrough(face))
    {
      return;
    }
    const int side = o0 != 0 ? o0 : (o1 != 0 ? -o1 : 1);
    const double span = std::fabs(s0) + std::fabs(s1);
    const double t = o0 == 0 || span == 0.0 ? 0.0 : std::min(1.0, std::fabs(s0) / span);
    this->offer(t, { this->surface_, triangle, 0, FeatureKind::Face, static_cast<std::int8_t>(side), false });
  }

  /// The line of the way against the triangle when the ends are not both in its plane.
  [[nodiscard]] bool passesThrough(const FaceRecord& face) const noexcept
  {
    const auto& [a, b, c] = face.corner_W;
    const int u = orientation(this->m_.x_W, this->m_.e_W, a, b);
    const int v = orientation(this->m_.x_W, this->m_.e_W, b, c);
    const int w = orientation(this->m_.x_W, this->m_.e_W, c, a);
    const bool positive = u > 0 || v > 0 || w > 0, negative = u < 0 || v < 0 || w < 0;
    return !(positive && negative);
  }

  /// Way and triangle in one plane: they are apart if an edge of the triangle or the way itself separates them.
  [[nodiscard]] bool meetsInPlane(const FaceRecord& face) const noexcept
  {
    int drop = 0;
    face.normal_W.cwiseAbs().maxCoeff(&drop);
    const int i = (drop + 1) % 3, j = (drop + 2) % 3;
    const auto turn = [i, j](const Vec3& p, const Vec3& q, const Vec3& s)
    { return orientation2(p[i], p[j], q[i], q[j], s[i], s[j]); };
    const Vec3 &x = this->m_.x_W, &e = this->m_.e_W;
    for (int k = 0; k < 3; ++k)
    {
      const Vec3 &a = face.corner_W[k], &b = face.corner_W[(k + 1) % 3], &c = face.corner_W[(k + 2) % 3];
      const int inside = turn(a, b, c);
      if (turn(a, b, x) == -inside && turn(a, b, e) == -inside)
      {
        return false;
      }
    }
    const int u = turn(x, e, face.corner_W[0]), v = turn(x, e, face.corner_W[1]), w = turn(x, e, face.corner_W[2]);
    return !(u == v && v == w && u != 0);
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

  const SurfaceData& data_;
  std::uint32_t surface_;
  const SweepQuery& query_;
  const Motion& m_;
  SweepHit& best_;
};

/// Near-first walk of one surface's tree.
void sweepSurface(const SurfaceData& data, std::uint32_t surface, const SweepQuery& query, const Motion& m,
  std::uint32_t budget, SweepHit& best) noexcept
{
  struct Pending
  {
    std::uint32_t child;
    double entry;
  };
  constexpr int depth = 96; // a halving tree over 2^32 triangles is 32 deep
  std::array<Pending, depth> stack;
  int top = 0;
  const double rootEntry = entryTime(m, data.low_W, data.high_W);
  if (rootEntry <= best.t)
  {
    stack[top++] = { data.nodes.empty() ? TreeNode::leafBit : 0u, rootEntry };
  }
  SurfaceSweep sweep(data, surface, query, m, best);
  while (top > 0)
  {
    const Pending next = stack[--top];
    if (next.entry > best.t)
    {
      continue;
    }
    if (best.nodes >= budget)
    {
      best.freeUntil = std::min(best.freeUntil, next.entry);
      continue;
    }
    ++best.nodes;
    if (next.child & TreeNode::leafBit)
    {
      sweep.testLeaf(next.child & ~TreeNode::leafBit);
      continue;
    }
    const TreeNode& node = data.nodes[next.child];
    const double entry0 = entryTime(m, node.low_W[0], node.high_W[0]);
    const double entry1 = entryTime(m, node.low_W[1], node.high_W[1]);
    const int far = entry0 <= entry1 ? 1 : 0;
    const double entries[2] = { entry0, entry1 };
    for (const int k : { far, 1 - far })
    {
      if (entries[k] <= best.t)
      {
        stack[top++] = { node.child[k], entries[k] };
      }
    }
  }
}

} // namespace

SweepHit sweepBall(const Scene& scene, const SweepQuery& query, std::uint32_t budget) noexcept
{
  SweepHit best;
  const Motion m = motionOf(query);
  for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s)
  {
    sweepSurface(scene.surfaces()[s].tree->data(), s, query, m, budget, best);
  }
  if (best.freeUntil < 1.0)
  {
    best.hit = best.hit && best.t <= best.freeUntil;
  }
  return best;
}

} // namespace palpate
