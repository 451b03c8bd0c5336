// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/contact/view/LoadedRegion.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/geometry/scene/SceneSimplifier.h"

namespace palpate
{

/// A surface that is to be built.
struct SceneSurface
{
  SurfaceInput input;
  std::string materialNote;     ///< the arrays that it uses, for the report; "" where it has none
  std::optional<Pose> plane_WP; ///< given: it is walls across that plane, as its mesh stands without `input.pose_WS`
};

/// Of which whole the surfaces of a scene are a part, where they are one, and how much of it they have.
struct ScenePart
{
  std::uint64_t whole = 0;      ///< names it; 0: the scene has all that there is
  Vec3 centre_W = Vec3::Zero(); ///< within `reach_u` of it everything is there [u]
  double reach_u = 0.0;
  std::array<double, 6> bounds_W{}; ///< of the whole: low and high x, y, z [u]
};

/// A scene as the worker built it.
struct BuiltScene
{
  std::shared_ptr<const Scene> scene; ///< null when nothing is touchable
  std::string refused;                ///< without one: the first surface that was refused and the reason
  std::string damaged; ///< the first surface that has coordinates that are not finite, and the parts left out; or ""
  std::string report;  ///< a line a surface: repairs, refusals and plans
  std::array<double, 6> bounds{};                                   ///< of touchable surfaces: low and high x, y, z [u]
  double largestRadius_u = std::numeric_limits<double>::infinity(); ///< whose work fits into a tick
  std::optional<Pose> plane_WP; ///< of the walls, where all that is touchable stands across one plane
  SurfaceTraits traits;         ///< of the surfaces of the scene
  double stamp_s = 0.0;         ///< of the commit
  ScenePart part;
  LoadedRegion known; ///< the part of it that is told to the servo
};

/// The inputs of the builder in these surfaces.
[[nodiscard]] std::vector<SurfaceInput> inputsOf(const std::vector<SceneSurface>& surfaces);

/// Cleans and builds: everything of a built scene but `largestRadius_u`, `plane_WP` and `stamp_s`.
[[nodiscard]] BuiltScene buildScene(
  SceneBuilder& builder, const std::vector<SceneSurface>& surfaces, const Scene* felt, BuildWatch* watch = nullptr);

/// The plane that all of these are walls across, where they stand now: the same up to the sign of the normal and to
/// rounding. Nothing if one is no wall, or stands across another plane.
[[nodiscard]] std::optional<Pose> commonPlane(const std::vector<SceneSurface>& surfaces);

} // namespace palpate
