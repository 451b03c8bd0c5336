// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "haptics/geometry/scene/SceneSimplifier.h"

namespace palpate
{

/// What was found, and the largest ball whose work fits into a tick there [u].
struct FoundScene : SimplerScene
{
  double largestRadius_u = 0.0; ///< 0 without a scene
};

/// Looks for simpler surfaces of the scene that is felt, off the caller's thread. One thread calls every method.
class SimplerSearch
{
public:
  /// Cancels, and waits for that.
  ~SimplerSearch();

  /// Looks for simpler surfaces of this scene, and no longer for those of any other. True if they are known already:
  /// the next poll() has them.
  bool follow(std::shared_ptr<const Scene> full, std::vector<SurfaceChoice> choices, const SimplifyRules& rules,
    std::uint64_t revision);
  /// Nothing is wanted any more.
  void cancel();
  /// What was found for the scene followed last, once, when it is done; nothing else.
  std::optional<FoundScene> poll();
  /// The same, waiting for it. Nothing if nothing is looked for.
  std::optional<FoundScene> wait();

private:
  struct Order
  {
    std::shared_ptr<const Scene> full;
    std::vector<SurfaceChoice> choices;
    SimplifyRules rules;
    std::uint64_t revision = 0;
  };
  /// True if it is done.
  bool launch();
  FoundScene look(Order order);

  SceneSimplifier simplifier_; ///< the running task's while there is one
  std::optional<Order> next_;  ///< waits for what was cancelled to end
  std::stop_source stop_;      ///< of what is running
  std::future<FoundScene> running_;
};

} // namespace palpate
