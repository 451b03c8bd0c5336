// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "haptics/session/soft/BodyMaker.h"

namespace palpate
{

/// A soft body as it was when a snapshot was made: all that its shape is computed of. In another thread, if the body's
/// stiffness never changes or its displacement is given.
struct BodySight
{
  const SoftBody* body = nullptr;
  const SoftSurface* surface = nullptr;
  const CheckedTetras* checked = nullptr;
  std::optional<Eigen::VectorXd> displacement_u;      ///< of the nodes; none: that of the rest under the load
  Eigen::VectorXd load_N;                             ///< on the nodes, beside the permanent one
  std::shared_ptr<const ComplianceSnapshot> snapshot; ///< null: none yet
  bool underPoints = false; ///< its forces; what a ball presses on is shown dented by the ball
  Vec3 hand_W = Vec3::Zero();
};

/// Of its nodes [u].
[[nodiscard]] Eigen::VectorXd displacementOf(const BodySight& sight);
[[nodiscard]] BodyShape shapeOf(const BodySight& sight);

/// Overlap length of a body with itself below the largest force of its snapshot [u]; 0: none. `displacement_u`: of its
/// nodes.
[[nodiscard]] double throughItself_u(const BodySight& sight, const Eigen::VectorXd& displacement_u);

} // namespace palpate
