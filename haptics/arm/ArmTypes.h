// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "haptics/core/Types.h"

namespace palpate
{

/// An arm has no more joints that can be sensed.
inline constexpr int mostJoints = 6;

/// A number a joint [rad, N m]; never on the heap.
using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, mostJoints, 1>;
/// Inertia at the joints [kg m2], gears.
using JointMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, mostJoints, mostJoints>;
/// Velocity of a point over the speeds of the joints [m/rad].
using PointJacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, mostJoints>;
/// The same of the tip, above its angular velocity [1].
using ArmJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, mostJoints>;
/// Readings of the encoders.
using JointCounts = std::array<std::int32_t, mostJoints>;

/// Where an arm is with its joints somewhere, and how it moves from there.
struct Posture
{
  bool exists = false;  ///< its links can be closed with these joints; else all that follows is zero
  Pose tip;             ///< [m]; unturned where the arm does not sense it
  ArmJacobian jacobian; ///< of the tip
};

/// A point of a link, and how it moves.
struct LinkPoint
{
  Vec3 p = Vec3::Zero();
  PointJacobian jacobian;
};

} // namespace palpate
