// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "devices/FedDevice.h"
#include "haptics/recording/Recording.h"
#include "haptics/recording/inputs/FieldBlocks.h"
#include "haptics/recording/writing/EndedRecording.h"
#include "haptics/session/HapticSession.h"
#include "testing/haptics/recording/FlippedBits.h"
#include "testing/support/Fields.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

/// A ball of 50 mm around the origin as a field, on the grid around a place of the hand.
std::shared_ptr<const FieldBlock> brickAround(const Vec3& hand_W, std::uint64_t revision)
{
  const GridIndex size{ 24, 24, 24 };
  const double h_u = 0.004;
  const FieldBlockGrid grid{ size, Vec3::Constant(h_u),
    { h_u * (hand_W / h_u).array().floor().matrix() - Vec3::Constant(11.5 * h_u) } };
  return std::make_shared<const FieldBlock>(revision, grid,
    std::vector<FieldBlockArray>{ { FieldBlockRole::Scalar, "distance",
      test::sampledValues(size, [&](const Vec3& i) { return grid.toWorld(i).norm(); }) } });
}

/// A hand that strokes the field and a surface in it from a tick to another, with a new block every 40 ticks.
void stroke(HapticSession& session, int ticks, int from = 0)
{
  for (int tick = from; tick < ticks; ++tick)
  {
    const double s = 1e-3 * tick;
    const Vec3 p(0.046 * std::cos(s), 0.046 * std::sin(s), tick == 0 ? 0.03 : 0.005);
    DeviceSample sample;
    sample.pose_D.p = p;
    static_cast<FedDevice*>(session.device())->feed(sample);
    if (tick % 40 == 0)
    {
      session.setFieldBlock(tick == 1200 ? nullptr : brickAround(p, 1 + static_cast<std::uint64_t>(tick)));
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

/// A session whose hand strokes a field with all springs there are, with friction at the surface.
void startOnField(HapticSession& session)
{
  HapticParameters parameters;
  parameters.field.isosurface = true;
  parameters.field.isovalue = 0.05;
  parameters.field.drag_N = 0.1;
  parameters.field.detent.strength_N = 0.2;
  parameters.field.detent.spacing = 0.002;
  parameters.field.detent.click = true;
  parameters.contact.friction = { 0.5, 0.3 };
  parameters.safety.engageRamp_s = 0.05;
  ASSERT_EQ(session.setParameters(parameters), "");
  SessionOptions options;
  options.virtualTime = true;
  ASSERT_EQ(session.start(std::make_unique<FedDevice>(), options), "");
}

TEST(FieldInLoop, EveryBitThatFlipsInARecordingOfItIsNamed)
{
  const test::TemporaryFolder folder;
  HapticSession session;
  startOnField(session);
  ASSERT_EQ(session.record(folder.file("a")), "");
  stroke(session, 60);
  EXPECT_EQ(session.stop(), "");
  test::FlippedBits(folder.file("a")).expectEachIsNamed(33, "brick");
}

// The recording begins between two blocks, or in the tick that takes one or none any more (two of three).
TEST(FieldInLoop, ARecordingBegunWhileAFieldIsFeltReplaysBitForBitAndIsNotFelt)
{
  const test::TemporaryFolder folder;
  HapticSession recorded, other;
  startOnField(recorded);
  startOnField(other);
  int felt = 0;
  for (int begin = 320; begin < 1400; begin += 110)
  {
    const std::string path = folder.file(std::to_string(begin));
    stroke(recorded, begin, begin == 320 ? 0 : begin - 10);
    stroke(other, begin, begin == 320 ? 0 : begin - 10);
    felt += recorded.state().field.force_D.norm() > 0.1;
    for (HapticSession* session : { &recorded, &other })
    {
      if (begin % 3 != 0)
      {
        session->setFieldBlock(
          begin % 3 == 1 ? nullptr : brickAround({ 0.04, 0.01, 0 }, static_cast<std::uint64_t>(begin)));
      }
    }
    ASSERT_EQ(recorded.record(path), "");
    stroke(recorded, begin + 100, begin);
    stroke(other, begin + 100, begin);
    EXPECT_EQ(recorded.state().force_D, other.state().force_D) << begin;
    EXPECT_EQ(recorded.state().field.energy.absorbed_J, other.state().field.energy.absorbed_J) << begin;
    EXPECT_EQ(recorded.state().field.beyondTicks, other.state().field.beyondTicks) << begin;
    recorded.endRecording();
    EXPECT_TRUE(recorded.takeRecorded()) << begin;
    const auto read = readRecording(path);
    ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
    const ReplayResult result = replay(std::get<Recording>(read));
    EXPECT_EQ(result.problem + result.difference, "") << begin;
    EXPECT_GE(result.ticks, 99U) << "one later where the field is replaced";
  }
  EXPECT_GT(felt, 5) << "what is not felt shows nothing";
}

TEST(FieldInLoop, CellsThatNoBrickOfARecordingHasAreForgotten)
{
  const std::shared_ptr<const FieldBlock> brick = brickAround({ 0.05, 0, 0 }, 1);
  FieldState whole;
  whole.brick = brick->contentHash();
  whole.surface.placed = true;
  whole.surface.count = 1;
  whole.surface.cells[0] = { 22, 0, 0 }; // the last cell of 24 points
  const auto keeps = [&](const std::function<void(FieldState&)>& damage)
  {
    FieldState state = whole;
    damage(state);
    keepCellsWithin({ brick }, state);
    return state.surface.placed;
  };
  EXPECT_TRUE(keeps([](FieldState&) {}));
  EXPECT_FALSE(keeps([](FieldState& s) { s.brick += 1; }));
  EXPECT_FALSE(keeps([](FieldState& s) { s.surface.cells[0][0] = 23; }));
  EXPECT_FALSE(keeps([](FieldState& s) { s.surface.cells[0][2] = -1; }));
  EXPECT_FALSE(keeps([](FieldState& s) { s.surface.count = IsoState::mostCells + 1; }));
  EXPECT_FALSE(keeps([](FieldState& s) { s.surface.count = -1; }));
  EXPECT_FALSE(keeps([](FieldState& s) { s.click.x.t.y() = NAN; }));
  EXPECT_FALSE(keeps([](FieldState& s) { s.click.device.cell[1] = std::numeric_limits<int>::min(); }));
}

TEST(FieldInLoop, WithoutItsBrickARecordingSaysThatItCannotBeRecomputed)
{
  Recording recording;
  RecordedChange change;
  change.event = { 1, EventKind::FieldBlock, 17 };
  recording.entries.emplace_back(change);
  EXPECT_NE(replay(recording).problem, "");
}

TEST(FieldInLoop, OfBricksOfTheSamePointsFeelsNoSwap)
{
  // FieldBlocks of one grid: at the swap the force changes by no more than the hand's own step asks for.
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
  session.setFieldBlock(brickAround({ 0.05, 0, 0 }, 1));
  tick({ 0.055, 0, 0 });
  tick({ 0.047, 0, 0 });
  const Vec3 before = tick({ 0.047, 0, 0 });
  ASSERT_GT(before.norm(), 1.0);
  session.setFieldBlock(brickAround({ 0.062, 0.008, -0.004 }, 2));
  EXPECT_LT((tick({ 0.047, 0, 0 }) - before).norm(), 1e-3);
}

} // namespace
} // namespace palpate
