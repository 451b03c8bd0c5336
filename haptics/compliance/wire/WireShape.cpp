// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/wire/WireShape.h"

#include <cmath>
#include <numbers>

#include "haptics/compliance/wire/Wire.h"

namespace palpate
{
namespace
{

/// Of a helix that leaves the origin along x and bends towards y, so far along it.
Vec3 onHelix(double radius_u, double pitch_u, double s_u) noexcept
{
  const double rise_u = 0.5 * pitch_u / std::numbers::pi; // a radian
  const double speed_u = std::hypot(radius_u, rise_u);
  const double phi = s_u / speed_u;
  return { (radius_u * radius_u * std::sin(phi) + rise_u * rise_u * phi) / speed_u, radius_u * (1.0 - std::cos(phi)),
    radius_u * rise_u * (phi - std::sin(phi)) / speed_u };
}

/// A place in the tip, so far along it from where it begins.
Vec3 inTip(const WireShape& shape, double s_u) noexcept
{
  switch (shape.tip)
  {
    case WireTip::Angled:
      return s_u * Vec3(1.0, 1.0, 0.0) / std::numbers::sqrt2;
    case WireTip::Hook:
      return onHelix(shape.tip_u / std::numbers::pi, 0.0, s_u);
    case WireTip::Helix:
      return onHelix(shape.radius_u, shape.pitch_u, s_u);
    case WireTip::Straight:
      break;
  }
  return s_u * Vec3::UnitX();
}

std::string problemOf(const WireShape& shape)
{
  if (shape.beams < 1 || shape.beams > Wire::mostBeams)
  {
    return "a wire has 1 to " + std::to_string(Wire::mostBeams) + " beams, not " + std::to_string(shape.beams);
  }
  if (!(shape.length_u > 0.0) || !std::isfinite(shape.length_u))
  {
    return "the length of a wire must be a number above 0";
  }
  if (shape.tip != WireTip::Straight && !(shape.tip_u > 0.0 && shape.tip_u <= shape.length_u))
  {
    return "the tip of a wire must be longer than 0 and not longer than the wire";
  }
  if (shape.tip == WireTip::Helix &&
      !(shape.radius_u > 0.0 && std::isfinite(shape.radius_u) && std::isfinite(shape.pitch_u)))
  {
    return "a helix needs a radius above 0 and a pitch";
  }
  return "";
}

} // namespace

Outcome<std::vector<Vec3>> pointsOf(const WireShape& shape)
{
  Outcome<std::vector<Vec3>> points;
  points.problem = problemOf(shape);
  if (!points.ok())
  {
    return points;
  }
  const double shaft_u = shape.tip == WireTip::Straight ? shape.length_u : shape.length_u - shape.tip_u;
  for (int i = 0; i <= shape.beams; ++i)
  {
    const double s_u = shape.length_u * i / shape.beams;
    const Vec3 end = std::min(s_u, shaft_u) * Vec3::UnitX();
    points.value.push_back(s_u > shaft_u ? Vec3(end + inTip(shape, s_u - shaft_u)) : end);
  }
  return points;
}

} // namespace palpate
