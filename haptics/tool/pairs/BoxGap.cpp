// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/pairs/BoxGap.h"

#include <algorithm>

namespace palpate
{

/// All in the frame of the scene's box: its axes are never written down, and the tool's only as they are turned to it.
double boxGap(const StoredBox& tool_B, const BoxPose& pose, const StoredBox& scene_W) noexcept
{
  const Vec3 halfA = tool_B.half(), halfB = scene_W.half();
  const Quat toB = scene_W.turn().conjugate();
  const Mat3 axes = (toB * (pose.turn * tool_B.turn())).toRotationMatrix();
  const Vec3 between = toB * (scene_W.centre() - pose.centre_W - pose.turning * tool_B.centre());
  const Mat3 cosines = axes.cwiseAbs(); // rows: axes of the scene's box
  const Vec3 alongB = between.cwiseAbs();
  const Vec3 alongA = (axes.transpose() * between).cwiseAbs();
  const double ofA = (alongA - halfA - cosines.transpose() * halfB).maxCoeff();
  const double ofB = (alongB - halfB - cosines * halfA).maxCoeff();
  const double distance = between.norm();
  const double ofLine = distance > 0.0 ? distance - (alongA.dot(halfA) + alongB.dot(halfB)) / distance : -halfA.norm();
  const double gap = std::max({ ofA, ofB, ofLine });
  // Axes are unit and square to one another to a float's rounding only.
  constexpr double rounding = 1e-6;
  return gap - rounding * (std::max(0.0, gap) + halfA.sum() + halfB.sum());
}

} // namespace palpate
