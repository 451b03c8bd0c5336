// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 46 and 47: walls that a joystick holds by itself. K = 200 N/m unless said.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/force/DeviceWalls.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

constexpr double K = 200.0;

Vec3 unit(double angle_rad)
{
  return { std::cos(angle_rad), std::sin(angle_rad), 0 };
}

/// Force of springs at these walls on a handle, written down from their definition.
Vec3 springs(const AxisWalls& walls, const Vec3& p_D)
{
  Vec3 force = Vec3::Zero();
  for (int i = 0; i < AxisWalls::count; ++i)
  {
    if (const auto& offset_m = walls.offset_m[static_cast<std::size_t>(i)])
    {
      force += K * std::max(0.0, *offset_m - AxisWalls::direction(i).dot(p_D)) * AxisWalls::direction(i);
    }
  }
  return force;
}

TEST(DeviceWalls, ATouchedWallOfAnySlantGivesTheForceOfASpringToTheVirtualLocation)
{
  test::Random random(test::testSeed(631));
  for (std::size_t i = 0; i < test::testCount(1000); ++i)
  {
    const Vec3 n = unit(random.uniform(-std::numbers::pi, std::numbers::pi)), x_D = 0.05 * unit(random.uniform(0, 6));
    const double depth_m = random.uniform(0.0, 0.02);
    const NearWall touched{ n, 0.0 };
    const Vec3 force = springs(wallsAround(x_D, { &touched, 1 }, 0.0), x_D - depth_m * n);
    ASSERT_LE((force - K * depth_m * n).norm(), 1e-12) << "case " << i;
  }
}

TEST(DeviceWalls, AnInsideCornerHasAWallForEveryWayThatIsClosed)
{
  const Vec3 x_D(0.01, -0.02, 0);
  // A corridor's end, open to the left: lines above, below and to the right.
  const NearWall end[] = { { { 0, -1, 0 }, 0.0 }, { { 0, 1, 0 }, 0.004 }, { { -1, 0, 0 }, 0.001 } };
  const AxisWalls walls = wallsAround(x_D, end);
  EXPECT_FALSE(walls.offset_m[0].has_value());
  EXPECT_DOUBLE_EQ(walls.offset_m[1].value(), -0.02 - 0.004);
  EXPECT_DOUBLE_EQ(walls.offset_m[2].value(), -0.01 - 0.001);
  EXPECT_DOUBLE_EQ(walls.offset_m[3].value(), 0.02);
  // The tip of a wedge of 60 degrees that opens to the right: three walls, two of them against each other.
  const double half = std::numbers::pi / 6;
  const NearWall wedge[] = { { unit(std::numbers::pi / 2 - half), 0.0 }, { unit(half - std::numbers::pi / 2), 0.0 } };
  const AxisWalls tip = wallsAround(x_D, wedge);
  EXPECT_TRUE(tip.offset_m[0] && tip.offset_m[1] && tip.offset_m[3] && !tip.offset_m[2]);
}

TEST(DeviceWalls, ASlantedWallAheadIsMetAlongTheAxesWhereItsLineIs)
{
  const double angle = 0.4, gap_m = 0.003;
  const Vec3 n = unit(angle), x_D(0.002, 0.001, 0);
  const NearWall ahead{ n, gap_m };
  const AxisWalls walls = wallsAround(x_D, { &ahead, 1 });
  // The points of the line n . p = n . x - gap on the axes through x.
  EXPECT_NEAR(walls.offset_m[0].value(), x_D.x() - gap_m / std::cos(angle), 1e-15);
  EXPECT_NEAR(walls.offset_m[1].value(), x_D.y() - gap_m / std::sin(angle), 1e-15);
}

TEST(DeviceWalls, AWallAlongAnAxisIsOneWallInSpiteOfRounding)
{
  const NearWall almost{ unit(1e-9), 0.0 };
  const AxisWalls walls = wallsAround(Vec3::Zero(), { &almost, 1 });
  EXPECT_TRUE(walls.offset_m[0] && !walls.offset_m[1] && !walls.offset_m[2] && !walls.offset_m[3]);
}

TEST(DeviceWalls, NeverEnterTheHandFasterThanTheLimitAndLeaveItAtOnce)
{
  const Vec3 handle_D(0, 0, 0);
  const double most_m = 0.001;
  AxisWalls wanted, held;
  wanted.offset_m[0] = 0.0045; // the handle is 4.5 mm behind a wall that appears
  for (const double expected_m : { 0.001, 0.002, 0.003, 0.004, 0.0045, 0.0045 })
  {
    const double before_m = std::max(0.0, held.offset_m[0].value_or(0.0));
    held = ledTo(held, wanted, handle_D, most_m);
    ASSERT_NEAR(held.offset_m[0].value(), expected_m, 1e-15);
    // Energy of the spring, before and after: no more than K d (p + d / 2).
    const double given_J = K / 2 * (expected_m * expected_m - before_m * before_m);
    ASSERT_LE(given_J, K * most_m * (before_m + most_m / 2) + 1e-15);
  }
  wanted.offset_m[0] = -0.02;
  EXPECT_EQ(ledTo(held, wanted, handle_D, most_m).offset_m[0], -0.02);
  EXPECT_EQ(ledTo(AxisWalls{}, wanted, handle_D, most_m).offset_m[0], -0.02); // not in the hand: where it should be
  EXPECT_FALSE(ledTo(held, AxisWalls{}, handle_D, most_m).offset_m[0].has_value());
}

// Two springs across each other give at most sqrt(F_x^2 + F_y^2); with F / sqrt(2) each that is F, and a corner deep
// enough reaches it. Of two opposite walls with space between them no more than one pushes, and with all of F.
TEST(DeviceWalls, TogetherPushNoHarderThanTheLimitHoweverDeepTheHandleIs)
{
  constexpr double largest_N = 3.0;
  test::Random random(test::testSeed(632));
  for (std::size_t k = 0; k < test::testCount(1000); ++k)
  {
    AxisWalls walls;
    for (int i = 0; i < AxisWalls::count; ++i)
    {
      if (random.uniform() < 0.6)
      {
        walls.offset_m[static_cast<std::size_t>(i)] = random.uniform(-0.03, 0.0);
      }
    }
    DeviceCommand sent;
    command(walls, K, sent, largest_N);
    ASSERT_LE(
      forceOfWalls(sent, { random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0 }).norm(), 3.0 * (1 + 1e-15));
  }
  constexpr double deep_m = 2 * largest_N / K;
  DeviceCommand sent;
  AxisWalls corner;
  corner.offset_m[0] = corner.offset_m[1] = 0.0;
  command(corner, K, sent, largest_N);
  EXPECT_NEAR(forceOfWalls(sent, { -deep_m, -deep_m, 0 }).norm(), largest_N, 1e-12);
  AxisWalls corridor;
  corridor.offset_m[0] = corridor.offset_m[2] = -0.01;
  command(corridor, K, sent, largest_N);
  EXPECT_NEAR(forceOfWalls(sent, { -0.01 - deep_m, 0, 0 }).x(), largest_N, 1e-12);
}

TEST(DeviceWalls, AreSentAgainWhenTheyMovedByAStepOfTheDeviceOrAnotherSetHolds)
{
  AxisWalls sent, now;
  sent.offset_m[1] = now.offset_m[1] = 0.01;
  EXPECT_FALSE(differ(sent, now, 1e-4));
  EXPECT_FALSE(differ(sent, now, 0.0));
  now.offset_m[1] = 0.01 + 0.9e-4;
  EXPECT_FALSE(differ(sent, now, 1e-4));
  now.offset_m[1] = 0.01 - 1.1e-4;
  EXPECT_TRUE(differ(sent, now, 1e-4));
  now = sent;
  now.offset_m[3] = -0.02;
  EXPECT_TRUE(differ(sent, now, 1e-4));
  EXPECT_TRUE(differ(now, sent, 1e-4));
}

/// The drag of the walls themselves while the handle slides, over one update of the host, period by period.
Velvet dragOf(const Slide& slide, double wallAngle_rad, double way)
{
  const Vec3 n = unit(wallAngle_rad), along = way * unit(wallAngle_rad + std::numbers::pi / 2);
  const NearWall touched{ n, 0.0 };
  const AxisWalls walls = wallsAround(Vec3::Zero(), { &touched, 1 });
  const int periods = static_cast<int>(std::lround(slide.host_s / slide.device_s));
  Velvet drag;
  for (int k = 0; k < periods; ++k)
  {
    const Vec3 p_D = -slide.depth_m * n + k * slide.device_s * slide.speed_m_per_s * along;
    const double drag_N = -along.dot(springs(walls, p_D));
    drag.mean_N += drag_N / periods;
    drag.peak_N = std::max(drag.peak_N, drag_N);
  }
  return drag;
}

TEST(DeviceWalls, TheVelvetOfASlantIsWhatTheTwoSpringsDoAtEverySlantDepthSpeedAndRate)
{
  test::Random random(test::testSeed(632));
  for (std::size_t i = 0; i < test::testCount(1000); ++i)
  {
    const double angle = random.uniform(0.1, std::numbers::pi / 2 - 0.1), way = i % 2 == 0 ? 1.0 : -1.0;
    Slide slide{ K, random.uniform(0.0, 0.3), random.uniform(0.0, 0.02), 1e-3 * (1 + random.below(60)), 1e-3, 0.0 };
    // Along unit(angle + 90 degrees) the x wall is entered, the other way the y wall.
    slide.lean = way > 0 ? std::sin(angle) : std::cos(angle);
    const Velvet drag = dragOf(slide, angle, way), formula = velvet(slide);
    ASSERT_NEAR(formula.mean_N, drag.mean_N, 1e-9) << "case " << i;
    ASSERT_NEAR(formula.peak_N, drag.peak_N, 1e-9) << "case " << i;
  }
}

// While both walls press: K v (T_host - T) / 2 in the mean, twice that at the peak.
TEST(DeviceWalls, TheVelvetOfADeepSlideIsASawToothThatOnlyTheRateOfTheHostDecides)
{
  for (const double host_s : { 0.05, 0.02, 0.008, 0.001 })
  {
    for (const double lean : { 0.3, std::sqrt(0.5), 0.9 })
    {
      const Velvet drag = velvet({ K, 0.05, 0.02, host_s, 1e-3, lean });
      EXPECT_NEAR(drag.mean_N, K * 0.05 * (host_s - 1e-3) / 2, 1e-12);
      EXPECT_NEAR(drag.peak_N, K * 0.05 * (host_s - 1e-3), 1e-12);
    }
  }
}

// At rest the push is balanced by the springs, friction and one step of the encoder.
TEST(DeviceWalls, AJoystickHoldsTheCornerByItselfBehindAHostOfTwentyHertz)
{
  const DeviceModel& model = *deviceModel("simulated-joystick");
  const Vec3 push_N(-1.0, 2.0, 0.0);
  SimulationOptions options;
  options.period_s = 0.05;
  options.push_D = push_N;
  SimulatedDevice joystick(model, *handModel("none"), { { Vec3::Zero() } }, options);
  ASSERT_EQ(joystick.open(), "");
  const NearWall corner[] = { { { 1, 0, 0 }, 0.002 }, { { 0, -1, 0 }, 0.003 } };
  DeviceCommand held;
  command(wallsAround(Vec3::Zero(), corner), K, held);
  ASSERT_EQ(held.wallCount, 2);
  joystick.write(held);
  DeviceSample sample;
  ASSERT_EQ(joystick.read(5.0, sample), DeviceStatus::Ok);
  const double tolerance_m = model.friction_N / K + model.encoderStep_m;
  EXPECT_NEAR(joystick.position_D().x(), -0.002 + push_N.x() / K, tolerance_m);
  EXPECT_NEAR(joystick.position_D().y(), 0.003 + push_N.y() / K, tolerance_m);
  EXPECT_LE(joystick.speed_D().norm(), 1e-9);
}

} // namespace
} // namespace palpate
