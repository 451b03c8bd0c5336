// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/field/laws/Detent.h"

namespace palpate
{

/// How a field is felt. A mode whose strength is 0 is off; several may be on at once.
struct FieldPlan
{
  bool isosurface = false; ///< the surface scalar = isovalue is a wall from both sides
  double isovalue = 0.0;
  FrictionPlan friction; ///< of that surface: the tick's own, that of all contact
  double yield_N = 0.0;  ///< above 0: the surface is a membrane that yields at this force

  double follow_N = 0.0;    ///< holds the hand on the streamline that it is on, of vectors or axes
  double drag_N = 0.0;      ///< resists every motion, times the resistance at the hand
  double dragNone = 0.0;    ///< resistance at which nothing of it is felt
  double dragFull = 1.0;    ///< and at which all of it is, above or below that
  DetentPlan detent;        ///< levels of the scalar hold the hand
  double snap_N = 0.0;      ///< pulls to the nearest of the block's places and lines
  double snapReach_u = 5.0; ///< from there on, less with the distance
  double compare_N = 0.0;   ///< resists every motion where scalar and other differ
  double compareFull = 1.0; ///< difference from which it does with all of its strength
  double push_N = 0.0;      ///< the vectors are a force: a source of energy
  double noSpeed = 0.0;     ///< length of the vectors up to which they are not followed and do not push
  double fullSpeed = 0.0;   ///< length of the vectors from which they are followed and push with all strength; 0: any

  static constexpr double mostPush_N = 0.5; ///< a vortex gives a hand energy for ever
};

/// Whether any of its modes is on.
[[nodiscard]] inline bool isOn(const FieldPlan& plan) noexcept
{
  return plan.isosurface || plan.follow_N > 0.0 || plan.drag_N > 0.0 || plan.detent.strength_N > 0.0 ||
         plan.snap_N > 0.0 || plan.compare_N > 0.0 || plan.push_N > 0.0;
}

} // namespace palpate
