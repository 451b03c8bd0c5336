// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "haptics/session/soft/BodyMaker.h"

namespace palpate
{

/// Data of a soft body at the time of a snapshot, from which its shape is computed. Another thread may use them if the
/// body's stiffness never changes or its displacement is given.
struct BodySight
{
  const SoftBody* body = nullptr;
  const SoftSurface* surface = nullptr;
  const CheckedTetras* checked = nullptr;
  std::optional<Eigen::VectorXd> displacement_u;      ///< of the nodes; none: that of the equilibrium under the load
  Eigen::VectorXd load_N;                             ///< on the nodes, in addition to the permanent load
  std::shared_ptr<const ComplianceSnapshot> snapshot; ///< null: none yet
  bool underPoints = false; ///< its forces act at points; under a ball the nodes themselves show the dent
  Vec3 hand_W = Vec3::Zero();
};

/// Displacement of the nodes [u].
[[nodiscard]] Eigen::VectorXd displacementOf(const BodySight& sight);
[[nodiscard]] BodyShape shapeOf(const BodySight& sight);

/// Overlap length of a body with itself below the largest force of its snapshot [u]; 0: none. `displacement_u`: of the
/// nodes.
[[nodiscard]] double throughItself_u(const BodySight& sight, const Eigen::VectorXd& displacement_u);

} // namespace palpate
