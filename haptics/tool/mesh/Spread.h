// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "haptics/core/Types.h"

namespace palpate
{

/// Moments that determine the axes of a box: area, centroid and second moments of triangles.
struct Spread
{
  /// Area; its products with x, y, z; with xx, yy, zz, xy, yz, zx.
  Eigen::Array<double, 10, 1> sums = Eigen::Array<double, 10, 1>::Zero();

  Spread() = default;
  /// Of a triangle. `about`: a point of the mesh, about which moments are taken, so that far from the origin nothing
  /// cancels.
  Spread(std::array<Vec3, 3> corners, const Vec3& about)
  {
    const Vec3 across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double area = std::max(across.norm(), std::numeric_limits<double>::min());
    for (Vec3& p : corners)
    {
      p -= about;
    }
    const Vec3 sum = corners[0] + corners[1] + corners[2];
    Vec3 squares = sum.cwiseProduct(sum), products = sum.cwiseProduct(next(sum));
    for (const Vec3& p : corners)
    {
      squares += p.cwiseProduct(p);
      products += p.cwiseProduct(next(p));
    }
    this->sums << area, area / 3.0 * sum.array(), area / 12.0 * squares.array(), area / 12.0 * products.array();
  }

  void operator+=(const Spread& more) { this->sums += more.sums; }

  /// Axes of its box as columns, the longest first.
  [[nodiscard]] Mat3 axes() const
  {
    const Mat3 covariance = this->covariance();
    const double scale = covariance.cwiseAbs().maxCoeff();
    if (!(scale > 0.0))
    {
      return Mat3::Identity();
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(covariance / scale);
    Mat3 axes;
    axes << solver.eigenvectors().col(2), solver.eigenvectors().col(1), Vec3::Zero();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
  }
  /// Root mean square of the distance from the centroid [u].
  [[nodiscard]] double length_u() const { return std::sqrt(this->covariance().trace()); }

private:
  static Vec3 next(const Vec3& v) { return { v.y(), v.z(), v.x() }; }

  [[nodiscard]] Mat3 covariance() const
  {
    const Eigen::Array<double, 9, 1> mean = this->sums.tail<9>() / this->sums[0];
    const auto of = [&mean](int product, int i, int j) { return mean[product] - mean[i] * mean[j]; };
    const double xy = of(6, 0, 1), yz = of(7, 1, 2), zx = of(8, 2, 0);
    Mat3 covariance;
    covariance << of(3, 0, 0), xy, zx, xy, of(4, 1, 1), yz, zx, yz, of(5, 2, 2);
    return covariance;
  }
};

/// How large the boxes of two parts are [u^2]: the box's faces, and its volume, so that two thin boxes count less than
/// two thick ones of equal faces. `length_u`: of the node that is cut. Both in one go: a processor does two roots or
/// divisions in the time of one.
[[nodiscard]] inline Eigen::Array2d boxCosts(const Spread& low, const Spread& high, double length_u)
{
  using Two = Eigen::Array2d;
  constexpr double thickness = 3.0; // 1 to 10 make no difference
  const Two area(low.sums[0], high.sums[0]);
  const auto mean = [&](int k) { return Two(Two(low.sums[k], high.sums[k]) / area); };
  const Two x = mean(1), y = mean(2), z = mean(3);
  const Two xx = mean(4) - x * x, yy = mean(5) - y * y, zz = mean(6) - z * z;
  const Two xy = mean(7) - x * y, yz = mean(8) - y * z, zx = mean(9) - z * x;
  const Two faces_u4 = xx * yy + yy * zz + zz * xx - xy * xy - yz * yz - zx * zx;
  const Two volume_u6 = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * zx) + zx * (xy * yz - yy * zx);
  const Two volume_u3 = volume_u6.max(0.0).sqrt();
  return faces_u4.max(0.0).sqrt() + thickness * (volume_u3 * length_u).sqrt();
}

} // namespace palpate
