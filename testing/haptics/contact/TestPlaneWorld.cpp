// SPDX-License-Identifier: GPL-3.0-or-later
// Two dimensions by the algorithm of three: a disc among lines is a ball among walls.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/geometry/curves/CurveSet.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"

namespace palpate::test
{
namespace
{

std::shared_ptr<const Scene> wallsOf(const CurveSet& curves)
{
  return test::sceneOf(raiseWalls(curves, 1.0));
}

/// Two lines from the origin into the half-plane x > 0 that enclose the given angle about the x axis.
CurveSet wedge(double angle_rad)
{
  const double c = std::cos(angle_rad / 2), s = std::sin(angle_rad / 2);
  return { { { 0, 0 }, { 10 * c, 10 * s }, { 10 * c, -10 * s } }, { { 0, 1 }, { 0, 2 } } };
}

// The disc's centre keeps r from both lines: it rests at distance r / sin(angle / 2) from the tip (row 19 in the
// plane).
TEST(PlaneWorld, ADiscPushedIntoAWedgeRestsAtRadiusOverSineOfHalfTheAngleInOneTick)
{
  for (const double degrees : { 90.0, 60.0, 30.0, 10.0 })
  {
    const double half = degrees / 2 * std::numbers::pi / 180, r = 0.1;
    Probe probe(wallsOf(wedge(2 * half)), r, { 5, 0, 0 });
    probe.to({ -1, 0, 0 });
    EXPECT_NEAR(probe.x_W().x(), r / std::sin(half), 1e-12) << degrees;
    EXPECT_NEAR(probe.x_W().y(), 0.0, 1e-12) << degrees;
    EXPECT_EQ(probe.x_W().z(), 0.0) << degrees;
  }
}

// Led round the end of a line, the centre follows the taut string: never nearer to the line than r, and on the circle
// of radius r round the end while the device pulls it inwards.
TEST(PlaneWorld, ADiscLedRoundTheEndOfALineRollsOnACircleOfItsRadius)
{
  const double r = 0.2;
  Probe probe(wallsOf(CurveSet{ { { -5, 0 }, { 0, 0 } }, { { 0, 1 } } }), r, { -0.3, 0.5, 0 });
  for (int i = 0; i <= 400; ++i)
  {
    const double angle = std::numbers::pi * (0.75 - 1.5 * i / 400.0); // from above the line round its end to below
    const Vec3 p(0.05 * std::cos(angle), 0.05 * std::sin(angle), 0);
    probe.to(p);
    const Vec3 x = probe.x_W();
    const double distance = x.x() <= 0 ? std::fabs(x.y()) : x.norm();
    ASSERT_NEAR(distance, r, 1e-12) << "step " << i;
    ASSERT_EQ(x.z(), 0.0) << "step " << i;
    if (p.x() > 0)
    {
      ASSERT_LE((x - r * p.normalized()).norm(), 1e-12) << "step " << i;
    }
  }
}

TEST(PlaneWorld, APointNeverCrossesALineFromEitherSideAndItsForceIsStiffnessTimesDepth)
{
  for (const double side : { 1.0, -1.0 })
  {
    Probe probe(wallsOf(CurveSet{ { { -5, 0 }, { 0, 0 }, { 5, 0 } }, { { 0, 1 }, { 1, 2 } } }), 0.0, { -2, side, 0 });
    for (int i = 0; i <= 100; ++i)
    {
      probe.to({ -2 + 0.04 * i, -0.5 * side, 0 });
      ASSERT_NEAR(probe.force(1000.0).y(), 500.0 * side, 1e-9);
      ASSERT_NEAR(probe.force(1000.0).x(), 0.0, 1e-9);
    }
  }
}

} // namespace
} // namespace palpate::test
