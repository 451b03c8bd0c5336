// SPDX-License-Identifier: GPL-3.0-or-later
// A session with a soft body: pressed, recorded, replaced, not computed any more.
#include <functional>
#include <tuple>

#include <gtest/gtest.h>

#include "SoftInLoop.h"
#include "haptics/recording/Recording.h"
#include "haptics/recording/inputs/Bodies.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/soft/BodyMaker.h"
#include "haptics/session/soft/SoftChoice.h"
#include "haptics/session/soft/SoftWorker.h"
#include "testing/haptics/recording/FlippedBits.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Eventually.h"
#include "testing/support/Meshes.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{
namespace
{

TEST(SoftBodyMaker, TellsAHandThatIsFasterThanTheBodyCouldFollowFromASlowOne)
{
  // No wave is faster than sqrt(M / rho) = 6.5 m/s, so four times the block's 50 mm take it 30 ms or more: by then a
  // hand at 5 m/s has gone 150 mm, and in the period of a millisecond that snapshots have here 5 mm, less than a patch.
  std::string refusal;
  const auto maker = BodyMaker::make(softBlock(ElasticModel::NeoHookean), "block", 0, refusal);
  ASSERT_TRUE(maker) << refusal;
  BodyHand hand;
  hand.ball_W = topOfBlock() + Vec3(0, 0, ballInLoop);
  hand.radius_u = ballInLoop;
  for (const double speed : { 1e-4, 5.0, 1e-4 })
  {
    hand.velocity_u_per_s = Vec3(0, 0, -speed);
    ASSERT_TRUE(maker->press(hand, 1e-3));
    EXPECT_EQ(maker->shape().struck, speed > 1.0) << speed;
  }
}

TEST_F(SoftInLoop, ReplaysBitForBitWithPacketsThatBendTheSurface)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("recording");
  this->begin(blockOf20kPa(), path);
  std::uint64_t presses = 0;
  double step_N = 0.0, last_N = 0.0;
  this->play(1.5,
    [&](const HapticState& state)
    {
      presses += state.soft.pressed;
      step_N = std::max(step_N, std::abs(state.force_W.norm() - last_N));
      last_N = state.force_W.norm();
      EXPECT_LE(state.soft.age_s, 0.081) << "two periods at most, and a tick";
    });
  EXPECT_GT(presses, 500u);
  EXPECT_GT(this->session.status<SoftTask>().snapshots, 30u);
  EXPECT_EQ(this->session.stop(), "");
  const auto read = readRecording(path);
  ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  const auto& recording = std::get<Recording>(read);
  EXPECT_GT(recording.bodies.size(), 30u);
  const ReplayResult result = replay(recording);
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_EQ(result.ticks, 1500u);
  EXPECT_LE(step_N, 0.12);
}

TEST_F(SoftInLoop, ReplaysBitForBitWhereTheBallComesDownToWhatIsHeld)
{
  for (const ElasticModel model : { ElasticModel::Linear, ElasticModel::NeoHookean })
  {
    const TemporaryFolder folder;
    const std::string path = folder.file("recording");
    SoftBodyInput input = softBlock(model);
    input.young_Pa = { 10.0 };
    this->begin({ std::make_shared<const SoftBodyInput>(input), "block", 25.0 }, path);
    double most_N = 0.0;
    for (int i = 0; i <= 100; ++i)
    {
      most_N = std::max(most_N, this->hold(Vec3(1e-4 * i, 0, 0.001 - 6e-4 * i)).force_W.z());
    }
    EXPECT_GT(most_N, 0.9 * springInLoop * 0.009) << "the held side is 50 mm below the top";
    EXPECT_EQ(this->session.stop(), "");
    const auto read = readRecording(path);
    ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
    const ReplayResult result = replay(std::get<Recording>(read));
    EXPECT_EQ(result.problem + result.difference, "");
    EXPECT_EQ(result.ticks, 101u);
  }
}

TEST_F(SoftInLoop, EveryBitThatFlipsInARecordingOfItIsNamed)
{
  const TemporaryFolder folder;
  this->begin(blockOf20kPa(), folder.file("a"));
  this->hold(Vec3(0, 0, 0.001), 30);
  this->hold(Vec3(0.001, 0, -0.002), 60);
  EXPECT_EQ(this->session.stop(), "");
  FlippedBits(folder.file("a")).expectEachIsNamed(31, "body");
}

TEST_F(SoftInLoop, OfARecordingBegunWhileItPressesReplaysBitForBit)
{
  const TemporaryFolder folder;
  this->begin(blockOf20kPa());
  this->play(0.25, [](const HapticState&) {});
  ASSERT_EQ(this->session.record(folder.file("a")), "");
  this->play(0.3, [](const HapticState&) {});
  EXPECT_EQ(this->session.stop(), "");
  const auto read = readRecording(folder.file("a"));
  ASSERT_TRUE(std::holds_alternative<Recording>(read));
  const ReplayResult result = replay(std::get<Recording>(read));
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_EQ(result.ticks, 300u);
}

TEST_F(SoftInLoop, ATicksForceIsThatOfTheBallItShowsBesideWhatTheEnergyBalanceAdds)
{
  this->begin(blockOf20kPa());
  int pressed = 0;
  this->play(1.0,
    [&](const HapticState& state)
    {
      const Vec3 spring_N = springInLoop * (state.proxy_W.p - state.device_W.p);
      pressed += state.soft.pressed;
      EXPECT_LE((state.force_W - spring_N).norm(), std::abs(state.soft.added_N) + 1e-12 * spring_N.norm() + 1e-12);
    });
  EXPECT_GT(pressed, 300);
}

TEST_F(SoftInLoop, WithoutItsPacketsSaysThatItCannotBeRecomputed)
{
  Recording recording;
  RecordedChange change;
  change.event = { 1, EventKind::Body, 17 };
  recording.entries.emplace_back(change);
  EXPECT_NE(replay(recording).problem, "");
}

TEST_F(SoftInLoop, AHandGetsBackNoMoreThanItGave)
{
  this->begin(blockOf20kPa());
  double given_J = 0.0, most_J = 0.0;
  Vec3 before = Vec3::Zero(), force = Vec3::Zero();
  bool first = true;
  this->play(2.6,
    [&](const HapticState& state)
    {
      given_J += first ? 0.0 : -force.dot(state.device_W.p - before);
      before = state.device_W.p;
      force = state.force_W;
      first = false;
      most_J = std::max(most_J, state.soft.stored_J);
    });
  ASSERT_EQ(this->hold(Vec3(0, 0, 0.02), 5).force_W, Vec3(0, 0, 0));
  EXPECT_GT(most_J, 1e-3);
  EXPECT_GE(given_J, -0.02 * most_J);
}

TEST_F(SoftInLoop, ABodyThatIsTakenAwayWhilePressedLetsTheHandGoWithoutAStep)
{
  this->begin(blockOf20kPa(ElasticModel::Linear));
  const double force_N = this->hold(Vec3(0, 0, -0.006), 400).force_W.norm();
  EXPECT_GT(force_N, 0.5);
  this->session.choose<SoftTask>({});
  double last_N = force_N;
  for (int i = 0; i < 400; ++i)
  {
    const double now_N = this->hold(Vec3(0, 0, -0.006)).force_W.norm();
    EXPECT_LE(std::abs(now_N - last_N), 0.05 * force_N) << i;
    last_N = now_N;
  }
  EXPECT_LE(last_N, 0.01 * force_N);
}

TEST_F(SoftInLoop, ACoarserBodyInItsPlaceIsNotPressedAtTheVerticesOfTheOld)
{
  this->begin(blockOf20kPa());
  ASSERT_TRUE(this->hold(Vec3(0, 0, -0.004), 400).soft.pressed);
  this->session.choose<SoftTask>({ std::make_shared<const SoftBodyInput>(pad(2)), "coarse", 25.0 });
  const HapticState& state = this->hold(Vec3(0, 0, -0.004), 400);
  EXPECT_TRUE(state.soft.pressed);
  EXPECT_GT(state.force_W.z(), 0.0);
  EXPECT_LT(state.force_W.norm(), springInLoop * 0.004);
}

TEST_F(SoftInLoop, ABodyThatBeginsToGiveWayUnderAPressedHandDoesSoWithoutAStep)
{
  // Rigid, the body's own surface is pressed by K d; its surface is the same once it is soft.
  const SoftBodyResult made = makeSoftBody(softBlock(ElasticModel::Linear));
  const SoftSurface surface = makeSoftSurface(*made.body, made.checked.mesh);
  SurfaceInput input;
  input.name = "block";
  input.mesh = std::make_shared<TriangleMesh>(TriangleMesh{ surface.rest_W, surface.triangles });
  this->session.setScene(SceneBuilder().build({ input }).scene);
  this->begin({});
  const double rigid_N = this->hold(Vec3(0, 0, -0.004), 400).force_W.norm();
  ASSERT_NEAR(rigid_N, springInLoop * 0.004, 1e-9);
  this->session.choose<SoftTask>(blockOf20kPa(ElasticModel::Linear));
  double last_N = rigid_N;
  for (int i = 0; i < 400; ++i)
  {
    const double now_N = this->hold(Vec3(0, 0, -0.004)).force_W.norm();
    EXPECT_LE(std::abs(now_N - last_N), 0.12) << i;
    last_N = now_N;
  }
  EXPECT_LT(last_N, 0.8 * rigid_N);
}

TEST_F(SoftInLoop, ABodyThatIsComputedLessOftenIsNotMadeAnew)
{
  SoftChoice choice = blockOf20kPa();
  this->begin(choice);
  double last_N = this->hold(Vec3(0, 0, -0.004), 400).force_W.norm();
  const std::uint64_t before = this->session.status<SoftTask>().snapshots;
  choice.rate_Hz = 10.0;
  this->session.choose<SoftTask>(choice);
  for (int i = 0; i < 400; ++i)
  {
    const double now_N = this->hold(Vec3(0, 0, -0.004)).force_W.norm();
    EXPECT_LE(std::abs(now_N - last_N), 0.01) << i;
    last_N = now_N;
  }
  EXPECT_GT(this->session.status<SoftTask>().snapshots, before);
}

TEST_F(SoftInLoop, AHandAtRestFeelsWhatTheBodyPushesAndNothingForItsEnergy)
{
  this->begin(blockOf20kPa());
  const double balanced_N = this->hold(Vec3(0, 0, -0.004), 800).force_W.norm();
  HapticParameters parameters = this->session.parameters();
  parameters.softBalances = false;
  ASSERT_EQ(this->session.setParameters(parameters), "");
  const double pushed_N = this->hold(Vec3(0, 0, -0.004), 200).force_W.norm();
  EXPECT_NEAR(balanced_N, pushed_N, 1e-3 * pushed_N);
}

TEST_F(SoftInLoop, AnotherBodyInItsPlaceIsPressedFromTheSameSide)
{
  this->begin(blockOf20kPa(ElasticModel::Linear));
  const double soft_N = this->hold(Vec3(0, 0, -0.006), 400).force_W.z();
  SoftBodyInput stiffer = softBlock(ElasticModel::Linear);
  stiffer.young_Pa = { 40e3 };
  this->session.choose<SoftTask>({ std::make_shared<const SoftBodyInput>(stiffer), "block", 25.0 });
  const HapticState& state = this->hold(Vec3(0, 0, -0.006), 400);
  EXPECT_GT(state.force_W.z(), 1.2 * soft_N);
  EXPECT_LT(state.force_W.head<2>().norm(), 0.01 * soft_N);
}

TEST_F(SoftInLoop, ItsThreadMakesPacketsThatBendWithTheHand)
{
  this->begin(blockOf20kPa(), {}, false);
  EXPECT_TRUE(eventually([&] { return this->session.status<SoftTask>().snapshots > 2; }));
  EXPECT_EQ(this->session.status<SoftTask>().problem, "");
  feed(*static_cast<FedDevice*>(this->session.device()), Vec3(0, 0, -0.004));
  EXPECT_TRUE(eventually([&] { return this->session.state().soft.pressed; }));
  EXPECT_TRUE(eventually([&] { return this->session.status<SoftTask>().shape->mostGradient > 1e-3; }));
}

TEST_F(SoftInLoop, WhatIsNoBodyIsSaid)
{
  SoftBodyInput floating = softBlock(ElasticModel::Linear);
  floating.fixed.assign(floating.fixed.size(), false);
  this->begin({ std::make_shared<const SoftBodyInput>(floating), "block", 25.0 });
  this->hold(Vec3(0, 0, -0.004), 5);
  EXPECT_NE(this->session.status<SoftTask>().problem, "");
  EXPECT_FALSE(this->session.state().soft.felt);
}

/// One tick after the other on a block whose worker made two snapshots and then no more.
TEST(SoftTick, AWorkerThatDoesNotComeBackForASecondEndsTheForceAndIsSaid)
{
  std::string refusal;
  const auto maker = BodyMaker::make(softBlock(ElasticModel::Linear), "block", 0, refusal);
  BodyHand hand;
  hand.ball_W = topOfBlock();
  const auto body = maker->press(hand, 0.04);
  const auto room = std::make_unique<SoftScratch>();
  HapticParameters parameters;
  parameters.stiffness_N_per_m = springInLoop;
  parameters.safety = SafetyLimits::none();
  RendererState state;
  TickInput input;
  input.scene = body->scene.get();
  input.body = body.get();
  input.softScratch = room.get();
  double last_N = 0.0, pushed_N = 0.0;
  Fault fault = Fault::None;
  int faultAt = 0;
  for (int i = 0; i < 1500; ++i)
  {
    input.tick = static_cast<std::uint64_t>(i);
    input.sample.pose_D.p = topOfBlock() + Vec3(0, 0, i == 0 ? 0.001 : -0.004);
    const AllocationGuard guard;
    const TickOutput output = renderTick(input, parameters, state);
    EXPECT_EQ(guard.allocations(), 0u);
    last_N = output.command.wrench_D.force.norm();
    pushed_N = std::max(pushed_N, last_N);
    faultAt = fault == Fault::None && output.state.fault != Fault::None ? i : faultAt;
    fault = output.state.fault;
  }
  EXPECT_GT(pushed_N, 0.5);
  EXPECT_EQ(fault, Fault::BodyLate);
  EXPECT_NEAR(faultAt, 1000, 2);
  EXPECT_EQ(last_N, 0.0);
}

TEST(RecordedBodies, ComeBackToTheLastBitAndAreRefusedWhereTheyCannotBe)
{
  std::string refusal;
  const auto maker = BodyMaker::make(softBlock(ElasticModel::Linear), "block", 0, refusal);
  BodyHand hand;
  hand.ball_W = topOfBlock();
  hand.radius_u = ballInLoop;
  const auto body = maker->press(hand, 0.04);
  const auto bytesOf = [](const PressedBody& of)
  {
    ByteWriter out;
    putBody(out, of);
    return out.bytes();
  };
  const std::vector<char> bytes = bytesOf(*body);
  ByteReader in(bytes.data(), bytes.size());
  const auto read = readBody(in);
  ASSERT_TRUE(read);
  EXPECT_EQ(in.left(), 0u);
  EXPECT_EQ(bytesOf(*read), bytes);
  EXPECT_EQ(read->snapshot->compliance, body->snapshot->compliance);
  const auto refused = [&](const auto& change)
  {
    ComplianceSnapshot snapshot = *body->snapshot;
    change(snapshot);
    PressedBody other = *body;
    other.snapshot = std::make_shared<const ComplianceSnapshot>(snapshot);
    const std::vector<char> wrong = bytesOf(other);
    ByteReader again(wrong.data(), wrong.size());
    return readBody(again) == nullptr;
  };
  EXPECT_FALSE(refused([](ComplianceSnapshot&) {}));
  EXPECT_TRUE(refused([](ComplianceSnapshot& p) { p.placeOf[3] = 4000; }));
  EXPECT_TRUE(refused([](ComplianceSnapshot& p) { p.near[0] = 1u << 31; }));
  EXPECT_TRUE(refused([](ComplianceSnapshot& p) { p.compliance(1, 1) = std::nan(""); }));
  EXPECT_TRUE(refused([](ComplianceSnapshot& p) { p.patchRadius_u[0] = 0.0; }));
  EXPECT_TRUE(refused([](ComplianceSnapshot& p) { p.springs[0].patch = -1.0; }));
  for (std::size_t size = 0; size < bytes.size(); size += 97)
  {
    ByteReader cut(bytes.data(), size);
    EXPECT_EQ(readBody(cut), nullptr) << size;
  }
}

TEST(RecordedBodies, TheirHeldFacesComeBackToTheLastBitAndAreRefusedWhereTheyCannotBe)
{
  std::string refusal;
  const auto maker = BodyMaker::make(softBlock(ElasticModel::Linear), "block", 0, refusal);
  const PressedBody body = *maker->press({}, 0.04);
  ASSERT_TRUE(body.heldFaces && body.held);
  EXPECT_EQ(body.heldFaces->triangles.size(), 32u) << "of the lower side";
  ByteWriter out;
  putHeld(out, body);
  const std::vector<char> bytes = out.bytes();
  const auto readBack = [&body](const std::vector<char>& from, std::size_t size)
  {
    PressedBody read = body;
    read.heldFaces.reset();
    ByteReader in(from.data(), size);
    readHeld(in, read);
    return in.ok() ? read.heldFaces : nullptr;
  };
  const auto read = readBack(bytes, bytes.size());
  ASSERT_TRUE(read);
  EXPECT_EQ(sceneOfHeld(*read)->geometryHash(), body.held->geometryHash());
  std::vector<char> wrong = bytes;
  wrong.back() = 1; // of an index, its last byte
  EXPECT_EQ(readBack(wrong, wrong.size()), nullptr);
  for (std::size_t size = 0; size < bytes.size(); size += 41)
  {
    EXPECT_EQ(readBack(bytes, size), nullptr) << size;
  }
}

TEST(RecordedBodies, TheKnotsOfTheirSpringsComeBackToTheLastBitAndAreRefusedWhereTheyCannotBe)
{
  std::string refusal;
  const auto maker = BodyMaker::make(softBlock(ElasticModel::Linear), "block", 0, refusal);
  BodyHand hand;
  hand.ball_W = topOfBlock();
  hand.radius_u = ballInLoop;
  const auto body = maker->press(hand, 0.04);
  const auto readAs = [&body](const std::function<void(SubgridSpring&)>& change, PressedBody& read)
  {
    ComplianceSnapshot snapshot = *body->snapshot;
    change(snapshot.springs[1]);
    PressedBody written = *body;
    written.snapshot = std::make_shared<const ComplianceSnapshot>(snapshot);
    ByteWriter out;
    putKnots(out, written);
    std::ranges::for_each(snapshot.springs, [](SubgridSpring& s) { s = { s.hertz, s.patch }; });
    read = *body;
    read.snapshot = std::make_shared<const ComplianceSnapshot>(snapshot); // as a version without knots leaves it
    ByteReader in(out.bytes().data(), out.bytes().size());
    readKnots(in, read);
    return in.ok() && in.left() == 0;
  };
  PressedBody read;
  ASSERT_TRUE(readAs([](SubgridSpring&) {}, read));
  for (std::size_t i = 0; i < body->snapshot->springs.size(); ++i)
  {
    const SubgridSpring& a = body->snapshot->springs[i];
    const SubgridSpring& b = read.snapshot->springs[i];
    EXPECT_GT(a.step, 0.0);
    EXPECT_EQ(std::tie(a.step, a.across, a.depth_u, a.rise), std::tie(b.step, b.across, b.depth_u, b.rise));
  }
  EXPECT_EQ(read.touch.snapshot, read.snapshot.get());
  EXPECT_FALSE(readAs([](SubgridSpring& s) { s.depth_u[3] = -1.0; }, read));
  EXPECT_FALSE(readAs([](SubgridSpring& s) { s.rise[3] = std::nan(""); }, read));
  EXPECT_FALSE(readAs([](SubgridSpring& s) { s.across = -1.0; }, read));
}

} // namespace
} // namespace palpate::test
