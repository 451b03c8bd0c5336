// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The few linear-algebra types every layer shares.
///
/// Units are SI unless a name says otherwise; lengths of the scene are in scene units u.
/// Names carry frames: `p_W` is a point in the scene (world) frame W, `p_D` one in the device frame D.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace palpate
{

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

/// A rigid pose: 7 numbers, position and unit quaternion.
struct Pose
{
  Vec3 p = Vec3::Zero();
  Quat q = Quat::Identity();
};

/// Linear [m/s] and angular [rad/s] velocity.
struct Twist
{
  Vec3 linear = Vec3::Zero();
  Vec3 angular = Vec3::Zero();
};

/// Force [N] and torque [N m].
struct Wrench
{
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
};

} // namespace palpate
