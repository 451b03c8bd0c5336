// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSurfacePlacement.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "vtkMatrix4x4.h"

namespace
{
/// Volume of the image of a unit cube over that of the box with its edges: below this a direction is lost in rounding.
constexpr double smallestVolume = 1e-12;

/// How far from rigid rounding may leave the quotient of two matrices.
constexpr double rounding = 1e-10;

bool IsSingular(const palpate::Mat3& linear)
{
  const double box = linear.col(0).norm() * linear.col(1).norm() * linear.col(2).norm();
  return !(std::abs(linear.determinant()) > smallestVolume * box) || !linear.inverse().allFinite();
}
} // namespace

std::string vtkHapticCheckPlacement(vtkMatrix4x4* matrix)
{
  if (!matrix)
  {
    return {};
  }
  if (!std::all_of(matrix->GetData(), matrix->GetData() + 16, [](double x) { return std::isfinite(x); }))
  {
    return "its transform is not finite; reset the transform";
  }
  const double* last = matrix->GetData() + 12;
  if (last[0] != 0.0 || last[1] != 0.0 || last[2] != 0.0 || last[3] != 1.0)
  {
    return "its transform is a perspective; only shift, rotation, scale, shear and mirror can be touched";
  }
  return IsSingular(vtkHapticPlacementOf(matrix).linear())
           ? "its transform is singular: the surface has no size in some direction; use a scale other than 0"
           : "";
}

vtkHapticPlacement vtkHapticPlacementOf(vtkMatrix4x4* matrix)
{
  vtkHapticPlacement placement = vtkHapticPlacement::Identity();
  for (int row = 0; matrix && row < 3; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      placement(row, column) = matrix->GetElement(row, column);
    }
  }
  return placement;
}

std::optional<palpate::Pose> vtkHapticMotionBetween(const vtkHapticPlacement& before, const vtkHapticPlacement& now)
{
  if (before.matrix() == now.matrix())
  {
    return palpate::Pose{};
  }
  const palpate::Mat3 turn = now.linear() * before.linear().inverse();
  const double off = (turn.transpose() * turn - palpate::Mat3::Identity()).cwiseAbs().maxCoeff();
  if (!(off <= rounding) || turn.determinant() < 0.0)
  {
    return std::nullopt;
  }
  palpate::Pose pose;
  pose.q = now.linear() == before.linear() ? palpate::Quat::Identity() : palpate::Quat(turn).normalized();
  pose.p = now.translation() - pose.q * before.translation();
  return pose;
}

palpate::TriangleMesh vtkHapticPlaced(const palpate::TriangleMesh& mesh, const vtkHapticPlacement& by)
{
  palpate::TriangleMesh placed = mesh;
  for (palpate::Vec3& p_W : placed.vertices_W)
  {
    p_W = by * p_W;
  }
  if (by.linear().determinant() < 0.0)
  {
    for (auto& triangle : placed.triangles)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return placed;
}
