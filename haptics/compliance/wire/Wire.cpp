// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/wire/Wire.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "haptics/core/Across.h"

namespace palpate
{
namespace
{

Quat alongX(const Vec3& direction) noexcept
{
  const auto [y, z] = tangentsOf(direction);
  return Quat((Mat3() << direction, y, z).finished());
}

/// The shortest turn from one direction to another.
Quat shortestTurn(const Vec3& from, const Vec3& to) noexcept
{
  const double w = 1.0 + from.dot(to);
  const Vec3 axis = w > 1e-12 ? Vec3(from.cross(to)) : acrossOf(from);
  return Quat(w, axis.x(), axis.y(), axis.z()).normalized();
}

std::string problemOf(const BeamSection& s)
{
  for (const auto& [name, value] : { std::pair{ "stretching", s.stretch_N }, std::pair{ "bending", s.bend_Nu2 },
         std::pair{ "twisting", s.twist_Nu2 } })
  {
    if (!(value > 0.0) || !std::isfinite(value))
    {
      return std::string("its stiffness against ") + name + " must be a number above 0";
    }
  }
  return s.shear_N > 0.0 ? "" : "its stiffness against shear must be above 0";
}

} // namespace

BeamSection roundSection(double radius_u, double young_N_per_u2, double poisson) noexcept
{
  const double area_u2 = std::numbers::pi * radius_u * radius_u;
  const double second_u4 = 0.25 * area_u2 * radius_u * radius_u;
  const double shear = young_N_per_u2 / (2.0 * (1.0 + poisson));
  const double factor = 6.0 * (1.0 + poisson) / (7.0 + 6.0 * poisson);
  return { young_N_per_u2 * area_u2, factor * shear * area_u2, young_N_per_u2 * second_u4, 2.0 * shear * second_u4 };
}

WirePlaces placesAlong(std::span<const Vec3> points_W) noexcept
{
  WirePlaces places;
  Quat q = Quat::Identity();
  const int last = static_cast<int>(points_W.size()) - 1;
  for (int i = 0; i <= last; ++i)
  {
    if (i < last)
    {
      const Vec3 along = (points_W[i + 1] - points_W[i]).normalized();
      q = i == 0 ? alongX(along) : shortestTurn(q * Vec3::UnitX(), along) * q;
      q.normalize();
    }
    places[i] = { points_W[i], q };
  }
  return places;
}

Outcome<Wire> makeWire(std::span<const Vec3> points_W, std::span<const BeamSection> sections)
{
  Outcome<Wire> made;
  const int beams = static_cast<int>(points_W.size()) - 1;
  if (beams < 1 || beams > Wire::mostBeams)
  {
    made.problem = "a wire has 1 to " + std::to_string(Wire::mostBeams) + " beams, not " +
                   std::to_string(std::max(beams, 0)) + ": give points further apart";
    return made;
  }
  if (sections.size() != 1 && static_cast<int>(sections.size()) != beams)
  {
    made.problem = "give one section for all beams of the wire, or " + std::to_string(beams) + ", not " +
                   std::to_string(sections.size());
    return made;
  }
  const WirePlaces rest = placesAlong(points_W);
  made.value.count = beams;
  for (int i = 0; i < beams; ++i)
  {
    WireBeam& beam = made.value.beams[i];
    beam.section = sections.size() == 1 ? sections[0] : sections[i];
    beam.length_u = (points_W[i + 1] - points_W[i]).norm();
    beam.second = rest[i + 1].q.conjugate() * rest[i].q;
    std::string problem = problemOf(beam.section);
    if (!(beam.length_u > 0.0) || !std::isfinite(beam.length_u))
    {
      problem = "its length must be a number above 0";
    }
    if (!problem.empty())
    {
      made.problem = "beam " + std::to_string(i + 1) + " of the wire: " + problem;
      return made;
    }
  }
  return made;
}

} // namespace palpate
