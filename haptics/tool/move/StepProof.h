// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/tool/pairs/NearPairs.h"

namespace palpate
{

/// A pair whose plane does not hold over the whole step.
struct DoubtfulPair
{
  double crossing = 0.0; ///< share at which the gap along its plane becomes too small
  double end_u = 0.0;    ///< gap along that plane at the end
  bool leaf = false;     ///< of NearPairs::leaves, else of NearPairs::triangles
  std::uint32_t index = 0;
};

/// Proven share of a step, and its obstacle.
struct StepVerdict
{
  double share = 1.0;
  int blocking = -1;                  ///< index in NearPairs::triangles; -1: none
  std::vector<DoubtfulPair> doubtful; ///< in the order of `crossing`
};

/// A step to be proven.
struct StepTask
{
  ScrewStep step;
  double displacement_u = 0.0; ///< largest displacement of a point of the tool
  double way_u = 0.0;          ///< path length of the tool before it
  Clearance clearance;
};

/// Proves for each near pair that it keeps a gap everywhere on the step, and returns the largest share from its
/// start for which that is proven. Pairs that come too near first are examined first, so that most pairs need only one
/// look at their plane. Leaf pairs whose plane fails are split for good. A pair that is nearer than the gap already may
/// lose a fifth of its distance. Out of budget: the other pairs allow the share that their known planes prove.
[[nodiscard]] StepVerdict proveStep(NearPairs& near, const StepTask& task, WorkBudget& budget);

/// True if each near pair has at least that gap at the pose of the tool.
[[nodiscard]] bool standsFree(NearPairs& near, const Pose& pose_W, double way_u, double gap_u);

} // namespace palpate
