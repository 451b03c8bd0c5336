// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/planes/FeatureGeometry.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

/// A walk crosses at most this many coplanar triangles in one motion, which bounds its work: 5 mm over strips of
/// 0.02 mm. A longer way goes on in the next pass.
constexpr int walkLimit = 256;

FeaturePlane planeAround(const Vec3& foot_W, const Vec3& x_W, double r) noexcept
{
  const Vec3 away = x_W - foot_W;
  const double distance = away.norm();
  return { distance > 0.0 ? Vec3(away / distance) : Vec3(Vec3::UnitZ()), distance - r, foot_W };
}

template<class View>
double axialPosition(const View& s, const ActiveFeature& f, const EdgeLine& line, const Vec3& x_W) noexcept
{
  return (x_W - s.vertex(f.a)).dot(line.unit);
}

/// The face over edge (i, j) into whose inside x projects, or none.
template<class View>
std::uint32_t faceUnder(const View& s, std::uint32_t i, std::uint32_t j, const Vec3& x_W) noexcept
{
  std::uint32_t found = SurfaceData::none;
  s.forEachAtEdge(i, j,
    [&](std::uint32_t triangle)
    {
      if (found == SurfaceData::none && projectsInside(s, triangle, x_W, 0.0))
      {
        found = triangle;
      }
    });
  return found;
}

/// The far end of the edge at vertex v along which x lies furthest, or none if x is behind all of them.
template<class View>
std::uint32_t edgeUnder(const View& s, std::uint32_t v, const Vec3& x_W) noexcept
{
  std::uint32_t best = SurfaceData::none;
  double furthest = 0.0;
  const Vec3 away = x_W - s.vertex(v);
  s.forEachAround(v,
    [&](std::uint32_t triangle)
    {
      for (const std::uint32_t corner : s.corners(triangle))
      {
        if (corner == v || corner == best)
        {
          continue;
        }
        const Vec3 e = s.vertex(corner) - s.vertex(v);
        const double towards = away.dot(e);
        if (!(towards > 0.0))
        {
          continue; // of a fan of thousands only the part that faces the ball is measured
        }
        const double along = towards / e.norm();
        if (along > furthest || (along == furthest && best != SurfaceData::none && corner < best))
        {
          furthest = along;
          best = corner;
        }
      }
    });
  return best;
}

bool cornersAre(const std::array<std::uint32_t, 3>& t, int k, std::uint32_t i, std::uint32_t j) noexcept
{
  const std::uint32_t a = t[k], b = t[(k + 1) % 3];
  return (a == i && b == j) || (a == j && b == i);
}

/// A side of a face without the cost of a root: its outward normal times its length, and that length to within a
/// factor of sqrt 3 (the sum of its coordinates), good enough for margins.
struct Side
{
  Vec3 outward;
  double length;
};

Side sideOf(const FaceRecord& face, int k) noexcept
{
  const Vec3 e = face.corner_W[(k + 1) % 3] - face.corner_W[k];
  return { e.cross(face.normal_W), e.cwiseAbs().sum() };
}

Vec3 outwardNormal(const FaceRecord& face, int k) noexcept
{
  const Vec3 e = face.corner_W[(k + 1) % 3] - face.corner_W[k];
  return e.cross(face.normal_W) / e.norm();
}

} // namespace

template<class View>
EdgeLine edgeLine(const View& s, std::uint32_t i, std::uint32_t j) noexcept
{
  const Vec3 e = s.vertex(j) - s.vertex(i);
  const double scale = e.cwiseAbs().maxCoeff();
  if (scale == 0.0)
  {
    return {}; // vertices that move may meet for a moment
  }
  const double length = (e / scale).norm() * scale;
  return { e / length, length };
}

template<class View>
Vec3 outwardNormal(const View& s, std::uint32_t triangle, int k) noexcept
{
  return outwardNormal(s.face(triangle), k);
}

template<class View>
double outsideOfEdge(const View& s, std::uint32_t triangle, int k, const Vec3& x_W) noexcept
{
  const FaceRecord& face = s.face(triangle);
  return outwardNormal(face, k).dot(x_W - face.corner_W[k]);
}

template<class View>
bool projectsInside(const View& s, std::uint32_t triangle, const Vec3& x_W, double margin) noexcept
{
  const FaceRecord& face = s.face(triangle);
  for (int k = 0; k < 3; ++k)
  {
    const Side side = sideOf(face, k);
    if (side.outward.dot(x_W - face.corner_W[k]) > margin * side.length)
    {
      return false;
    }
  }
  return true;
}

template<class View>
FeaturePlane planeOf(const View& s, const ActiveFeature& f, const Vec3& x_W, double r) noexcept
{
  switch (f.kind)
  {
    case FeatureKind::Face:
    {
      const FaceRecord& face = s.face(f.a);
      const Vec3 n = f.side * face.normal_W;
      const double distance = n.dot(x_W - face.corner_W[0]);
      return { n, distance - r, x_W - distance * n };
    }
    case FeatureKind::Edge:
    {
      const EdgeLine line = edgeLine(s, f.a, f.b);
      const double along = std::clamp(axialPosition(s, f, line, x_W), 0.0, line.length);
      return planeAround(s.vertex(f.a) + along * line.unit, x_W, r + dataOf(s).coat_u);
    }
    default:
      return planeAround(s.vertex(f.a), x_W, r + dataOf(s).coat_u);
  }
}

template<class View>
bool supports(const View& s, const ActiveFeature& f, const Vec3& x_W, double r, double tol) noexcept
{
  if (planeOf(s, f, x_W, r).gap > tol)
  {
    return false;
  }
  if (f.kind == FeatureKind::Face)
  {
    return projectsInside(s, f.a, x_W, tol);
  }
  if (f.kind == FeatureKind::Edge)
  {
    const EdgeLine line = edgeLine(s, f.a, f.b);
    const double along = axialPosition(s, f, line, x_W);
    return along >= -tol && along <= line.length + tol;
  }
  return true;
}

template<class View>
ActiveFeature normalised(const View& s, ActiveFeature f, const Vec3& x_W) noexcept
{
  if (f.kind == FeatureKind::Vertex)
  {
    const std::uint32_t other = edgeUnder(s, f.a, x_W);
    if (other == SurfaceData::none)
    {
      return f;
    }
    f.kind = FeatureKind::Edge;
    f.b = std::max(f.a, other);
    f.a = std::min(f.a, other);
  }
  if (f.kind == FeatureKind::Edge && dataOf(s).coat_u == 0.0) // curves have no faces
  {
    const std::uint32_t face = faceUnder(s, f.a, f.b, x_W);
    if (face != SurfaceData::none)
    {
      f.kind = FeatureKind::Face;
      f.a = face;
      f.b = 0;
      f.side = s.face(face).normal_W.dot(x_W - s.face(face).corner_W[0]) >= 0.0 ? 1 : -1;
    }
  }
  return f;
}

template<class View>
FaceExit walkFace(const View& s, std::uint32_t triangle, const Vec3& x_W, const Vec3& y, double del) noexcept
{
  const FaceRecord& first = s.face(triangle);
  const Vec3 n = first.normal_W, anchor_W = first.corner_W[0];
  std::uint32_t enteredI = SurfaceData::none, enteredJ = SurfaceData::none;
  double reached = 0.0;
  for (int step = 0; step < walkLimit; ++step)
  {
    const auto& corners = s.corners(triangle);
    const FaceRecord& face = s.face(triangle); // made anew each time it is asked for where surfaces move
    double t = 1.0;
    int leaving = -1;
    Vec3 out = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      const Side side = sideOf(face, k);
      const double rate = side.outward.dot(y);
      if (rate <= 0.0 || cornersAre(corners, k, enteredI, enteredJ))
      {
        continue;
      }
      const double inside = -side.outward.dot(x_W - face.corner_W[k]);
      // Ends just outside, by more than inside is rounded: from the border itself the same face would be hit again.
      const double exit = (std::max(inside, 0.0) + 4 * del * side.length) / rate;
      if (exit < t)
      {
        t = exit;
        leaving = k;
        out = side.outward;
      }
    }
    if (leaving < 0)
    {
      return { 1.0, triangle };
    }
    const std::uint32_t i = std::min(corners[leaving], corners[(leaving + 1) % 3]);
    const std::uint32_t j = std::max(corners[leaving], corners[(leaving + 1) % 3]);
    const std::uint32_t next = s.neighbour(triangle, i, j);
    if (next == SurfaceData::none)
    {
      return { t, triangle, i, j };
    }
    const Vec3& tip_W = s.vertex(s.opposite(next, i, j));
    const bool coplanar = std::fabs(n.dot(tip_W - anchor_W)) <= 2 * del; // both places are rounded by del
    const bool folded = out.dot(tip_W - s.vertex(i)) <= 0.0;
    if (!coplanar || folded)
    {
      return { t, triangle, i, j };
    }
    triangle = next;
    enteredI = i;
    enteredJ = j;
    reached = t;
  }
  return { reached, triangle, enteredI, enteredJ };
}

template<class View>
double exitRound(const View& s, const ActiveFeature& f, const Vec3& x_W, const Vec3& y, double r, double del) noexcept
{
  const FeaturePlane plane = planeOf(s, f, x_W, r);
  Vec3 tangential = y - y.dot(plane.n) * plane.n;
  double t = 1.0;
  if (f.kind == FeatureKind::Edge)
  {
    const EdgeLine line = edgeLine(s, f.a, f.b);
    const double rate = y.dot(line.unit);
    tangential -= rate * line.unit;
    const double along = axialPosition(s, f, line, x_W);
    if (rate != 0.0)
    {
      const double ahead = rate > 0.0 ? line.length - along : along;
      t = std::min(t, (std::max(ahead, 0.0) + 4 * del) / std::fabs(rate));
    }
  }
  const double reach = tangential.norm(), limit = r + dataOf(s).coat_u;
  return reach > limit ? std::min(t, limit / reach) : t;
}

template<class View>
ActiveFeature onSamePlane(const View& s, const ActiveFeature& from, std::uint32_t to) noexcept
{
  ActiveFeature next = from;
  next.a = to;
  const bool sameTurn = s.face(to).normal_W.dot(s.face(from.a).normal_W) >= 0.0;
  next.side = sameTurn ? from.side : static_cast<std::int8_t>(-from.side);
  return next;
}

template<class View>
ActiveFeature continued(
  const View& s, const ActiveFeature& from, std::uint32_t to, std::uint32_t i, std::uint32_t j) noexcept
{
  ActiveFeature next = from;
  next.a = to;
  const bool sameTurn = runsAlong(s.corners(from.a), i, j) != runsAlong(s.corners(to), i, j);
  next.side = sameTurn ? from.side : static_cast<std::int8_t>(-from.side);
  return next;
}

#define PALPATE_INSTANTIATE(View)                                                                                      \
  template FeaturePlane planeOf(const View&, const ActiveFeature&, const Vec3&, double) noexcept;                      \
  template double outsideOfEdge(const View&, std::uint32_t, int, const Vec3&) noexcept;                                \
  template Vec3 outwardNormal(const View&, std::uint32_t, int) noexcept;                                               \
  template bool projectsInside(const View&, std::uint32_t, const Vec3&, double) noexcept;                              \
  template bool supports(const View&, const ActiveFeature&, const Vec3&, double, double) noexcept;                     \
  template ActiveFeature normalised(const View&, ActiveFeature, const Vec3&) noexcept;                                 \
  template FaceExit walkFace(const View&, std::uint32_t, const Vec3&, const Vec3&, double) noexcept;                   \
  template double exitRound(const View&, const ActiveFeature&, const Vec3&, const Vec3&, double, double) noexcept;     \
  template ActiveFeature onSamePlane(const View&, const ActiveFeature&, std::uint32_t) noexcept;                       \
  template ActiveFeature continued(                                                                                    \
    const View&, const ActiveFeature&, std::uint32_t, std::uint32_t, std::uint32_t) noexcept;                          \
  template EdgeLine edgeLine(const View&, std::uint32_t, std::uint32_t) noexcept;

PALPATE_INSTANTIATE(SurfaceData)
PALPATE_INSTANTIATE(PosedSurface)
#undef PALPATE_INSTANTIATE

} // namespace palpate
