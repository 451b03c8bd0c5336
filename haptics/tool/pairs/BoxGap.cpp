// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/pairs/BoxGap.h"

#include <algorithm>

namespace palpate
{

double boxGap(const OrientedBox& a, const OrientedBox& b) noexcept
{
  const Vec3 between = b.centre - a.centre;
  const Mat3 cosines = (a.axes.transpose() * b.axes).cwiseAbs();
  const Vec3 alongA = (a.axes.transpose() * between).cwiseAbs(), alongB = (b.axes.transpose() * between).cwiseAbs();
  const double ofA = (alongA - a.half - cosines * b.half).maxCoeff();
  const double ofB = (alongB - b.half - cosines.transpose() * a.half).maxCoeff();
  const double distance = between.norm();
  const double ofLine =
    distance > 0.0 ? distance - (alongA.dot(a.half) + alongB.dot(b.half)) / distance : -a.half.norm();
  const double gap = std::max({ ofA, ofB, ofLine });
  // Axes are unit and square to one another to a float's rounding only.
  constexpr double rounding = 1e-6;
  return gap - rounding * (std::max(0.0, gap) + a.half.sum() + b.half.sum());
}

OrientedBox posed(const OrientedBox& box_B, const Mat3& turn, const Vec3& centre_W) noexcept
{
  return { centre_W + turn * box_B.centre, turn * box_B.axes, box_B.half };
}

} // namespace palpate
