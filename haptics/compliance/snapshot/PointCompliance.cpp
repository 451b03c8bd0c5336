// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/snapshot/PointCompliance.h"

#include <cmath>

namespace palpate
{
namespace
{

Mat3 bilinear(const ComplianceSnapshot& snapshot, const SurfacePoint& a, const SurfacePoint& b) noexcept
{
  Mat3 sum = Mat3::Zero();
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      sum += a.weights[i] * b.weights[j] * snapshot.between(a.vertices[i], b.vertices[j]);
    }
  }
  return sum;
}

/// L with L L^T = m, m positive semidefinite but for rounding: a direction without compliance gets a zero column.
Mat3 lowerRoot(const Mat3& m) noexcept
{
  const double rounding = 1e-14 * m.trace();
  Mat3 l = Mat3::Zero();
  if (!(rounding > 0.0)) // where all corners have one compliance, m itself is rounding, of either sign
  {
    return l;
  }
  for (int j = 0; j < 3; ++j)
  {
    const double pivot = m(j, j) - l.row(j).squaredNorm();
    if (pivot <= rounding)
    {
      continue;
    }
    l(j, j) = std::sqrt(pivot);
    for (int i = j + 1; i < 3; ++i)
    {
      l(i, j) = (m(i, j) - l.row(i).dot(l.row(j))) / l(j, j);
    }
  }
  return l;
}

} // namespace

CompliantPoint compliantPoint(const ComplianceSnapshot& snapshot, const SurfacePoint& at) noexcept
{
  Mat3 mean = Mat3::Zero();
  double patch_u = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    mean += at.weights[i] * snapshot.between(at.vertices[i], at.vertices[i]);
    patch_u += at.weights[i] * snapshot.patchRadius_u[snapshot.placeOf[at.vertices[i]]];
  }
  return { at, lowerRoot(mean - bilinear(snapshot, at, at)), patch_u };
}

Mat3 complianceBetween(const ComplianceSnapshot& snapshot, const CompliantPoint& a, const CompliantPoint& b) noexcept
{
  return bilinear(snapshot, a.at, b.at) + sharedBy(a, b) * a.own * b.own.transpose();
}

// A rational quadratic is positive definite in spaces of any dimension, so it stays so where the radius changes from
// point to point (Paciorek & Schervish 2004).
double sharedBy(const CompliantPoint& a, const CompliantPoint& b) noexcept
{
  const double mean2_u2 = 0.5 * (a.patch_u * a.patch_u + b.patch_u * b.patch_u);
  const double alike = a.patch_u * b.patch_u / mean2_u2;
  const double fall = 1.0 / (1.0 + 0.125 * (a.at.x_W - b.at.x_W).squaredNorm() / mean2_u2);
  const double fall2 = fall * fall;
  const double fall4 = fall2 * fall2;
  return alike * std::sqrt(alike) * fall4 * fall4;
}

SubgridSpring springAt(const ComplianceSnapshot& snapshot, const SurfacePoint& at) noexcept
{
  SubgridSpring spring;
  for (int i = 0; i < 3; ++i)
  {
    const SubgridSpring& one = snapshot.springs[snapshot.placeOf[at.vertices[i]]];
    spring.hertz += at.weights[i] * one.hertz;
    spring.patch += at.weights[i] * one.patch;
    spring.across += at.weights[i] * one.across;
    spring.step = one.step;
    for (std::size_t k = 0; k < SubgridSpring::knots; ++k)
    {
      spring.depth_u[k] += at.weights[i] * one.depth_u[k];
      spring.rise[k] += at.weights[i] * one.rise[k];
    }
  }
  return spring;
}

} // namespace palpate
