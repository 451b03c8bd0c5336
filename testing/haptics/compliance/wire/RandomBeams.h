// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/wire/Wire.h"
#include "haptics/tool/motion/Turn.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// A thick beam, so that all of its stiffnesses matter alike, which is bent at rest.
inline Wire kinkedWire(int beams)
{
  std::vector<Vec3> points{ Vec3::Zero() };
  for (int i = 0; i < beams; ++i)
  {
    points.push_back(points.back() + Vec3(1.0, 0.2 * (i % 3), -0.3 * (i % 2)));
  }
  const BeamSection section{ 30.0, 20.0, 3.0, 2.0 };
  return makeWire(points, { &section, 1 }).value;
}

/// Poses some way from rest: places by at most `far`, turns likewise [rad].
inline WirePlaces bentAtRandom(const Wire& wire, double far, Random& random)
{
  std::vector<Vec3> points{ Vec3::Zero() };
  for (int i = 0; i < wire.count; ++i)
  {
    points.push_back(points.back() + wire.beams[i].length_u * Vec3::UnitX());
  }
  WirePlaces places = placesAlong(points);
  for (int i = 0; i < wire.nodes(); ++i)
  {
    places[i].p += random.inCube(far);
    places[i].q = turnBy(random.inCube(far)) * places[i].q;
  }
  return places;
}

} // namespace palpate::test
