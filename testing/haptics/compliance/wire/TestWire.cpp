// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/compliance/wire/WireShape.h"
#include "testing/support/WireScenes.h"

namespace palpate::test
{
namespace
{

using testing::HasSubstr;

double lengthOf(const std::vector<Vec3>& points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

Vec3 lastDirection(const std::vector<Vec3>& points)
{
  return (points.back() - points[points.size() - 2]).normalized();
}

TEST(Wire, ARoundRodHasTheStiffnessOfTheTextbooks)
{
  constexpr double r = 0.25, young = 60e3, nu = 0.3;
  const BeamSection section = roundSection(r, young, nu);
  EXPECT_DOUBLE_EQ(section.stretch_N, young * std::numbers::pi * r * r);
  EXPECT_DOUBLE_EQ(section.bend_Nu2, young * std::numbers::pi * std::pow(r, 4) / 4.0);
  EXPECT_DOUBLE_EQ(section.twist_Nu2, young / (2.0 * 1.3) * std::numbers::pi * std::pow(r, 4) / 2.0);
  EXPECT_DOUBLE_EQ(section.shear_N, young / (2.0 * 1.3) * std::numbers::pi * r * r * 6.0 * 1.3 / 8.8);
}

TEST(Wire, ItsTipIsStraightOrBentBy45DegreesOrAHook)
{
  const std::vector<Vec3> straight = pointsOf({ 10.0, 20 }).value;
  EXPECT_EQ(straight.back(), Vec3(10.0, 0.0, 0.0));
  const std::vector<Vec3> angled = pointsOf({ 10.0, 20, WireTip::Angled, 2.0 }).value;
  EXPECT_LE((lastDirection(angled) - Vec3(std::sqrt(0.5), std::sqrt(0.5), 0.0)).norm(), 1e-14);
  EXPECT_NEAR(lengthOf(angled), 10.0, 1e-14);
  EXPECT_LE((angled[16] - Vec3(8.0, 0.0, 0.0)).norm(), 1e-14);
  const std::vector<Vec3> hook = pointsOf({ 10.0, 40, WireTip::Hook, 5.0 }).value;
  // Half a turn of 5: its end is two radii away from where it began.
  EXPECT_LE((hook.back() - Vec3(5.0, 10.0 / std::numbers::pi, 0.0)).norm(), 1e-14);
}

TEST(Wire, AHelixKeepsItsDistanceFromItsAxisAndItsPitch)
{
  const double radius = 3.0, pitch = 2.0, turn = std::hypot(2.0 * std::numbers::pi * radius, pitch);
  const std::vector<Vec3> points = pointsOf({ turn, 64, WireTip::Helix, turn, radius, pitch }).value;
  const Vec3 axis = Vec3(pitch / (2.0 * std::numbers::pi), 0.0, radius).normalized(), middle(0.0, radius, 0.0);
  for (const Vec3& p : points)
  {
    EXPECT_NEAR((p - middle).cross(axis).norm(), radius, 1e-13);
  }
  EXPECT_LE((points.back() - pitch * axis).norm(), 1e-13); // a pitch further after a turn
  EXPECT_LE((points[1].normalized() - Vec3::UnitX()).norm(), 0.06);
}

TEST(Wire, AtRestNoNodeFeelsAForceWithAnyTip)
{
  for (const WireShape& shape : { WireShape{ 10.0, 20, WireTip::Angled, 2.0 },
         WireShape{ 10.0, 20, WireTip::Hook, 5.0 }, WireShape{ 10.0, 20, WireTip::Helix, 8.0, 0.5, 0.4 } })
  {
    WireRig rig(pointsOf(shape).value, roundSection(0.1, 1e3, 0.3));
    rig.loads.held[0] = WireLoads::clamped;
    ASSERT_TRUE(rig.newton->linearise(rig.wire, rig.places_W, rig.loads));
    EXPECT_LE(rig.newton->residual_N(), 1e-12);
    EXPECT_TRUE(rig.newton->firm());
  }
}

TEST(Wire, AStiffShaftWithASoftTipIsOneWire)
{
  BeamSection soft = roundSection(0.1, 1e3, 0.3), stiff = roundSection(0.1, 1e5, 0.3);
  std::vector<BeamSection> sections(10, stiff);
  sections.back() = soft;
  const Outcome<Wire> wire = makeWire(straightPoints(10, 1.0), sections);
  ASSERT_EQ(wire.problem, "");
  EXPECT_EQ(wire.value.beams[8].section.bend_Nu2, stiff.bend_Nu2);
  EXPECT_EQ(wire.value.beams[9].section.bend_Nu2, soft.bend_Nu2);
}

TEST(Wire, SaysWhichBeamCannotBe)
{
  const BeamSection section = thinSection();
  const auto problemOf = [&section](std::span<const Vec3> points) { return makeWire(points, { &section, 1 }).problem; };
  EXPECT_THAT(problemOf(straightPoints(1, 1.0)), "");
  EXPECT_THAT(problemOf(std::vector<Vec3>(1, Vec3::Zero())), HasSubstr("1 to 64 beams, not 0"));
  EXPECT_THAT(
    problemOf(std::vector<Vec3>(66, Vec3::Zero())), HasSubstr("1 to 64 beams, not 65: give points further apart"));
  std::vector<Vec3> points = straightPoints(4, 1.0);
  points[2] = points[1];
  EXPECT_EQ(problemOf(points), "beam 2 of the wire: its length must be a number above 0");
  points[2].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(problemOf(points), "beam 2 of the wire: its length must be a number above 0");
  std::vector<BeamSection> sections(2, section);
  EXPECT_EQ(
    makeWire(straightPoints(4, 1.0), sections).problem, "give one section for all beams of the wire, or 4, not 2");
  sections.resize(4, section);
  sections[3].twist_Nu2 = 0.0;
  EXPECT_EQ(makeWire(straightPoints(4, 1.0), sections).problem,
    "beam 4 of the wire: its stiffness against twisting must be a number above 0");
  sections[3] = section;
  sections[0].shear_N = -1.0;
  EXPECT_EQ(makeWire(straightPoints(4, 1.0), sections).problem,
    "beam 1 of the wire: its stiffness against shear must be above 0");
}

TEST(Wire, SaysWhichShapeCannotBe)
{
  EXPECT_THAT(pointsOf({ 1.0, 65 }).problem, HasSubstr("1 to 64 beams, not 65"));
  EXPECT_THAT(pointsOf({ 0.0, 5 }).problem, HasSubstr("length of a wire"));
  EXPECT_THAT(pointsOf({ std::numeric_limits<double>::infinity(), 5 }).problem, HasSubstr("length of a wire"));
  EXPECT_THAT(pointsOf({ 1.0, 5, WireTip::Hook, 1.5 }).problem, HasSubstr("not longer than the wire"));
  EXPECT_THAT(pointsOf({ 1.0, 5, WireTip::Helix, 0.5 }).problem, HasSubstr("a helix needs a radius"));
}

} // namespace
} // namespace palpate::test
