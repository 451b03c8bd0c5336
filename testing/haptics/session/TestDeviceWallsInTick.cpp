// SPDX-License-Identifier: GPL-3.0-or-later
// A plane world on a device that holds walls: the walls that the tick sends, when, and how fast. K = 200 N/m.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/force/Viscosity.h"
#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/DeviceAdaptation.h"
#include "haptics/session/HapticSession.h"
#include "testing/haptics/session/HoldingTick.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Meshes.h"
#include "testing/support/PlainJoystick.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

using test::corridor;
using test::holding;
using test::K;
using test::sceneOf;
using test::slant;
using Tick = test::HoldingTick;

std::optional<double> offset(const DeviceCommand& command, const Vec3& normal_D)
{
  for (std::size_t i = 0; i < command.wallCount; ++i)
  {
    if (command.walls[i].normal_D == normal_D)
    {
      return command.walls[i].offset_m;
    }
  }
  return std::nullopt;
}

TEST(DeviceWallsInTick, ACorridorIsHeldByTheTwoWallsAcrossItBeforeEitherIsTouched)
{
  Tick tick{ sceneOf(corridor(0.002)) };
  const DeviceCommand command = tick.at(0.0, 0.0005).command;
  ASSERT_EQ(command.wallCount, 2);
  EXPECT_NEAR(offset(command, Vec3::UnitY()).value(), -0.002, 1e-15);
  EXPECT_NEAR(offset(command, -Vec3::UnitY()).value(), -0.002, 1e-15);
  EXPECT_EQ(command.walls[0].stiffness_N_per_m, K);
  EXPECT_EQ(command.wrench_D.force, Vec3(Vec3::Zero())) << "the device closes them: the host must not as well";
}

TEST(DeviceWallsInTick, ARoomIsHeldByItsFourWallsInAnyFrameOfTheDevice)
{
  const CurveSet room{ { { -3, -2 }, { 4, -2 }, { 4, 1 }, { -3, 1 } }, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } } };
  Tick tick{ test::sceneOf(raiseWalls(room, 1.0)) };
  tick.parameters.map.scale_u_per_m = 1000.0;
  tick.parameters.map.q_WD = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ())); // D's x is W's y
  const DeviceCommand command = tick.at(0.0, 0.0).command;
  ASSERT_EQ(command.wallCount, 4);
  EXPECT_NEAR(offset(command, Vec3::UnitX()).value(), -0.002, 1e-12);
  EXPECT_NEAR(offset(command, -Vec3::UnitX()).value(), -0.001, 1e-12);
  EXPECT_NEAR(offset(command, Vec3::UnitY()).value(), -0.004, 1e-12);
  EXPECT_NEAR(offset(command, -Vec3::UnitY()).value(), -0.003, 1e-12);
}

// Two springs to the corner at the virtual location are one spring to it.
TEST(DeviceWallsInTick, AtEverySlantTheHeldWallsGiveTheForceTheHostWouldClose)
{
  for (const double degrees : { 0.0, 10.0, 45.0, 80.0, 90.0 })
  {
    const double angle_rad = degrees * std::numbers::pi / 180;
    const Vec3 n(std::sin(angle_rad), std::cos(angle_rad), 0);
    Tick held{ sceneOf(slant(angle_rad)) }, host{ held.scene };
    held.parameters.walls.every_s = 0.0;
    host.parameters.walls.hold = false;
    for (const double depth_m : { -0.003, 0.001, 0.005 })
    {
      const TickOutput byDevice = held.at(-depth_m * n.x(), -depth_m * n.y());
      const TickOutput byHost = host.at(-depth_m * n.x(), -depth_m * n.y());
      EXPECT_LE((byDevice.state.force_D - byHost.command.wrench_D.force).norm(), 1e-12) << degrees << ' ' << depth_m;
      EXPECT_NEAR(byDevice.state.force_D.norm(), K * std::max(0.0, depth_m), 1e-12) << degrees;
      EXPECT_EQ(byHost.command.wallCount, 0);
    }
  }
}

TEST(DeviceWallsInTick, WallsChangeNoMoreOftenThanTheLinkTakesThem)
{
  Tick tick{ sceneOf(slant(std::numbers::pi / 4)) };
  tick.parameters.walls.every_s = 0.008;
  int changes = 0;
  std::optional<double> before;
  static_cast<void>(tick.at(0.01, 0.01));
  for (int i = 0; i < 400; ++i)
  {
    const double along_m = 5e-5 * i; // pressed in 3 mm, along the line
    const DeviceCommand command = tick.at(-0.01 + along_m - 0.002, 0.01 - along_m - 0.002).command;
    const std::optional<double> now = offset(command, Vec3::UnitX());
    changes += now != before;
    before = now;
  }
  EXPECT_GE(changes, 400 / 8 - 1);
  EXPECT_LE(changes, 400 / 8 + 1);
}

// A wall that moves by d into a hand adds K d to its force: at most the rise that is allowed in the time between two
// updates. The hand starts deep behind the line, so that the whole force has to be led in.
TEST(DeviceWallsInTick, NoWallStepsIntoTheHandByMoreThanTheForceMayRise)
{
  for (const double every_s : { 0.0, 0.008, 0.05 })
  {
    Tick tick{ sceneOf(slant(0.0)) };
    tick.parameters.walls.hold = false;
    static_cast<void>(tick.at(0.0, 0.01));
    tick.parameters.walls.every_s = every_s;
    tick.parameters.safety.maxRise_N_per_s = 20.0;
    const double depth_m = 0.01, period_s = std::max(every_s, 1e-3);
    double force_N = 0.0, last_N = 0.0;
    tick.parameters.walls.hold = true;
    for (int i = 0; i < 400; ++i)
    {
      force_N = tick.at(0.0, -depth_m).state.force_D.y();
      ASSERT_LE(force_N - last_N, 20.0 * period_s + 1e-12) << every_s << ' ' << i;
      last_N = force_N;
    }
    EXPECT_NEAR(force_N, K * depth_m, 1e-12) << every_s;
  }
}

// In a tick that does not know where the hand is the device is asked for nothing, and has nothing: from there on n
// ticks may add n times the rise of one. That 2 N are there in the end says that the hand was pressed all the time.
TEST(DeviceWallsInTick, AfterATickWithoutAHandTheForceRisesFromNothingNoFasterThanInAnyOtherTick)
{
  constexpr double rise_N_per_s = 20.0, depth_m = 0.01, dt_s = 1e-3;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const double every_s : { 0.0, 0.008, 0.05 })
  {
    for (const DeviceStatus status : { DeviceStatus::Ok, DeviceStatus::Waiting })
    {
      Tick tick{ sceneOf(slant(0.0)) };
      tick.parameters.walls.every_s = every_s;
      tick.parameters.safety.maxRise_N_per_s = rise_N_per_s;
      static_cast<void>(tick.at(0.0, 0.01));
      for (int n = 1; n <= 200; ++n)
      {
        static_cast<void>(tick.at(0.0, -depth_m, dt_s));
      }
      TickInput lost;
      lost.scene = tick.scene.get();
      lost.status = status;
      lost.sample.pose_D.p.x() = status == DeviceStatus::Ok ? none : 0.0;
      ASSERT_EQ(renderTick(lost, tick.parameters, tick.state).command.wallCount, 0);
      double force_N = 0.0;
      for (int n = 1; n <= 200; ++n)
      {
        force_N = tick.at(0.0, -depth_m, dt_s).state.force_D.y();
        ASSERT_LE(force_N, rise_N_per_s * n * dt_s + 1e-12) << "every " << every_s << " s, tick " << n;
      }
      EXPECT_NEAR(force_N, K * depth_m, 1e-12) << "every " << every_s << " s";
    }
  }
}

TEST(DeviceWallsInTick, WallsGoWithTheGainAndAreGoneWhenNoForceMayBeGiven)
{
  Tick tick{ sceneOf(corridor(0.002)) };
  tick.parameters.safety = SafetyLimits();
  EXPECT_EQ(tick.at(0, 0).command.wallCount, 0) << "not asked for yet";
  const HapticEvent engage{ 0, EventKind::Engage, 0 }, release{ 0, EventKind::Release, 0 };
  const auto with = [&](const HapticEvent& event)
  {
    TickInput input;
    input.scene = tick.scene.get();
    input.events = { &event, 1 };
    static_cast<void>(renderTick(input, tick.parameters, tick.state));
  };
  with(engage);
  // 3 s^2 - 2 s^3 is nowhere steeper than 1.5; sums of a thousand shares of a ramp are off by 1e-12 at most.
  const double steepest_N_per_m = 1.5 * K * (1e-3 / tick.parameters.safety.engageRamp_s + 1e-12);
  double before = 0.0;
  for (int i = 0; i < 1100; ++i)
  {
    const DeviceCommand command = tick.at(0, 0).command;
    const double stiffness = command.wallCount > 0 ? command.walls[0].stiffness_N_per_m : 0.0;
    ASSERT_GE(stiffness, before);
    ASSERT_LE(stiffness - before, steepest_N_per_m);
    before = stiffness;
  }
  EXPECT_EQ(before, K);
  with(release);
  for (int i = 0; i < 50; ++i)
  {
    static_cast<void>(tick.at(0, 0));
  }
  EXPECT_EQ(tick.at(0, 0).command.wallCount, 0);
}

/// A corridor of 4 mm that goes along y by that displacement, in that time.
std::shared_ptr<const Scene> movingCorridor(double way_m, double time_s)
{
  std::vector<Surface> surfaces = sceneOf(corridor(0.002))->surfaces();
  surfaces[0].motion.end_WS.p = Vec3(0, way_m, 0);
  return std::make_shared<const Scene>(9, surfaces, time_s);
}

// The wall below stands 0.5 mm under the hand at first, and 2.5 mm over it in the end.
TEST(DeviceWallsInTick, AWallThatMovesIsHeldWhereItIsInEachTick)
{
  constexpr double way_m = 0.003, time_s = 0.1, hand_m = -0.0015;
  Tick tick{ movingCorridor(way_m, time_s) };
  tick.parameters.walls.every_s = 0.0;
  for (int i = 1; i <= 150; ++i)
  {
    const TickOutput out = tick.at(0, hand_m);
    const double wall_m = way_m * std::min(1.0, i * 1e-3 / time_s) - 0.002;
    ASSERT_TRUE(out.state.deviceHolds);
    ASSERT_NEAR(offset(out.command, Vec3::UnitY()).value_or(1.0), wall_m, 1e-12) << i;
    ASSERT_NEAR(out.state.force_D.y(), K * std::max(0.0, wall_m - hand_m), 1e-10) << i;
  }
}

// The corridor comes along at 1 m/s; 20 N/s let a wall at 200 N/m into the hand at 0.1 m/s.
TEST(DeviceWallsInTick, NoWallThatMovesGoesIntoTheHandFasterThanTheForceMayRise)
{
  for (const double every_s : { 0.0, 0.008, 0.05 })
  {
    Tick tick{ movingCorridor(0.01, 0.01) };
    tick.parameters.walls.every_s = every_s;
    tick.parameters.safety.maxRise_N_per_s = 20.0;
    double force_N = 0.0, last_N = 0.0;
    for (int i = 0; i < 400; ++i)
    {
      force_N = tick.at(0.0, 0.0).state.force_D.y();
      ASSERT_LE(force_N - last_N, 20.0 * std::max(every_s, 1e-3) + 1e-12) << every_s << ' ' << i;
      last_N = force_N;
    }
    EXPECT_NEAR(force_N, K * 0.008, 1e-10) << every_s;
  }
}

TEST(DeviceWallsInTick, LookingForWallsAllocatesNothingWhetherTheyStandOrMove)
{
  for (const auto& scene : { sceneOf(slant(0.5)), movingCorridor(0.003, 0.05) })
  {
    Tick tick{ scene };
    tick.parameters.walls.every_s = 0.0;
    static_cast<void>(tick.at(0.01, 0.001));
    int held = 0;
    const test::AllocationGuard guard;
    for (int i = 0; i < 100; ++i)
    {
      held += tick.at(0.01 - 3e-4 * i, 0.001 - 3e-4 * i).state.walls > 0 ? 1 : 0;
    }
    EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0U);
    EXPECT_GT(held, 50);
  }
}

struct Played
{
  HapticSession session;
  SimulatedDevice* device = nullptr;
};

/// A session of that host period with a pushed or thrown handle, in virtual time.
void play(Played& played, const DeviceModel& model, const SimulationOptions& simulation, const CurveSet& curves,
  const HapticParameters& parameters, const std::string& recordFile = {})
{
  HandPath path;
  path.points_D = { Vec3::Zero() };
  auto device = std::make_unique<SimulatedDevice>(model, *handModel("none"), path, simulation);
  played.device = device.get();
  ASSERT_EQ(played.session.setParameters(parameters), "");
  played.session.setScene(sceneOf(curves));
  SessionOptions options;
  options.period_s = simulation.period_s;
  options.virtualTime = true;
  options.recordFile = recordFile;
  ASSERT_EQ(played.session.start(std::move(device), options), "");
}

// A handle that is pushed with f rests f / K behind the wall, whatever the rate of the host. Heavy, so that it is still
// in the corner when a slow host looks for the first time, and critically damped.
TEST(DeviceWallsInTick, AtTwentyToAThousandHertzAPushedHandleRestsAtForceOverStiffness)
{
  for (const double rate_Hz : { 20.0, 50.0, 125.0, 1000.0 })
  {
    SimulationOptions simulation;
    simulation.period_s = 1.0 / rate_Hz;
    simulation.push_D = { 0.3, -0.8, 0 };
    HapticParameters parameters = holding();
    parameters.limitStiffness = false;
    Played played;
    const CurveSet corner{ { { -0.04, -0.002 }, { 0.01, -0.002 }, { 0.01, 0.04 } }, { { 0, 1 }, { 1, 2 } } };
    DeviceModel heavy = test::plainJoystick(2 * std::sqrt(K));
    heavy.mass_kg = 1.0;
    play(played, heavy, simulation, corner, parameters);
    static_cast<void>(played.session.step(static_cast<int>(4 * rate_Hz)));
    EXPECT_NEAR(played.device->position_D().x(), 0.01 + 0.3 / K, 1e-7) << rate_Hz;
    EXPECT_NEAR(played.device->position_D().y(), -0.002 - 0.8 / K, 1e-7) << rate_Hz;
    EXPECT_TRUE(played.session.state().deviceHolds);
  }
}

// The device holds 100 N/m and is asked for 1000: a handle pushed with f rests f / 100 behind the wall, and the session
// reports f, not ten times as much.
TEST(DeviceWallsInTick, NoStifferWallsAreAskedForThanTheDeviceHoldsAndWhatItHoldsIsReported)
{
  constexpr double held_N_per_m = 100.0, push_N = 1.2;
  SimulationOptions simulation;
  simulation.push_D = { 0, -push_N, 0 };
  DeviceModel heavy = test::plainJoystick(2 * std::sqrt(held_N_per_m));
  heavy.mass_kg = 1.0;
  heavy.maxStiffness_N_per_m = held_N_per_m;
  HapticParameters parameters = holding();
  parameters.stiffness_N_per_m = 1000.0;
  parameters.limitStiffness = false; // the stability limit of the host's loop does not matter here
  Played played;
  play(played, heavy, simulation, corridor(0.002), parameters);
  static_cast<void>(played.session.step(4000));
  EXPECT_NEAR(played.device->position_D().y(), -0.002 - push_N / held_N_per_m, 1e-7);
  const HapticState& state = played.session.state();
  EXPECT_EQ(state.stiffness_N_per_m, held_N_per_m);
  EXPECT_TRUE(state.stiffnessLimited);
  EXPECT_NEAR((state.force_D - Vec3(0, push_N, 0)).norm(), 0.0, 1e-5);
}

TEST(DeviceWallsInTick, ADeviceIsAskedForNoMoreForceThanItsWallsHaveEvenWhereItsMotorsHaveMore)
{
  DeviceInfo info = infoOf(test::plainJoystick(0.5));
  info.heldForce_N.value = 2.0;
  HapticParameters parameters = holding();
  parameters.safety.maxForce_N = 3.0;
  EXPECT_EQ(adaptToDevice(parameters, info, {}).safety.maxForce_N, 2.0);
  parameters.walls.hold = false;
  EXPECT_EQ(adaptToDevice(parameters, info, {}).safety.maxForce_N, 3.0);
}

TEST(DeviceWallsInTick, WallsThatAreNotNumbersAreNotSentAndLatch)
{
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto spoilt = [](auto spoil)
  {
    Tick tick{ sceneOf(corridor(0.002)) };
    EXPECT_EQ(tick.at(0.0, 0.0).command.wallCount, 2);
    spoil(tick);
    return tick.at(0.0, -0.003);
  };
  const TickOutput outs[] = { spoilt([](Tick& tick) { tick.parameters.stiffness_N_per_m = none; }),
    spoilt([](Tick& tick) { tick.state.walls.walls.offset_m[1] = none; }),
    spoilt([](Tick& tick) { tick.state.walls.walls.offset_m[3] = -std::numeric_limits<double>::infinity(); }),
    spoilt([](Tick& tick) { tick.parameters.walls.viscosity_Ns_per_m = none; }) };
  for (const TickOutput& out : outs)
  {
    EXPECT_EQ(out.command.wallCount, 0);
    EXPECT_EQ(out.command.viscosity_Ns_per_m, 0.0);
    EXPECT_EQ(out.command.wrench_D.force, Vec3(Vec3::Zero()));
    EXPECT_EQ(out.state.force_D, Vec3(Vec3::Zero()));
    EXPECT_EQ(out.state.walls, 0);
    EXPECT_EQ(out.state.fault, Fault::NonFiniteSample);
  }
}

// Half width 2 mm, K 2000 N/m, 50 g, 0.05 N s/m, thrown at 0.1 m/s: without viscosity the device shakes harder and
// harder, with the session's own viscosity it is at rest within 2 s.
TEST(DeviceWallsInTick, TheViscosityFoundForADeviceStopsACorridorThatShakesWithoutIt)
{
  SimulationOptions simulation;
  simulation.period_s = 0.008;
  simulation.velocity_D = { 0, 0.1, 0 };
  HapticParameters parameters = holding();
  parameters.stiffness_N_per_m = 2000.0;
  parameters.limitStiffness = false;
  Played played;
  play(played, test::plainJoystick(0.05), simulation, corridor(0.002), parameters);
  static_cast<void>(played.session.step(250));
  double fastest_m_per_s = 0.0;
  for (int i = 0; i < 125; ++i)
  {
    static_cast<void>(played.session.step(1));
    fastest_m_per_s = std::max(fastest_m_per_s, played.device->speed_D().norm());
  }
  EXPECT_LT(fastest_m_per_s, 0.01);

  const Corridor bare{ 0.002, 2000.0, 5.0, 0.05, 0.05, 1e-3, 0.1 };
  EXPECT_GT(throwIn(bare, 0.0, 3.0).speed_m_per_s, 0.1);
}

// Without a damper the viscosity that corridors need would be dropped without a word.
TEST(DeviceWallsInTick, WallsAreLeftOnlyToADeviceThatHoldsThemAndBrakesTheHand)
{
  for (const bool holds : { false, true })
  {
    for (const bool viscous : { false, true })
    {
      DeviceInfo info = infoOf(test::plainJoystick(0.5));
      info.abilities.holdsWalls = holds;
      info.abilities.viscous = viscous;
      EXPECT_EQ(adaptToDevice(holding(), info, {}).walls.hold, holds && viscous);
    }
  }
}

/// The tick with that number among those with walls; null if there are fewer.
TickRecord* heldTick(Recording& recording, int number)
{
  int held = 0;
  for (RecordedEntry& entry : recording.entries)
  {
    if (auto* const tick = std::get_if<TickRecord>(&entry);
        tick != nullptr && tick->walls.mask != 0 && ++held == number)
    {
      return tick;
    }
  }
  return nullptr;
}

// Two walls across both axes push with largest / sqrt(2) each.
TEST(DeviceWallsInTick, ARecordingHoldsHowHardEachWallMayPush)
{
  Tick tick{ sceneOf(slant(std::numbers::pi / 4)) };
  tick.parameters.walls.every_s = 0.0;
  tick.parameters.safety.maxForce_N = 1.0;
  static_cast<void>(tick.at(0.01, 0.01));
  const TickInput input;
  const TickRecord record = makeRecord(input, tick.at(-0.001, -0.001));
  ASSERT_EQ(record.walls.mask, 0b0011);
  for (const std::size_t k : { 0, 1 })
  {
    EXPECT_NEAR(record.walls.largest_N[k], std::numbers::sqrt2 / 2, 1e-15);
    EXPECT_EQ(record.walls.largest_N[k + 2], 0.0) << "no wall";
  }
}

TEST(DeviceWallsInTick, ARecordingHoldsTheWallsAndReplaysBitForBit)
{
  const test::TemporaryFolder folder;
  const std::string file = folder.file("walls");
  SimulationOptions simulation;
  simulation.velocity_D = { 0.05, 0.1, 0 };
  HapticParameters parameters = holding();
  Played played;
  play(played, test::plainJoystick(0.5), simulation, slant(0.6), parameters, file);
  static_cast<void>(played.session.step(500));
  ASSERT_EQ(played.session.stop(), "");
  auto read = readRecording(file);
  ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  Recording& recording = std::get<Recording>(read);
  const ReplayResult same = replay(recording);
  EXPECT_EQ(same.problem + same.difference, "");
  EXPECT_EQ(same.ticks, 500U);
  TickRecord* const held = heldTick(recording, 50);
  ASSERT_NE(held, nullptr);
  const std::string differs = "tick " + std::to_string(held->tick) + ": walls differs";
  for (double* const number : { &held->walls.offset_m[0], &held->walls.largest_N[0] })
  {
    const double was = std::exchange(*number, std::nextafter(*number, 100.0));
    EXPECT_EQ(replay(recording).difference, differs);
    *number = was;
  }
  EXPECT_EQ(replay(recording).difference, "");
}

} // namespace
} // namespace palpate
