// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

#include "haptics/arm/ArmPlan.h"

namespace palpate::test
{

/// Kinematics from the constraints of each kind in 113 bits, by other formulas than those of the arms: chains and
/// wrists by Rodrigues' formula, legs by Newton steps on the lengths of their rods, the frame of a wrist by the
/// directions of the links before it.

using Quad = boost::multiprecision::cpp_bin_float_quad;
using QuadVector = Eigen::Matrix<Quad, Eigen::Dynamic, 1>;
using QuadPoint = Eigen::Matrix<Quad, 3, 1>;

/// Position of the tip with these joints [m], in D. `near_D` is near the place that carries the
/// wrist, the tip without one, and selects among the solutions that close the links.
[[nodiscard]] QuadPoint tipInQuad(const ArmPlan& plan, const QuadVector& q, const Vec3& near_D);

/// Derivative of the tip along `way`: a central difference, exact to about 1e-20.
[[nodiscard]] Vec3 tipSlope(const ArmPlan& plan, const JointVector& q, const JointVector& way, const Vec3& near_D);

} // namespace palpate::test
