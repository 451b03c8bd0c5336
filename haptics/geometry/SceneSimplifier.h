// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "haptics/geometry/Scene.h"
#include "haptics/geometry/ScenePlan.h"
#include "haptics/geometry/Simplification.h"

namespace palpate
{

/// Which surfaces are worth a simpler one, and how far it may be off.
struct SimplifyRules
{
  TouchConditions touch;
  std::size_t leastTriangles = 50000; ///< with fewer than these a surface is left as it is
  std::stop_token stop = {};
};

/// What is felt of one surface, and why.
struct SurfaceChoice
{
  std::string name;
  std::size_t triangles = 0; ///< of the data, after cleaning
  std::size_t felt = 0;      ///< fewer if a simpler surface takes its place
  double bound_u = 0.0;      ///< proven: no point of either surface is further from the other
  std::string reason;        ///< why all of them are felt; empty if a simpler surface is, or may be found
};

/// A scene with simpler surfaces, null if none is simpler or it was stopped, and a choice for each surface.
struct SimplerScene
{
  std::shared_ptr<const Scene> scene;
  std::vector<SurfaceChoice> choices;
};

/// What is felt of each surface at first: all its triangles. `deforms`: a flag each, its vertices have moved before.
/// O(surfaces).
[[nodiscard]] std::vector<SurfaceChoice> chooseAtFirst(
  const Scene& full, const std::vector<bool>& deforms, const SimplifyRules& rules);

/// The surfaces of a scene, with those replaced that pay: at rest, without curves or material arrays, planned to need
/// no more than half of their triangles (planTouch()), and with that proven (simplifyWithin()). What it found for a
/// surface is kept while the surface stays in the scenes. Any thread but the servo's, one at a time.
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
    Simplification fewer;
  };
  [[nodiscard]] const Kept* find(const SurfaceTree* tree, const SimplifyRules& rules) const;
  [[nodiscard]] Kept look(const std::shared_ptr<const SurfaceTree>& tree, const SimplifyRules& rules) const;

  std::vector<Kept> kept_;
};

} // namespace palpate
