// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace palpate::test
{

/// A number with its first and second derivatives by the coordinates that it is made of (forward differentiation).
struct Jet
{
  double value = 0.0;
  Eigen::VectorXd first;
  Eigen::MatrixXd second;

  static Jet constant(double value, Eigen::Index coordinates)
  {
    return { value, Eigen::VectorXd::Zero(coordinates), Eigen::MatrixXd::Zero(coordinates, coordinates) };
  }
  static Jet coordinate(double value, Eigen::Index which, Eigen::Index coordinates)
  {
    Jet jet = constant(value, coordinates);
    jet.first[which] = 1.0;
    return jet;
  }

  /// f of this: f, f' and f'' are known where it is.
  [[nodiscard]] Jet by(double f, double df, double ddf) const
  {
    return { f, df * this->first, df * this->second + ddf * this->first * this->first.transpose() };
  }

  friend Jet operator+(const Jet& a, const Jet& b)
  {
    return { a.value + b.value, a.first + b.first, a.second + b.second };
  }
  friend Jet operator-(const Jet& a, const Jet& b)
  {
    return { a.value - b.value, a.first - b.first, a.second - b.second };
  }
  friend Jet operator*(const Jet& a, const Jet& b)
  {
    return { a.value * b.value, a.value * b.first + b.value * a.first,
      a.value * b.second + b.value * a.second + a.first * b.first.transpose() + b.first * a.first.transpose() };
  }
  friend Jet operator+(const Jet& a, double b) { return { a.value + b, a.first, a.second }; }
  friend Jet operator-(const Jet& a, double b) { return a + (-b); }
  friend Jet operator-(double a, const Jet& b) { return { a - b.value, -b.first, -b.second }; }
  friend Jet operator*(double a, const Jet& b) { return { a * b.value, a * b.first, a * b.second }; }
};

[[nodiscard]] inline Jet sqrt(const Jet& x)
{
  const double root = std::sqrt(x.value);
  return x.by(root, 0.5 / root, -0.25 / (root * x.value));
}

/// A point or a vector of such numbers.
struct JetVector
{
  Jet x, y, z;

  friend JetVector operator+(const JetVector& a, const JetVector& b) { return { a.x + b.x, a.y + b.y, a.z + b.z }; }
  friend JetVector operator-(const JetVector& a, const JetVector& b) { return { a.x - b.x, a.y - b.y, a.z - b.z }; }
  friend JetVector operator*(double s, const JetVector& a) { return { s * a.x, s * a.y, s * a.z }; }
  friend JetVector operator*(const Jet& s, const JetVector& a) { return { s * a.x, s * a.y, s * a.z }; }
  friend JetVector operator-(const JetVector& a, const Eigen::Vector3d& b)
  {
    return { a.x - b.x(), a.y - b.y(), a.z - b.z() };
  }
};

[[nodiscard]] inline Jet dot(const JetVector& a, const JetVector& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline Jet dot(const Eigen::Vector3d& a, const JetVector& b)
{
  return a.x() * b.x + a.y() * b.y + a.z() * b.z;
}
[[nodiscard]] inline JetVector cross(const JetVector& a, const JetVector& b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

} // namespace palpate::test
