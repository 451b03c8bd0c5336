// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/pairs/BoxGap.h"

#include <algorithm>

namespace palpate
{
namespace
{

constexpr double rounding = 1e-6; // axes are unit and orthogonal to a float's rounding only

/// Unit normal from the scene to the tool.
Vec3 normalOf(const BoxGap& found, const StoredBox& tool_B, const BoxPose& pose, const StoredBox& scene_W,
  const Vec3& between) noexcept
{
  if (found.axis == 6)
  {
    return between.normalized();
  }
  const Vec3 unit = Vec3::Unit(found.axis % 3);
  const Vec3 n_W = found.axis < 3 ? Vec3(scene_W.turn() * unit) : Vec3(pose.turning * (tool_B.turn() * unit));
  return n_W.dot(between) < 0.0 ? Vec3(-n_W) : n_W;
}

} // namespace

/// All in the frame of the scene's box: its axes are the unit vectors, and the tool's axes are rotated into that frame.
BoxGap boxGap(const StoredBox& tool_B, const BoxPose& pose, const StoredBox& scene_W) noexcept
{
  const Vec3 halfA = tool_B.half(), halfB = scene_W.half();
  const Quat toB = scene_W.turn().conjugate();
  const Mat3 axes = (toB * (pose.turn * tool_B.turn())).toRotationMatrix();
  const Vec3 between = toB * (scene_W.centre() - pose.centre_W - pose.turning * tool_B.centre());
  const Mat3 cosines = axes.cwiseAbs(); // rows: axes of the scene's box
  const Vec3 alongB = between.cwiseAbs();
  const Vec3 alongA = (axes.transpose() * between).cwiseAbs();
  const Vec3 ofA = alongA - halfA - cosines.transpose() * halfB;
  const Vec3 ofB = alongB - halfB - cosines * halfA;
  const double distance = between.norm();
  const double ofLine = distance > 0.0 ? distance - (alongA.dot(halfA) + alongB.dot(halfB)) / distance : -halfA.norm();
  int a = 0, b = 0;
  const double bestA = ofA.maxCoeff(&a), bestB = ofB.maxCoeff(&b);
  const double gap = std::max({ bestA, bestB, ofLine });
  const int axis = gap == bestB ? b : gap == bestA ? 3 + a : 6;
  return { gap - rounding * (std::max(0.0, gap) + halfA.sum() + halfB.sum()), axis };
}

BoxPlane::BoxPlane(const BoxGap& found, const StoredBox& tool_B, const BoxPose& pose, const StoredBox& scene_W,
  double turned_rad) noexcept
  : turned_rad_(turned_rad)
{
  constexpr double shorter = 1.0 - 1e-6; // than one, also after rounding to floats
  const Vec3 centre_W = pose.centreOf_W(tool_B), between = centre_W - scene_W.centre();
  const Vec3 n_W = normalOf(found, tool_B, pose, scene_W, between);
  for (int k = 0; k < 3; ++k)
  {
    this->n_W_[k] = static_cast<float>(shorter * n_W[k]);
  }
  const Vec3 kept_W(this->n_W_[0], this->n_W_[1], this->n_W_[2]);
  const double slack = 3.0 * rounding * (std::max(0.0, found.gap_u) + tool_B.half().sum() + scene_W.half().sum());
  this->offset_u_ = found.gap_u - slack - kept_W.dot(centre_W);
}

double BoxPlane::gap_u(const StoredBox& tool_B, const BoxPose& pose, double turned_rad) const noexcept
{
  const Vec3 kept_W(this->n_W_[0], this->n_W_[1], this->n_W_[2]);
  const double turning = (turned_rad - this->turned_rad_) * tool_B.half().sum();
  return this->offset_u_ + kept_W.dot(pose.centreOf_W(tool_B)) - turning;
}

} // namespace palpate
