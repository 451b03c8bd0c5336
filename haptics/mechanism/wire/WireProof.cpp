// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/wire/WireProof.h"

#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{

/// Of the distance from the wall: so far the axis of a beam goes in a step.
constexpr double proven = 0.9;

/// Of the wall from a beam and from those beside it, onto whose lines it slides.
double wallAway_u(const WireAmongWalls& wire, int beam) noexcept
{
  const auto& away_u = wire.near.away_u;
  const int last = wire.plan.wire.count - 1;
  return std::min(
    { wire.plan.mouthAway_u, away_u[std::max(beam - 1, 0)], away_u[beam], away_u[std::min(beam + 1, last)] });
}

/// How far a place that slides so far from one beam to the other leaves its line, of its way: the sine of the angle
/// between them. Nothing goes on past the tip, and the outer end stays in the sheath.
double leavesBy(const WireAmongWalls& wire, int beam, int other, double way_u) noexcept
{
  if (other < 0 || other >= wire.plan.wire.count)
  {
    return other < 0 ? 0.0 : 1.0;
  }
  const Vec3 a = chordOf(wire.places_M, beam), b = chordOf(wire.places_M, other);
  const double length_u = b.norm();
  const bool onLine = way_u < length_u && a.dot(b) > 0.0;
  return onLine ? a.cross(b).norm() / (a.norm() * length_u) : 1.0;
}

/// How far places of a beam go from the wire as it was, at the most: all go along straight lines, and by a mean of both
/// nodes' ways. One that slides along the beam comes onto the line of the next one.
double goesOffWire_u(const WireAmongWalls& wire, int beam, const WireVector& motion) noexcept
{
  const Vec3 first = motion[beam].head<3>(), second = motion[beam + 1].head<3>();
  const Vec3 along_M = chordOf(wire.places_M, beam).normalized();
  const double firstAlong_u = along_M.dot(first), secondAlong_u = along_M.dot(second);
  const double across_u = std::max((first - firstAlong_u * along_M).norm(), (second - secondAlong_u * along_M).norm());
  const double on_u = std::max({ firstAlong_u, secondAlong_u, 0.0 });
  const double back_u = std::max({ -firstAlong_u, -secondAlong_u, 0.0 });
  return across_u + on_u * leavesBy(wire, beam, beam + 1, on_u) + back_u * leavesBy(wire, beam, beam - 1, back_u);
}

int nearestTo(const WirePress& before, std::span<const WireContact* const> contacts) noexcept
{
  int nearest = -1;
  double nearest2_u2 = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(contacts.size()); ++i)
  {
    const double away2_u2 = (before.at_M - contacts[i]->at_M).squaredNorm();
    if (contacts[i]->beam == before.beam && away2_u2 < nearest2_u2)
    {
      nearest2_u2 = away2_u2;
      nearest = i;
    }
  }
  return nearest;
}

} // namespace

double provenShare(const WireAmongWalls& wire, const WireVector& motion) noexcept
{
  double share = 1.0;
  for (int b = 0; b < wire.plan.wire.count; ++b)
  {
    const double goes_u = goesOffWire_u(wire, b, motion);
    const double reach_u = b + 1 < wire.plan.wire.count ? wire.reach.shaft_u : wire.reach.tip_u;
    const double most_u = std::min(proven * wallAway_u(wire, b), reach_u);
    share = goes_u * share > most_u ? most_u / goes_u : share;
  }
  return share;
}

Vec3 goesOn_N(std::span<const WireContact* const> contacts, int contact, std::span<const WirePress> before) noexcept
{
  Vec3 force_N = Vec3::Zero();
  for (const WirePress& press : before)
  {
    if (press.beam == contacts[contact]->beam && nearestTo(press, contacts) == contact)
    {
      force_N = press.axes_N;
    }
  }
  return force_N;
}

} // namespace palpate
