// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/tool/pairs/NearPairs.h"

namespace palpate
{

/// A pair whose plane does not hold over the whole step.
struct DoubtfulPair
{
  double crossing = 0.0; ///< where its plane says that it comes too near
  double end_u = 0.0;    ///< gap that it says for the end
  bool leaf = false;     ///< of NearPairs::leaves, else of NearPairs::triangles
  std::uint32_t index = 0;
};

/// Proven share of a step, and its obstacle.
struct StepVerdict
{
  double share = 1.0;
  int blocking = -1;                  ///< of NearPairs::triangles; -1: nothing
  std::vector<DoubtfulPair> doubtful; ///< in the order in which they come too near
};

/// A step that is to be proven.
struct StepTask
{
  ScrewStep step;
  double displacement_u = 0.0; ///< no point of the tool goes further
  double way_u = 0.0;          ///< of the tool before it
  Clearance clearance;
};

/// Proves for each near pair that nothing comes nearer than a gap, anywhere on the step: the largest share from its
/// start for which that is proven. What comes too near first is looked at first, so that most pairs need no more than a
/// look at their plane. Leaf pairs whose plane fails are split for good. A pair that is nearer than the gap already may
/// lose a fifth of what it has. Out of budget: what was not looked at goes as far as its known plane shows.
[[nodiscard]] StepVerdict proveStep(NearPairs& near, const StepTask& task, WorkBudget& budget);

/// True if each near pair is apart by a gap where the tool stands.
[[nodiscard]] bool standsFree(NearPairs& near, const Pose& pose_W, double way_u, double gap_u);

} // namespace palpate
