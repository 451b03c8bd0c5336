// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/packet/PointCompliance.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

Mat3 bilinear(const CompliancePacket& packet, const SurfacePoint& a, const SurfacePoint& b) noexcept
{
  Mat3 sum = Mat3::Zero();
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      sum += a.weights[i] * b.weights[j] * packet.between(a.vertices[i], b.vertices[j]);
    }
  }
  return sum;
}

/// L with L L^T = m, m positive semidefinite but for rounding: a direction without compliance gets none.
Mat3 lowerRoot(const Mat3& m) noexcept
{
  const double rounding = 1e-14 * m.trace();
  Mat3 l = Mat3::Zero();
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

/// Falls to a half where exp(-(d/a)^2) does, a the patch's radius; 0 from 2.4 of it on.
double fallOff(double distance_u, double patch_u) noexcept
{
  const double r = distance_u / (2.4 * patch_u);
  const double left = std::max(1.0 - r, 0.0);
  return left * left * left * left * (4.0 * r + 1.0);
}

} // namespace

CompliantPoint compliantPoint(const CompliancePacket& packet, const SurfacePoint& at) noexcept
{
  Mat3 mean = Mat3::Zero();
  double patch_u = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    mean += at.weights[i] * packet.between(at.vertices[i], at.vertices[i]);
    patch_u += at.weights[i] * packet.patchRadius_u[packet.placeOf[at.vertices[i]]];
  }
  return { at, lowerRoot(mean - bilinear(packet, at, at)), patch_u };
}

Mat3 complianceBetween(const CompliancePacket& packet, const CompliantPoint& a, const CompliantPoint& b) noexcept
{
  const double beyond = fallOff((a.at.x_W - b.at.x_W).norm(), std::min(a.patch_u, b.patch_u));
  return bilinear(packet, a.at, b.at) + beyond * a.own * b.own.transpose();
}

SubgridSpring springAt(const CompliancePacket& packet, const SurfacePoint& at) noexcept
{
  SubgridSpring spring;
  for (int i = 0; i < 3; ++i)
  {
    const SubgridSpring& one = packet.springs[packet.placeOf[at.vertices[i]]];
    spring.hertz += at.weights[i] * one.hertz;
    spring.patch += at.weights[i] * one.patch;
  }
  return spring;
}

} // namespace palpate
