// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/moves/VertexDescent.h"

#include "haptics/contact/planes/FeatureGeometry.h"

namespace palpate
{
namespace
{

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
Descent steepestIn(const View& s, const VertexFan& fan, std::uint32_t v, const Vec3& q, const Vec3* seenFrom_W) noexcept
{
  const auto isOpen = [&](const ActiveFeature& face)
  { return seenFrom_W == nullptr || sideOf(s, face.a, *seenFrom_W) == face.side; };
  Descent best;
  for (int i = 0; i < fan.count; ++i)
  {
    const ActiveFeature& face = fan[i];
    if (!isOpen(face))
    {
      continue;
    }
    const double gain = gainOnFace(s, face.a, v, q);
    if (gain > best.gain)
    {
      best = { gain, 1, { face, face }, i, SurfaceData::none };
    }
    for (const std::uint32_t corner : s.corners(face.a))
    {
      const double gainOnEdge = corner == v ? 0.0 : edgeLine(s, v, corner).unit.dot(q);
      if (gainOnEdge <= best.gain)
      {
        continue;
      }
      bool branches = false;
      const std::optional<ActiveFeature> other = across(s, face, v, corner, branches);
      if (!other || isOpen(*other))
      {
        best = { gainOnEdge, other ? 2 : 1, { face, other.value_or(face) }, i, corner };
      }
    }
  }
  return best;
}

template<class View>
std::optional<Descent> descendFromVertex(
  const View& s, const VertexFan& fan, std::uint32_t v, const Vec3& x_W, const Vec3& q) noexcept
{
  if (!fan.whole)
  {
    return std::nullopt;
  }
  return steepestIn(s, fan, v, q, fan.branches ? &x_W : nullptr); // branches make pockets that it may not be in
}

#define PALPATE_INSTANTIATE(View)                                                                                      \
  template std::uint32_t cornerAt(const View&, const ActiveFeature&, const Vec3&, double) noexcept;                    \
  template Descent steepestIn(const View&, const VertexFan&, std::uint32_t, const Vec3&, const Vec3*) noexcept;        \
  template std::optional<Descent> descendFromVertex(                                                                   \
    const View&, const VertexFan&, std::uint32_t, const Vec3&, const Vec3&) noexcept;

PALPATE_INSTANTIATE(SurfaceData)
PALPATE_INSTANTIATE(PosedSurface)
#undef PALPATE_INSTANTIATE

} // namespace palpate
