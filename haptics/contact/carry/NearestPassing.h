// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "haptics/contact/carry/PassingTriangles.h"
#include "haptics/contact/sweep/KeptFaces.h"
#include "haptics/contact/view/ContactPlan.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{

[[nodiscard]] inline const Vec3& inFrame(const SurfaceData&, const Vec3& x_W) noexcept
{
  return x_W;
}

[[nodiscard]] inline Vec3 inFrame(const PosedSurface& s, const Vec3& x_W) noexcept
{
  return s.toSurface(x_W);
}

/// The triangle nearest to a ball among those of a surface that may have come over it.
struct NearestPassing
{
  std::uint32_t triangle = 0;
  std::array<FaceList::Face, 8> alike{}; ///< all faces of the scene that are about as near
  std::size_t alikeCount = 0;            ///< 0: they are not known
};

/// The same, from the list that is kept around the ball where that suffices.
template<SceneView AnyScene, class View>
[[nodiscard]] std::optional<NearestPassing> nearestPassing(const AnyScene& from, const View& before, const View& now,
  std::uint32_t surface, const Vec3& x_W, double reach, const ContactPlan& plan, const FacesAround& around) noexcept
{
  PassingTriangles passing(before, now, inFrame(before, x_W), inFrame(now, x_W), reach, plan.workBudget);
  const SweptBall still = sweptBallOf(straightQuery(x_W, x_W, plan.radius_u));
  if (const FaceList* const list = listAround(from, still, around))
  {
    if (const std::optional<std::uint32_t> found = passing.nearestIn(*list, surface, x_W, still.tol))
    {
      NearestPassing nearest{ *found };
      static_assert(nearest.alike.size() == decltype(passing)::mostAlike);
      for (const std::uint32_t t : passing.alike())
      {
        nearest.alike[nearest.alikeCount++] = { surface, t };
      }
      return nearest;
    }
  }
  const std::optional<std::uint32_t> found = passing.nearest();
  return found ? std::optional(NearestPassing{ *found }) : std::nullopt;
}

} // namespace palpate
