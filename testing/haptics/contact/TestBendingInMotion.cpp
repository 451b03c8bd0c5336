// SPDX-License-Identifier: GPL-3.0-or-later
// A surface that moves as a whole while its vertices are on their paths: each tick's force is that of its pose of that
// moment on its shape of that moment.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/geometry/mesh/PolyLines.h"
#include "testing/haptics/contact/BendingSheet.h"
#include "testing/support/Bender.h"
#include "testing/support/Meshes.h"
#include "testing/support/SheetHeight.h"

namespace palpate::test
{
namespace
{

/// Goes on and turns about a slanted axis.
Pose tumbling(double time_s)
{
  const Vec3 axis_W = Vec3(2, -1, 0.5).normalized();
  return { time_s * Vec3(0.02, -0.01, 0.03), Quat(Eigen::AngleAxisd(0.8 * time_s, axis_W)) };
}

Vec3 toSurface(const Pose& pose_WS, const Vec3& x_W)
{
  return pose_WS.q.conjugate() * (x_W - pose_WS.p);
}

constexpr double rounding = 1e-15; ///< of the transform into a frame and back, coordinates being less than 1

/// Height of a place over the sheet as it is felt, across the sheet's own plane.
double heightOver(const Bender& sheet, const Vec3& x_W)
{
  const Vec3 x_S = toSurface(sheet.pose_WS(), x_W);
  return x_S.z() - heightAt(sheet.mesh_S(), x_S);
}

class BendingInMotion : public testing::TestWithParam<double>
{
};

TEST_P(BendingInMotion, ASheetThatRisesInAFrameThatGoesAndTurnsPushesByTheDepthUnderBoth)
{
  const double radius = GetParam(), speed = 0.05;
  Bender sheet(
    sheetOf(20, 431), [=](const Vec3& v, double t_s) { return Vec3(v + Vec3(0, 0, speed * t_s)); }, at20Hz);
  sheet.path_WS = tumbling;
  sheet.parameters.contact.radius_u = radius;
  const Vec3 hand(0.0031, 0.0023, radius - 1e-3);
  static_cast<void>(sheet.tick(hand + Vec3(0, 0, 0.01)));
  for (int i = 2; i <= 400; ++i)
  {
    const TickOutput out = sheet.tick(hand);
    // A plane: z_S = the height it has risen to, which is the same at a snapshot and between two.
    const Pose pose_WS = sheet.pose_WS();
    const Vec3 normal_W = pose_WS.q * Vec3::UnitZ(), foot_W = pose_WS.p + speed * 1e-3 * i * normal_W;
    const double depth = normal_W.dot(foot_W - hand) + radius;
    ASSERT_GT(depth, 0.0);
    ASSERT_LE((out.state.force_D - K * depth * normal_W).norm(), 1e-9) << "tick " << i;
  }
}

TEST_P(BendingInMotion, AWaveIsFeltWhereItsVerticesAreUnderThePoseOfTheMoment)
{
  const double radius = GetParam();
  const auto wave = [](const Vec3& v, double t_s)
  { return Vec3(v.x(), v.y(), 5e-3 * std::sin(twoPi * (v.x() / 0.08 - 2.0 * t_s))); };
  Bender sheet(sheetOf(40, 432), wave, at20Hz);
  sheet.path_WS = [](double t_s)
  {
    const double swing = 0.3 * std::sin(4 * t_s);
    return Pose{ { 0.01 * std::sin(7 * t_s), 0, 0 }, Quat(Eigen::AngleAxisd(swing, Vec3(1, 1, 0).normalized())) };
  };
  sheet.parameters.contact.radius_u = radius;
  static_cast<void>(sheet.tick({ 0.0031, 0.0023, 0.05 }));
  int touching = 0;
  for (int i = 2; i <= 400; ++i)
  {
    const double along = 0.02 * std::sin(twoPi * 1e-3 * i);
    const TickOutput out = sheet.tick({ along, 0.0023, -0.02 });
    const Vec3 x = out.state.proxy_W.p;
    touching += out.state.contacts > 0 ? 1 : 0;
    ASSERT_NEAR(distanceTo(sheet.mesh(), x), radius, 1e-9) << "tick " << i;
    ASSERT_GT(heightOver(sheet, x), -rounding) << "tick " << i;
  }
  EXPECT_EQ(touching, 399);
}

TEST_P(BendingInMotion, APlatformThatSwellsWhileItComesAtAHandNeverPassesIt)
{
  const double radius = GetParam();
  for (const double speed : { 0.1, 1.0, 5.0 })
  {
    for (const double side : { 1.0, -1.0 })
    {
      for (const double swell : { 1.0, -0.5 }) // it comes at the hand, or goes back while its frame comes on
      {
        for (const double depth : { -0.02, 2e-3 }) // the hand waits in the air, or is pressed
        {
          const auto bump = [=](const Vec3& v, double t_s)
          {
            const double r2 = v.head<2>().squaredNorm() / (0.03 * 0.03);
            return Vec3(v.x(), v.y(), side * swell * speed * t_s * std::exp(-r2));
          };
          Bender sheet(sheetOf(30, 433), bump, 10);
          sheet.path_WS = [=](double t_s)
          {
            const Quat turn(Eigen::AngleAxisd(3 * speed * t_s, Vec3(1, 2, 5).normalized()));
            return Pose{ { 0, 0, side * speed * t_s }, turn };
          };
          sheet.parameters.contact.radius_u = radius;
          const Vec3 start(0.0131, 0.0043, side * (0.03 + radius)), hand(0.0131, 0.0043, side * (radius - depth));
          static_cast<void>(sheet.tick(start));
          for (int i = 2; i <= std::min(400, static_cast<int>(0.2 / speed * 1e3)); ++i)
          {
            const Vec3 x = sheet.tick(hand).state.proxy_W.p;
            const auto where = [&]
            {
              return std::to_string(speed) + " m/s, side " + std::to_string(side) + ", swell " + std::to_string(swell) +
                     ", tick " + std::to_string(i);
            };
            ASSERT_GT(side * heightOver(sheet, x), -rounding) << where();
            ASSERT_GE(distanceTo(sheet.mesh(), x), radius - 1e-9) << where();
          }
        }
      }
    }
  }
}

TEST_P(BendingInMotion, FrictionHoldsAHandAtTheSamePointOfItsTriangle)
{
  const double radius = GetParam();
  const auto stretch = [](const Vec3& v, double t_s)
  { return Vec3(v.x() * (1 + t_s), v.y() * (1 - 0.4 * t_s), 0.02 * t_s); };
  Bender sheet(sheetOf(20, 434), stretch, at20Hz);
  sheet.path_WS = tumbling;
  sheet.parameters.contact.radius_u = radius;
  sheet.parameters.contact.friction = { 100.0, 100.0 };
  const Vec3 hand(0.0371, 0.0263, -5e-3);
  static_cast<void>(sheet.tick(hand + Vec3(0, 0, 0.02)));
  static_cast<void>(sheet.tick(hand));
  const Vec3 landed_S = toSurface(sheet.pose_WS(), sheet.state.contact.x_W);
  const Vec3 inMesh(landed_S.x() / (1 + 2e-3), landed_S.y() / (1 - 0.4 * 2e-3), 0);
  for (int i = 3; i <= 300; ++i)
  {
    const TickOutput out = sheet.tick(hand);
    ASSERT_EQ(out.state.friction, FrictionState::Sticks) << "tick " << i;
    const Pose pose_WS = sheet.pose_WS();
    const Vec3 held_W = pose_WS.q * (stretch(inMesh, 1e-3 * i) + radius * Vec3::UnitZ()) + pose_WS.p;
    ASSERT_LE((out.state.proxy_W.p - held_W).norm(), 1e-9) << "tick " << i;
  }
}

TEST_P(BendingInMotion, AHandBetweenASheetThatComesAndAWallPassesNeither)
{
  const double radius = GetParam(), wall = 0.02;
  const auto come = [](const Vec3& v, double t_s)
  { return Vec3(v.x(), v.y(), 0.03 * t_s * std::exp(-v.head<2>().squaredNorm() / (0.05 * 0.05))); };
  Bender sheet(sheetOf(20, 435), come, at20Hz);
  sheet.path_WS = [](double t_s) {
    return Pose{ { 0, 0, 0.03 * t_s }, Quat(Eigen::AngleAxisd(0.5 * t_s, Vec3::UnitZ())) };
  };
  sheet.addStanding(shifted(sheetOf(7, 436), { 0, 0, wall }));
  sheet.parameters.contact.radius_u = radius;
  static_cast<void>(sheet.tick({ 0.0011, 0.0013, 0.01 }));
  for (int i = 2; i <= 330; ++i) // the top stands at 0.0198 then
  {
    const double swing = 0.02 * std::sin(0.05 * i);
    const Vec3 x = sheet.tick({ 0.0011, 0.0013, 0.01 + swing }).state.proxy_W.p;
    ASSERT_GT(heightOver(sheet, x), -rounding) << "tick " << i;
    ASSERT_LT(x.z(), wall) << "tick " << i;
  }
}

TEST_P(BendingInMotion, ATubeThatRisesInAFrameThatGoesAndTurnsPushesFromItsMiddleLine)
{
  const double tube = 5e-3, speed = 0.02;
  const PolyLines line{ { { -0.1, 0, 0 }, { -0.03, 0, 0 }, { 0.1, 0, 0 } }, { { 0, 1, 2 } } };
  Bender fibre(
    segmentsOf(line), [=](const Vec3& v, double t_s) { return Vec3(v + Vec3(0, 0, speed * t_s)); }, 20);
  fibre.lineRadius_u = tube;
  fibre.path_WS = tumbling;
  fibre.parameters.contact.radius_u = GetParam();
  static_cast<void>(fibre.tick({ 0, 0, 0.02 }));
  for (int i = 2; i <= 400; ++i)
  {
    const double time_s = 1e-3 * i;
    const Vec3 hand = time_s * Vec3(0.02, -0.01, 0.03 + speed) + Vec3(1e-3, 1e-3, 3e-3); // goes with the tube, about
    const TickOutput out = fibre.tick(hand);
    const Pose pose_WS = fibre.pose_WS();
    const Vec3 along_W = pose_WS.q * Vec3::UnitX(), from_W = hand - pose_WS.p - pose_WS.q * Vec3(0, 0, speed * time_s);
    const Vec3 across_W = from_W - along_W.dot(from_W) * along_W;
    const double pressed = tube + fibre.state.radius_u - across_W.norm();
    ASSERT_GT(pressed, 1e-4);
    ASSERT_LE((out.state.force_D - K * pressed * across_W.normalized()).norm(), 1e-9) << "tick " << i;
  }
}

TEST_P(BendingInMotion, ASnapshotThatComesEarlyStartsFromWhereTheSurfaceIsFelt)
{
  const double radius = GetParam(), rise = 0.03, lift = 0.02;
  Bender sheet(
    sheetOf(20, 437), [=](const Vec3& v, double t_s) { return Vec3(v + Vec3(0, 0, rise * t_s)); }, 20);
  sheet.path_WS = [=](double t_s) { return Pose{ { 0, 0, lift * t_s }, Quat(Eigen::AngleAxisd(t_s, Vec3::UnitZ())) }; };
  sheet.parameters.contact.radius_u = radius;
  const Vec3 hand(0.0031, 0.0023, radius - 1e-3);
  expectNoStepWhereWaysAreCutShort(sheet, hand, rise + lift);
}

TEST_P(BendingInMotion, NothingIsAllocatedAndNothingLockedInATick)
{
  const auto wave = [](const Vec3& v, double t_s)
  { return Vec3(v.x(), v.y(), 5e-3 * std::sin(twoPi * (v.x() / 0.08 - 2.0 * t_s))); };
  Bender sheet(sheetOf(40, 438), wave, 10);
  sheet.path_WS = tumbling;
  sheet.parameters.contact.radius_u = GetParam();
  sheet.parameters.contact.friction = { 0.3, 0.2 };
  EXPECT_EQ(disturbancesUnderAStroke(sheet), 0u);
}

INSTANTIATE_TEST_SUITE_P(PointAndBall, BendingInMotion, testing::Values(0.0, 1e-3));

} // namespace
} // namespace palpate::test
