// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/planes/VertexFan.h"

#include <algorithm>

#include "haptics/contact/planes/FeatureGeometry.h"
#include "haptics/geometry/mesh/ExactPredicates.h"

namespace palpate
{
namespace
{

/// A fan that is turned round free edges shows faces from both sides.
bool holds(const VertexFan& fan, const ActiveFeature& f, FreeEdge atFreeEdge) noexcept
{
  return std::any_of(fan.faces.begin(), fan.faces.begin() + fan.count,
    [&](const VertexFan::Face& g)
    { return g.face.a == f.a && (atFreeEdge == FreeEdge::Ends || g.face.side == f.side); });
}

ActiveFeature otherSideOf(ActiveFeature f) noexcept
{
  f.side = static_cast<std::int8_t>(-f.side);
  return f;
}

} // namespace

template<class View>
std::optional<ActiveFeature> across(
  const View& s, const ActiveFeature& from, std::uint32_t v, std::uint32_t far, bool& branches) noexcept
{
  const Vec3 &a = s.vertex(v), &b = s.vertex(far), &own = s.vertex(s.opposite(from.a, v, far));
  const int turn = from.side * (runsAlong(s.corners(from.a), v, far) ? 1 : -1);
  const auto tip = [&](std::uint32_t triangle) -> decltype(auto) { return s.vertex(s.opposite(triangle, v, far)); };
  const auto above = [&](std::uint32_t triangle) // less than half a turn away
  { return turn * orientation(a, b, own, tip(triangle)) > 0; };
  const auto isSooner = [&](std::uint32_t one, std::uint32_t other)
  {
    const bool oneAbove = above(one);
    return oneAbove != above(other) ? oneAbove : turn * orientation(a, b, tip(one), tip(other)) > 0;
  };
  std::uint32_t first = SurfaceData::none;
  s.forEachAtEdge(v, far,
    [&](std::uint32_t triangle)
    {
      if (triangle == from.a)
      {
        return;
      }
      const bool another = first != SurfaceData::none;
      branches |= another;
      first = !another || isSooner(triangle, first) ? triangle : first;
    });
  if (first == SurfaceData::none)
  {
    return std::nullopt;
  }
  return continued(s, from, first, v, far);
}

template<class View>
VertexFan fanAround(const View& s, const ActiveFeature& f, std::uint32_t v, FreeEdge atFreeEdge) noexcept
{
  const int room = atFreeEdge == FreeEdge::Turns ? VertexFan::capacity : VertexFan::capacity / 2;
  VertexFan fan;
  fan.faces[0] = { f, -1, 0 };
  fan.faces[0].face.stuck = false;
  fan.count = 1;
  for (int k = 0; k < fan.count; ++k)
  {
    const ActiveFeature face = fan[k];
    for (const std::uint32_t corner : s.corners(face.a))
    {
      if (corner == v)
      {
        continue;
      }
      std::optional<ActiveFeature> next = across(s, face, v, corner, fan.branches);
      if (!next && atFreeEdge == FreeEdge::Turns)
      {
        next = otherSideOf(face);
      }
      if (next && !holds(fan, *next, atFreeEdge))
      {
        fan.whole = fan.count < room;
        if (fan.whole)
        {
          fan.faces[static_cast<std::size_t>(fan.count++)] = { *next, k, corner };
        }
      }
    }
  }
  return fan;
}

#define PALPATE_INSTANTIATE(View)                                                                                      \
  template std::optional<ActiveFeature> across(                                                                        \
    const View&, const ActiveFeature&, std::uint32_t, std::uint32_t, bool&) noexcept;                                  \
  template VertexFan fanAround(const View&, const ActiveFeature&, std::uint32_t, FreeEdge) noexcept;

PALPATE_INSTANTIATE(SurfaceData)
PALPATE_INSTANTIATE(PosedSurface)
#undef PALPATE_INSTANTIATE

} // namespace palpate
