// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/tool/move/TouchRows.h"

namespace palpate
{

/// How far a step may go.
struct StepLimits
{
  double characteristic_u = 1.0;
  double reach_u = 1.0;
  double restGap_u = 0.0;
  double room_u = 0.0; ///< that the list of near pairs leaves
};

/// A step that is worth proving.
struct PlannedStep
{
  ScrewStep step;
  Vec6 full = Vec6::Zero();      ///< the target motion within the rows: the step is a part of it, and bent
  std::vector<double> pressures; ///< of the rows, in the metric in which a way of 1 u costs 1
};

/// The nearest motion that all rows allow, shortened until their planes hold as planes: a row's gap may curve away from
/// its line by so much that the rest gap makes up for it, and ends where it should by two corrections.
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
