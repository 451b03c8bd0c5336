// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "haptics/core/Types.h"

namespace palpate
{

/// A function that is linear along each axis between the eight corners of a cell, x fastest. Places are local: 0 to 1
/// along each axis inside, and the same polynomial is extended outside. Derivatives are per cell, not per length.
struct TrilinearCell
{
  std::array<double, 8> corner{};

  /// Along x, then y, then z. A weight of 0 or 1 is exact, so two cells agree bit for bit on the face between them.
  [[nodiscard]] double value(const Vec3& t) const noexcept
  {
    const auto& c = this->corner;
    const double low = lerp(lerp(c[0], c[1], t.x()), lerp(c[2], c[3], t.x()), t.y());
    const double high = lerp(lerp(c[4], c[5], t.x()), lerp(c[6], c[7], t.x()), t.y());
    return lerp(low, high, t.z());
  }

  [[nodiscard]] Vec3 gradient(const Vec3& t) const noexcept
  {
    const auto& c = this->corner;
    const double x00 = c[1] - c[0], x10 = c[3] - c[2], x01 = c[5] - c[4], x11 = c[7] - c[6];
    const double y00 = c[2] - c[0], y10 = c[3] - c[1], y01 = c[6] - c[4], y11 = c[7] - c[5];
    const double z00 = c[4] - c[0], z10 = c[5] - c[1], z01 = c[6] - c[2], z11 = c[7] - c[3];
    return { lerp(lerp(x00, x10, t.y()), lerp(x01, x11, t.y()), t.z()),
      lerp(lerp(y00, y10, t.x()), lerp(y01, y11, t.x()), t.z()),
      lerp(lerp(z00, z10, t.x()), lerp(z01, z11, t.x()), t.y()) };
  }

  /// Second derivatives: by y and z, by z and x, by x and y. Those along one axis are 0.
  [[nodiscard]] Vec3 mixed(const Vec3& t) const noexcept
  {
    const auto& c = this->corner;
    const double yz0 = (c[6] - c[4]) - (c[2] - c[0]), yz1 = (c[7] - c[5]) - (c[3] - c[1]);
    const double zx0 = (c[5] - c[4]) - (c[1] - c[0]), zx1 = (c[7] - c[6]) - (c[3] - c[2]);
    const double xy0 = (c[3] - c[2]) - (c[1] - c[0]), xy1 = (c[7] - c[6]) - (c[5] - c[4]);
    return { lerp(yz0, yz1, t.x()), lerp(zx0, zx1, t.y()), lerp(xy0, xy1, t.z()) };
  }

  [[nodiscard]] double least() const noexcept
  {
    double least = this->corner[0];
    for (const double value : this->corner)
    {
      least = value < least ? value : least;
    }
    return least;
  }

  [[nodiscard]] double largestMagnitude() const noexcept
  {
    double largest = 0.0;
    for (const double value : this->corner)
    {
      largest = std::fabs(value) > largest ? std::fabs(value) : largest;
    }
    return largest;
  }

  /// False where any corner has no value.
  [[nodiscard]] bool valid() const noexcept
  {
    double sum = 0.0;
    for (const double value : this->corner)
    {
      sum += value;
    }
    return sum == sum;
  }

private:
  [[nodiscard]] static double lerp(double a, double b, double t) noexcept { return (1.0 - t) * a + t * b; }
};

} // namespace palpate
