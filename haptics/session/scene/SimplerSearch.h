// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "haptics/geometry/scene/SceneSimplifier.h"
#include "haptics/session/background/LatestTask.h"

namespace palpate
{

/// The result, and the largest ball whose work fits into a tick there [u].
struct FoundScene : SimplerScene
{
  double largestRadius_u = 0.0; ///< 0 without a scene
};

/// Looks for simpler surfaces of the scene that is felt, off the caller's thread. One thread calls every method.
class SimplerSearch
{
public:
  /// Looks for simpler surfaces of this scene, and no longer for those of any other. True if they are known already:
  /// the next poll() has them.
  bool follow(std::shared_ptr<const Scene> full, std::vector<SurfaceChoice> choices, const SimplifyRules& rules,
    std::uint64_t revision);
  /// Nothing is wanted any more.
  void cancel() { this->task_.cancel(); }
  /// The result for the last scene, once, when it is done; otherwise nothing.
  std::optional<FoundScene> poll() { return this->task_.poll(); }
  /// The same, waiting for it. Nothing if nothing is looked for.
  std::optional<FoundScene> wait() { return this->task_.wait(); }

private:
  struct Order
  {
    std::shared_ptr<const Scene> full;
    std::vector<SurfaceChoice> choices;
    SimplifyRules rules;
    std::uint64_t revision = 0;
  };
  FoundScene look(Order order);

  SceneSimplifier simplifier_;  ///< the running task's while there is one
  LatestTask<FoundScene> task_; ///< last: it ends before the members it uses
};

} // namespace palpate
