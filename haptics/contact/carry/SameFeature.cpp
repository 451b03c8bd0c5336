// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/carry/SameFeature.h"

#include <algorithm>
#include <array>

#include "haptics/contact/carry/Deformation.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

constexpr std::uint32_t searchBudget = 2048; ///< nodes a vertex: only boxes that hold its very place are opened

/// A touched feature by its corners, the first of which is looked for.
struct Corners
{
  std::array<Vec3, 3> at{};
  std::size_t count = 0;
};

Corners cornersOf(const SurfaceData& surface, const ActiveFeature& feature) noexcept
{
  switch (feature.kind)
  {
    case FeatureKind::Face:
      return { surface.cornersOf(feature.a), 3 };
    case FeatureKind::Edge:
      return { { surface.vertex(feature.a), surface.vertex(feature.b), {} }, 2 };
    case FeatureKind::Vertex:
      break;
  }
  return { { surface.vertex(feature.a), {}, {} }, 1 };
}

std::optional<std::uint32_t> vertexAt(const SurfaceData& surface, const Vec3& place) noexcept
{
  const std::optional<std::uint32_t> triangle = nearestTriangle(surface, place, 0.0, searchBudget);
  if (!triangle)
  {
    return std::nullopt;
  }
  const auto& corners = surface.corners(*triangle);
  const auto* const found =
    std::find_if(corners.begin(), corners.end(), [&](std::uint32_t v) { return surface.vertex(v) == place; });
  return found == corners.end() ? std::nullopt : std::optional(*found);
}

bool isCorner(const SurfaceData& surface, std::uint32_t triangle, const Vec3& place) noexcept
{
  const auto& corners = surface.corners(triangle);
  return std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return surface.vertex(v) == place; });
}

/// A triangle around that vertex that has all of the corners.
std::optional<std::uint32_t> triangleWith(
  const SurfaceData& surface, std::uint32_t around, const Corners& corners) noexcept
{
  std::optional<std::uint32_t> found;
  surface.forEachAround(around,
    [&](std::uint32_t triangle)
    {
      const bool all = std::all_of(corners.at.begin(), corners.at.begin() + static_cast<std::ptrdiff_t>(corners.count),
        [&](const Vec3& place) { return isCorner(surface, triangle, place); });
      found = all && !found ? std::optional(triangle) : found;
    });
  return found;
}

std::optional<ActiveFeature> featureIn(
  const SurfaceData& surface, const Corners& corners, const ActiveFeature& was) noexcept
{
  const std::optional<std::uint32_t> first = vertexAt(surface, corners.at[0]);
  const std::optional<std::uint32_t> triangle = first ? triangleWith(surface, *first, corners) : std::nullopt;
  if (!triangle)
  {
    return std::nullopt;
  }
  ActiveFeature is = was;
  is.a = was.kind == FeatureKind::Face ? *triangle : *first;
  if (was.kind == FeatureKind::Edge)
  {
    const auto& three = surface.corners(*triangle);
    const auto* const other =
      std::find_if(three.begin(), three.end(), [&](std::uint32_t v) { return surface.vertex(v) == corners.at[1]; });
    is.a = std::min(*first, *other);
    is.b = std::max(*first, *other);
  }
  return is;
}

bool stands(const Surface& surface) noexcept
{
  return surface.motion.isStill() && !surface.from;
}

} // namespace

std::optional<ActiveFeature> sameFeature(const Scene& from, const ActiveFeature& feature, const Scene& to) noexcept
{
  const Surface& before = from.surfaces()[feature.surface];
  if (!stands(before))
  {
    return std::nullopt;
  }
  const Corners corners = cornersOf(before.tree->data(), feature);
  for (std::size_t i = 0; i < to.surfaces().size(); ++i)
  {
    const Surface& after = to.surfaces()[i];
    const bool comparable = stands(after) && after.tree->coat_u() == before.tree->coat_u();
    if (std::optional<ActiveFeature> is = comparable ? featureIn(after.tree->data(), corners, feature) : std::nullopt)
    {
      is->surface = static_cast<std::uint32_t>(i);
      return is;
    }
  }
  return std::nullopt;
}

} // namespace palpate
