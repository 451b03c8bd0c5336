// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "haptics/core/Types.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/geometry/scene/ScenePlan.h"
#include "haptics/geometry/simplify/Simplification.h"

namespace palpate
{

/// Which surfaces are worth a simpler one, and how far it may be off.
struct SimplifyRules
{
  TouchConditions touch;
  std::size_t leastTriangles = 50000; ///< with fewer than these a surface is left as it is
  std::size_t leastFine = 64;         ///< with fewer fine segments curves are left as they are
  std::stop_token stop = {};

  /// Segments are fine if a hand of 1 m/s goes over more than 32 of them in a tick, half of the passes of a tick
  /// [u].
  [[nodiscard]] double fineBelow_u() const noexcept { return 1e-3 / 32 * this->touch.scale_u_per_m; }
};

/// Traits of the surfaces of a scene besides their triangles; missing entries are defaults.
struct SurfaceTraits
{
  std::vector<bool> deforms;                 ///< its vertices have moved before
  std::vector<std::optional<Pose>> walls_WP; ///< given: it is walls, raised from lines across that plane
};

/// The part of one surface in use, and the reason.
struct SurfaceChoice
{
  std::string name;
  std::size_t triangles = 0;        ///< of the data, after cleaning; of curves, segments
  std::size_t felt = 0;             ///< fewer if a simpler surface takes its place
  double bound_u = 0.0;             ///< proven: no point of either surface is further from the other
  std::string reason;               ///< why all of them are felt; empty if a simpler surface is, or may be found
  bool curves = false;              ///< tubes or walls
  std::optional<Pose> wall_WP = {}; ///< given for walls, of two triangles a segment
};

/// A scene with simpler surfaces, null if none is simpler or it was stopped, and a choice for each surface.
struct SimplerScene
{
  std::shared_ptr<const Scene> scene;
  std::vector<SurfaceChoice> choices;
};

/// Initial choice for each surface: all triangles. O(surfaces + segments of curves).
[[nodiscard]] std::vector<SurfaceChoice> chooseAtFirst(
  const Scene& full, const SurfaceTraits& traits, const SimplifyRules& rules);

/// The surfaces of a scene, with those replaced that pay: at rest, without material arrays, planned to need no more
/// than half of their triangles (planTouch()), and with that proven (simplifyWithin()). Curves with fine segments are
/// felt at one level of detail, the coarsest that nobody notices (coarserSurface()). A level that is fine near the hand
/// and coarser beyond brings nothing more: of a line of 300,000 points up to 37 stay instead of 110, a tick costs the
/// same 2.2 us, and the level would have to follow the hand (lab: `plane-cost`). The result for a surface is kept
/// while the surface stays in the scenes. Any thread but the servo's, one at a time.
class SceneSimplifier
{
public:
  /// `choices` are chooseAtFirst()'s, `revision` the new scene's.
  [[nodiscard]] SimplerScene simplify(
    const Scene& full, std::vector<SurfaceChoice> choices, const SimplifyRules& rules, std::uint64_t revision);
  /// True if nothing has to be looked for: then simplify() takes no time worth a worker.
  [[nodiscard]] bool knows(
    const Scene& full, const std::vector<SurfaceChoice>& choices, const SimplifyRules& rules) const;

private:
  struct Kept
  {
    std::shared_ptr<const SurfaceTree> tree;
    double limit_u = 0.0;
    std::size_t leastFine = 0;
    Simplification fewer;
  };
  [[nodiscard]] const Kept* find(const SurfaceTree* tree, const SimplifyRules& rules) const;
  [[nodiscard]] static Kept look(
    const std::shared_ptr<const SurfaceTree>& tree, const SurfaceChoice& choice, const SimplifyRules& rules);

  std::vector<Kept> kept_;
};

} // namespace palpate
