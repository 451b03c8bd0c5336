// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/VertexDescent.h"

#include <algorithm>

#include "haptics/contact/FeatureGeometry.h"
#include "haptics/geometry/ExactPredicates.h"

namespace palpate
{
namespace
{

constexpr int mostFaces = 32;

/// True if the stored corner order of the triangle runs from i to j along their edge.
template<class View>
bool runsFrom(const View& s, std::uint32_t triangle, std::uint32_t i, std::uint32_t j) noexcept
{
  const auto& t = s.corners(triangle);
  return (t[0] == i && t[1] == j) || (t[1] == i && t[2] == j) || (t[2] == i && t[0] == j);
}

/// The faces round a vertex with the side the point lies on, in the order in which they were reached.
struct Fan
{
  std::array<ActiveFeature, mostFaces> faces;
  int count = 0;
  bool whole = true;     ///< there was room for all of them
  bool branches = false; ///< three or more faces meet in an edge of it

  [[nodiscard]] bool holds(std::uint32_t triangle) const noexcept
  {
    return std::any_of(this->faces.begin(), this->faces.begin() + this->count,
      [triangle](const ActiveFeature& f) { return f.a == triangle; });
  }
};

/// The first face met on turning from face `from` round its edge from v to `far`, on the side the point lies on, with
/// the side it shows; none at a free edge. Exact: a fin may lie as close to a face as it likes.
template<class View>
std::optional<ActiveFeature> across(
  const View& s, const ActiveFeature& from, std::uint32_t v, std::uint32_t far, bool& branches) noexcept
{
  const Vec3 &a = s.vertex(v), &b = s.vertex(far), &own = s.vertex(s.opposite(from.a, v, far));
  const int turn = from.side * (runsFrom(s, from.a, v, far) ? 1 : -1);
  std::uint32_t first = SurfaceData::none;
  bool firstAbove = false;
  s.forEachAtEdge(v, far,
    [&](std::uint32_t triangle)
    {
      if (triangle == from.a)
      {
        return;
      }
      branches |= first != SurfaceData::none;
      const Vec3& tip = s.vertex(s.opposite(triangle, v, far));
      const bool above = turn * orientation(a, b, own, tip) > 0; // less than half a turn away
      const bool sooner =
        first == SurfaceData::none || (above && !firstAbove) ||
        (above == firstAbove && turn * orientation(a, b, tip, s.vertex(s.opposite(first, v, far))) > 0);
      first = sooner ? triangle : first;
      firstAbove = sooner ? above : firstAbove;
    });
  if (first == SurfaceData::none)
  {
    return std::nullopt;
  }
  ActiveFeature next = from;
  next.a = first;
  const bool sameTurn = runsFrom(s, from.a, v, far) != runsFrom(s, first, v, far);
  next.side = sameTurn ? from.side : static_cast<std::int8_t>(-from.side);
  return next;
}

template<class View>
Fan fanAround(const View& s, const ActiveFeature& f, std::uint32_t v) noexcept
{
  Fan fan;
  fan.faces[0] = f;
  fan.faces[0].stuck = false;
  fan.count = 1;
  for (int k = 0; k < fan.count; ++k)
  {
    const ActiveFeature face = fan.faces[static_cast<std::size_t>(k)];
    for (const std::uint32_t corner : s.corners(face.a))
    {
      const std::optional<ActiveFeature> next = corner != v ? across(s, face, v, corner, fan.branches) : std::nullopt;
      if (next && !fan.holds(next->a))
      {
        fan.whole = fan.count < mostFaces;
        if (fan.whole)
        {
          fan.faces[static_cast<std::size_t>(fan.count++)] = *next;
        }
      }
    }
  }
  return fan;
}

/// How much of q acts along a face seen from its corner v, if its projection points into the face; else 0.
template<class View>
double gainOnFace(const View& s, std::uint32_t triangle, std::uint32_t v, const Vec3& q) noexcept
{
  const auto& t = s.corners(triangle);
  const Vec3& n = s.face(triangle).normal_W;
  const Vec3 along = q - q.dot(n) * n;
  for (int k = 0; k < 3; ++k)
  {
    const bool touchesV = t[k] == v || t[(k + 1) % 3] == v;
    if (touchesV && outwardNormal(s, triangle, k).dot(along) > 0.0)
    {
      return 0.0;
    }
  }
  return along.norm();
}

} // namespace

template<class View>
std::uint32_t cornerAt(const View& s, const ActiveFeature& f, const Vec3& x_W, double margin) noexcept
{
  std::array<bool, 3> near{};
  for (int k = 0; k < 3; ++k)
  {
    near[static_cast<std::size_t>(k)] = outsideOfEdge(s, f.a, k, x_W) > -margin;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (near[k] && near[(k + 2) % 3])
    {
      return s.corners(f.a)[k]; // edges k - 1 and k meet in corner k
    }
  }
  return SurfaceData::none;
}

template<class View>
std::optional<Descent> descendFromVertex(
  const View& s, const ActiveFeature& f, std::uint32_t v, const Vec3& x_W, const Vec3& q) noexcept
{
  Fan fan = fanAround(s, f, v);
  if (!fan.whole)
  {
    return std::nullopt;
  }
  // A fan with branches has pockets that the point may not be in.
  const auto isThere = [&](const ActiveFeature& face) { return !fan.branches || sideOf(s, face.a, x_W) == face.side; };
  Descent best;
  for (int i = 0; i < fan.count; ++i)
  {
    const ActiveFeature& face = fan.faces[static_cast<std::size_t>(i)];
    if (!isThere(face))
    {
      continue;
    }
    const double gain = gainOnFace(s, face.a, v, q);
    if (gain > best.gain)
    {
      best = { gain, 1, { face, face } };
    }
    for (const std::uint32_t corner : s.corners(face.a))
    {
      const double gainOnEdge = corner == v ? 0.0 : edgeLine(s, v, corner).unit.dot(q);
      if (gainOnEdge <= best.gain)
      {
        continue;
      }
      const std::optional<ActiveFeature> other = across(s, face, v, corner, fan.branches);
      if (!other || isThere(*other))
      {
        best = { gainOnEdge, other ? 2 : 1, { face, other.value_or(face) } };
      }
    }
  }
  return best;
}

#define PALPATE_INSTANTIATE(View)                                                                                      \
  template std::uint32_t cornerAt(const View&, const ActiveFeature&, const Vec3&, double) noexcept;                    \
  template std::optional<Descent> descendFromVertex(                                                                   \
    const View&, const ActiveFeature&, std::uint32_t, const Vec3&, const Vec3&) noexcept;

PALPATE_INSTANTIATE(SurfaceData)
PALPATE_INSTANTIATE(PosedSurface)
#undef PALPATE_INSTANTIATE

} // namespace palpate
