// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "haptics/compliance/servo/PressedBody.h"
#include "haptics/compliance/snapshot/PointCompliance.h"
#include "haptics/mechanism/constraints/ConstraintState.h"
#include "haptics/mechanism/constraints/LooseYield.h"
#include "haptics/mechanism/solve/ConstraintProblem.h"
#include "haptics/tool/motion/TargetMotion.h"

namespace palpate
{

/// Where one side of a constraint is.
struct ConstraintEnd
{
  int body = 0;
  Vec3 x_W = Vec3::Zero(); ///< its point, of a soft body where that does not yield
  Vec3 axis_W = Vec3::UnitZ();
  int soft = -1;        ///< of a soft body: its place among those that the tick is given
  CompliantPoint point; ///< likewise
};

/// One row: how A's point, or its turn, has moved against B's along a direction.
struct ConstraintRow
{
  int law = 0;
  bool turns = false;
  Vec3 along_W = Vec3::UnitZ();
  double free_u = 0.0;
  double lowest_N = 0.0;
  double highest_N = 0.0;
  double compliance_u_per_N = 0.0; ///< of the constraint's own spring
  bool dry = false;                ///< dry friction: all motion is slip
  double now_u = 0.0;              ///< likewise: where it is
};

/// The constraints of a mechanism, linearised at one place of its bodies.
struct ConstraintRows
{
  static constexpr int most = ConstraintProblem::most;

  std::array<std::array<ConstraintEnd, 2>, Mechanism::mostConstraints> ends{}; ///< A and B of each constraint
  std::array<ConstraintRow, most> rows{};
  std::array<double, most / 3> friction{};
  int count = 0;
  int cones = 0; ///< the last three rows each
};

/// The input of rows.
struct ConstraintScene
{
  const MechanismPlan& plan;
  std::span<const PressedBody* const> soft;
  std::span<const Pose> pose_W; ///< of each body: where its constraints are linearised
  std::span<const ConstraintState> laws;
  const Pose& hand_W;                     ///< where the hand has the body that it holds
  std::span<const LooseYield> loose = {}; ///< of each body, of those that are loose; none: no body is
};

/// The rows of the constraints that hold now. A constraint on a soft body that is not there has none. Real-time safe.
void makeRows(const ConstraintScene& scene, ConstraintRows& rows) noexcept;

/// Whether the rows of a kind are along B's axis, and A's point may be elsewhere along it or across.
[[nodiscard]] bool isAlongAxis(ConstraintKind kind) noexcept;

/// From the origin of a constraint's body to the point where the constraint presses on it: for rows along an axis that
/// turns with the held body that is A's point, wherever it is along the axis.
[[nodiscard]] Vec3 armOf(const ConstraintScene& scene, const ConstraintRows& rows, int law, int side) noexcept;

/// How a row's displacement changes with a small motion of a body that is its A (side 0) or B (side 1), about the
/// body's origin, whitened by the plan's lever.
[[nodiscard]] Vec6 jacobianOf(
  const ConstraintScene& scene, const ConstraintRows& rows, const ConstraintRow& row, int side) noexcept;

/// Whether a constraint on the shaft of a rod holds in it now.
[[nodiscard]] bool inShaft(const PlannedConstraint& law, const ConstraintState& state) noexcept;

} // namespace palpate
