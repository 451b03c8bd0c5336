// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/tool/move/TouchRows.h"

namespace palpate
{

/// Limits of a step.
struct StepLimits
{
  double characteristic_u = 1.0;
  double reach_u = 1.0;
  double restGap_u = 0.0;
  double room_u = 0.0; ///< motion for which the list of near pairs is complete
};

/// A step for the proof.
struct PlannedStep
{
  ScrewStep step;
  Vec6 full = Vec6::Zero();      ///< the target motion within the rows: the step is a part of it, corrected for bends
  std::vector<double> pressures; ///< of the rows, in the metric in which a displacement of 1 u costs 1
};

/// The nearest motion that all rows allow, shortened until its linear rows are accurate: a row's gap may curve away
/// from its line by no more than the rest gap allows, and two corrections make the gap end at its bound.
class StepPlan
{
public:
  StepPlan(const std::vector<TouchRow>& rows, const Pose& from_W, const StepLimits& limits)
    : rows_(rows), from_W_(from_W), limits_(limits)
  {
  }

  [[nodiscard]] PlannedStep plan(const Vec6& wish) const;

private:
  [[nodiscard]] NearestMotion solve(const Vec6& wish, const std::vector<double>& bends_u) const;
  [[nodiscard]] std::vector<double> bendsOf(const ScrewStep& step) const;
  [[nodiscard]] ScrewStep stepOf(const Vec6& y) const;
  [[nodiscard]] double shareAllowed(const ScrewStep& step) const;

  const std::vector<TouchRow>& rows_;
  const Pose& from_W_;
  StepLimits limits_;
};

} // namespace palpate
