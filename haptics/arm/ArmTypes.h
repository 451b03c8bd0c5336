// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <numbers>

#include "haptics/core/Types.h"

namespace palpate
{

/// Largest number of joints that can be sensed.
inline constexpr int mostJoints = 6;

inline constexpr double wholeTurn_rad = 2.0 * std::numbers::pi;

/// One number per joint [rad, N m]; never on the heap.
using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, mostJoints, 1>;
/// Inertia in joint coordinates [kg m2], gears.
using JointMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, mostJoints, mostJoints>;
/// Derivative of a point with respect to the joints [m/rad].
using PointJacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, mostJoints>;
/// The same for the tip, above the derivative of its rotation [1].
using ArmJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, mostJoints>;
/// Readings of the encoders.
using JointCounts = std::array<std::int32_t, mostJoints>;

/// Pose and Jacobian of an arm's tip with given joints.
struct Posture
{
  bool exists = false;  ///< whether the links close with these joints; else the other members are zero
  Pose tip;             ///< [m]; without rotation where the arm does not sense that
  ArmJacobian jacobian; ///< of the tip
};

/// A point of a link, and its Jacobian.
struct LinkPoint
{
  Vec3 p = Vec3::Zero();
  PointJacobian jacobian;
};

} // namespace palpate
