// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/mesh/ExactPredicates.h"

#include <cmath>
#include <limits>

namespace palpate
{
namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon() / 2; // unit round-off 2^-53

/// A sum of doubles without overlap, smallest first; its last component carries the sign.
template<int Capacity>
struct Expansion
{
  double part[Capacity];
  int size = 0;

  void push(double value) noexcept
  {
    if (value != 0.0)
    {
      this->part[this->size++] = value;
    }
  }
  /// The sum, rounded hardly more than once: the components do not overlap.
  [[nodiscard]] double value() const noexcept
  {
    double value = 0.0;
    for (int i = 0; i < this->size; ++i)
    {
      value += this->part[i];
    }
    return value;
  }
  [[nodiscard]] int sign() const noexcept { return this->size == 0 ? 0 : (this->part[this->size - 1] > 0 ? 1 : -1); }
};

void twoSum(double a, double b, double& sum, double& error) noexcept
{
  sum = a + b;
  const double bVirtual = sum - a;
  error = (a - (sum - bVirtual)) + (b - bVirtual);
}

void twoProduct(double a, double b, double& product, double& error) noexcept
{
  constexpr double splitter = 134217729.0; // 2^27 + 1 (Dekker)
  product = a * b;
  const double ca = splitter * a;
  const double aHigh = ca - (ca - a);
  const double aLow = a - aHigh;
  const double cb = splitter * b;
  const double bHigh = cb - (cb - b);
  const double bLow = b - bHigh;
  error = aLow * bLow - (((product - aHigh * bHigh) - aLow * bHigh) - aHigh * bLow);
}

Expansion<2> difference(double a, double b) noexcept
{
  double sum, error;
  twoSum(a, -b, sum, error);
  Expansion<2> result;
  result.push(error);
  result.push(sum);
  return result;
}

/// Grows e by one double; keeps the order and the non-overlap (Shewchuk, Grow-Expansion).
template<int C>
void grow(Expansion<C>& e, double value) noexcept
{
  Expansion<C> result;
  double carry = value;
  for (int i = 0; i < e.size; ++i)
  {
    double sum, error;
    twoSum(carry, e.part[i], sum, error);
    result.push(error);
    carry = sum;
  }
  result.push(carry);
  e = result;
}

template<int A, int B>
Expansion<2 * A * B> product(const Expansion<A>& a, const Expansion<B>& b) noexcept
{
  Expansion<2 * A * B> result;
  for (int i = 0; i < a.size; ++i)
  {
    for (int j = 0; j < b.size; ++j)
    {
      double high, low;
      twoProduct(a.part[i], b.part[j], high, low);
      grow(result, low);
      grow(result, high);
    }
  }
  return result;
}

template<int A, int B>
Expansion<A + B> sum(const Expansion<A>& a, const Expansion<B>& b, double signOfB) noexcept
{
  Expansion<A + B> result;
  for (int i = 0; i < a.size; ++i)
  {
    result.push(a.part[i]);
  }
  for (int j = 0; j < b.size; ++j)
  {
    grow(result, signOfB * b.part[j]);
  }
  return result;
}

/// |u v; s t| = u t - v s
Expansion<16> minor2(
  const Expansion<2>& u, const Expansion<2>& v, const Expansion<2>& s, const Expansion<2>& t) noexcept
{
  return sum(product(u, t), product(v, s), -1.0);
}

int exactOrientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept
{
  Expansion<2> p[3], q[3], r[3];
  for (int k = 0; k < 3; ++k)
  {
    p[k] = difference(b[k], a[k]);
    q[k] = difference(c[k], a[k]);
    r[k] = difference(d[k], a[k]);
  }
  const auto x = product(minor2(q[1], q[2], r[1], r[2]), p[0]);
  const auto y = product(minor2(q[2], q[0], r[2], r[0]), p[1]);
  const auto z = product(minor2(q[0], q[1], r[0], r[1]), p[2]);
  return sum(sum(x, y, 1.0), z, 1.0).sign();
}

} // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept
{
  const double px = b.x() - a.x(), py = b.y() - a.y(), pz = b.z() - a.z();
  const double qx = c.x() - a.x(), qy = c.y() - a.y(), qz = c.z() - a.z();
  const double rx = d.x() - a.x(), ry = d.y() - a.y(), rz = d.z() - a.z();
  const double yz = qy * rz, zy = qz * ry, zx = qz * rx, xz = qx * rz, xy = qx * ry, yx = qy * rx;
  const double det = px * (yz - zy) + py * (zx - xz) + pz * (xy - yx);
  const double permanent = std::fabs(px) * (std::fabs(yz) + std::fabs(zy)) +
                           std::fabs(py) * (std::fabs(zx) + std::fabs(xz)) +
                           std::fabs(pz) * (std::fabs(xy) + std::fabs(yx));
  const double bound = (7.0 + 56.0 * epsilon) * epsilon * permanent; // Shewchuk's A bound
  if (det > bound || -det > bound)
  {
    return det > 0 ? 1 : -1;
  }
  return permanent == 0.0 ? 0 : exactOrientation(a, b, c, d);
}

int orientation2(double ax, double ay, double bx, double by, double cx, double cy) noexcept
{
  const double left = (bx - ax) * (cy - ay);
  const double right = (by - ay) * (cx - ax);
  const double det = left - right;
  const double bound = (3.0 + 16.0 * epsilon) * epsilon * (std::fabs(left) + std::fabs(right));
  if (det > bound || -det > bound)
  {
    return det > 0 ? 1 : -1;
  }
  return minor2(difference(bx, ax), difference(by, ay), difference(cx, ax), difference(cy, ay)).sign();
}

Vec3 exactCross(const Vec3& a, const Vec3& b, const Vec3& c) noexcept
{
  Expansion<2> p[3], q[3];
  for (int k = 0; k < 3; ++k)
  {
    p[k] = difference(b[k], a[k]);
    q[k] = difference(c[k], a[k]);
  }
  return { minor2(p[1], p[2], q[1], q[2]).value(), minor2(p[2], p[0], q[2], q[0]).value(),
    minor2(p[0], p[1], q[0], q[1]).value() };
}

bool exactlyCollinear(const Vec3& a, const Vec3& b, const Vec3& c) noexcept
{
  return orientation2(a.x(), a.y(), b.x(), b.y(), c.x(), c.y()) == 0 &&
         orientation2(a.y(), a.z(), b.y(), b.z(), c.y(), c.z()) == 0 &&
         orientation2(a.z(), a.x(), b.z(), b.x(), c.z(), c.x()) == 0;
}

} // namespace palpate
