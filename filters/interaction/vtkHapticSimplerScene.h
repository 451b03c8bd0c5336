// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSimplerScene_h
#define vtkHapticSimplerScene_h

#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "haptics/geometry/scene/SceneSimplifier.h"

/// What was found, and the largest ball whose work fits into a tick there [u].
struct vtkHapticFoundScene : palpate::SimplerScene
{
  double LargestRadius_u = 0.0; ///< 0 without a scene
};

/// Looks for simpler surfaces of the scene that is felt, off the caller's thread. One thread calls every method.
class vtkHapticSimplerScene
{
public:
  /// Cancels, and waits for that.
  ~vtkHapticSimplerScene();

  /// Looks for simpler surfaces of this scene, and no longer for those of any other. True if they are known already:
  /// the next Poll() has them.
  bool Follow(std::shared_ptr<const palpate::Scene> full, std::vector<palpate::SurfaceChoice> choices,
    const palpate::SimplifyRules& rules, std::uint64_t revision);
  /// Nothing is wanted any more.
  void Cancel();
  /// What was found for the scene followed last, once, when it is done; nothing else.
  std::optional<vtkHapticFoundScene> Poll();
  /// The same, waiting for it. Nothing if nothing is looked for.
  std::optional<vtkHapticFoundScene> Wait();

private:
  struct Order
  {
    std::shared_ptr<const palpate::Scene> Full;
    std::vector<palpate::SurfaceChoice> Choices;
    palpate::SimplifyRules Rules;
    std::uint64_t Revision = 0;
  };
  /// True if it is done.
  bool Launch();
  vtkHapticFoundScene Look(Order order);

  palpate::SceneSimplifier Simplifier; ///< the running task's while there is one
  std::optional<Order> Next;           ///< waits for what was cancelled to end
  std::stop_source Stop;               ///< of what is running
  std::future<vtkHapticFoundScene> Running;
};

#endif
