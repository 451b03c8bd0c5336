// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "devices/FedDevice.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/HapticSession.h"
#include "testing/support/Fields.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

/// A ball of 50 mm around the origin as a field, on the grid around a place of the hand.
std::shared_ptr<const Brick> brickAround(const Vec3& hand_W, std::uint64_t revision)
{
  const GridIndex size{ 24, 24, 24 };
  const double h_u = 0.004;
  const BrickGrid grid{ size, Vec3::Constant(h_u),
    { h_u * (hand_W / h_u).array().floor().matrix() - Vec3::Constant(11.5 * h_u) } };
  return std::make_shared<const Brick>(revision, grid,
    std::vector<BrickArray>{ { BrickRole::Scalar, "distance",
      test::sampledValues(size, [&](const Vec3& i) { return grid.toWorld(i).norm(); }) } });
}

/// A hand that strokes the field and a surface in it, with a new brick every 40 ticks.
void stroke(HapticSession& session, int ticks)
{
  for (int tick = 0; tick < ticks; ++tick)
  {
    const double s = 1e-3 * tick;
    const Vec3 p(0.046 * std::cos(s), 0.046 * std::sin(s), tick == 0 ? 0.03 : 0.005);
    DeviceSample sample;
    sample.pose_D.p = p;
    static_cast<FedDevice*>(session.device())->feed(sample);
    if (tick % 40 == 0)
    {
      session.setBrick(tick == 1200 ? nullptr : brickAround(p, 1 + static_cast<std::uint64_t>(tick)));
    }
    ASSERT_EQ(session.step(1), 1);
  }
}

TEST(FieldInLoop, WithASurfaceAndNewBricksUnderTheHandReplaysBitForBit)
{
  const test::TemporaryFolder folder;
  const std::string path = folder.file("recording");
  const int ticks = static_cast<int>(test::testCount(2000));
  HapticSession session;
  HapticParameters parameters;
  parameters.field.isosurface = true;
  parameters.field.isovalue = 0.05;
  parameters.field.drag_N = 0.1;
  parameters.safety.engageRamp_s = 0.05;
  ASSERT_EQ(session.setParameters(parameters), "");
  session.setScene(test::sceneOf(test::shifted(test::makeIcosphere(3, 0.05), Vec3(0.01, 0, 0))));
  SessionOptions options;
  options.virtualTime = true;
  options.recordFile = path;
  ASSERT_EQ(session.start(std::make_unique<FedDevice>(), options), "");
  stroke(session, ticks);
  EXPECT_EQ(session.stop(), "");
  const auto read = readRecording(path);
  ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  const auto& recording = std::get<Recording>(read);
  EXPECT_GT(recording.bricks.size(), static_cast<std::size_t>(ticks / 80));
  std::uint64_t held = 0;
  const ReplayResult result =
    replay(recording, {}, 1, [&held](const TickOutput& output) { held += output.state.field.force_D.norm() > 0.1; });
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_EQ(result.ticks, static_cast<std::uint64_t>(ticks));
  EXPECT_GT(held, result.ticks / 4) << "what is not felt shows nothing";
}

TEST(FieldInLoop, WithoutItsBrickARecordingSaysThatItCannotBeRecomputed)
{
  Recording recording;
  RecordedChange change;
  change.event = { 1, EventKind::Brick, 17 };
  recording.entries.emplace_back(change);
  EXPECT_NE(replay(recording).problem, "");
}

TEST(FieldInLoop, OfBricksOfTheSamePointsFeelsNoSwap)
{
  // Bricks of one grid: at the swap the force changes by no more than the hand's own step asks for.
  HapticSession session;
  HapticParameters parameters;
  parameters.field.isosurface = true;
  parameters.field.isovalue = 0.05;
  parameters.safety = SafetyLimits::none();
  ASSERT_EQ(session.setParameters(parameters), "");
  SessionOptions options;
  options.virtualTime = true;
  ASSERT_EQ(session.start(std::make_unique<FedDevice>(), options), "");
  const auto tick = [&](const Vec3& p_W)
  {
    DeviceSample sample;
    sample.pose_D.p = p_W;
    static_cast<FedDevice*>(session.device())->feed(sample);
    EXPECT_EQ(session.step(1), 1);
    return session.state().force_W;
  };
  session.setBrick(brickAround({ 0.05, 0, 0 }, 1));
  tick({ 0.055, 0, 0 });
  tick({ 0.047, 0, 0 });
  const Vec3 before = tick({ 0.047, 0, 0 });
  ASSERT_GT(before.norm(), 1.0);
  session.setBrick(brickAround({ 0.062, 0.008, -0.004 }, 2));
  EXPECT_LT((tick({ 0.047, 0, 0 }) - before).norm(), 1e-3);
}

} // namespace
} // namespace palpate
