// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh in the hand whose contacts a worker finds: in the tick, and as bytes of a recording.
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/recording/RecordedStages.h"
#include "testing/haptics/mechanism/HeldMesh.h"
#include "testing/haptics/mechanism/MechanismTicks.h"
#include "testing/haptics/mechanism/SoftPairs.h"

namespace palpate::test
{
namespace
{

constexpr int answerTicks = 33;

Pose handAt(int tick)
{
  const double t = 1e-3 * tick;
  return { middleOfPad() + Vec3(4e-3 * t, 0.0, 0.0204 - 2.5e-3 * std::min(t, 1.0)),
    Quat(Eigen::AngleAxisd(0.05 * t, Vec3::UnitX())) };
}

std::shared_ptr<const FeltMechanism> feltAgain(const FeltMechanism& felt)
{
  const RecordedMechanism read = writtenAndRead(felt);
  std::vector<std::shared_ptr<const PressedBody>> bodies;
  for (const RecordedMechanism::Body& recorded : read.bodies)
  {
    auto body = std::make_shared<PressedBody>(*recorded.body);
    body->scene = felt.bodies()[bodies.size()]->scene;
    bodies.push_back(std::move(body));
  }
  return std::make_shared<const FeltMechanism>(read.revision, read.plan, std::move(bodies), read.found);
}

void expectComputedAnew(const MechanismInputs& inputs, const std::function<Pose(int)>& handAt)
{
  std::string refusal;
  const auto bodies = MechanismBodies::make(inputs.soft, refusal);
  ASSERT_TRUE(bodies) << refusal;
  const MechanismPlan plan = planMechanism(inputs.mechanism, bodies->atRest(), 1);
  bodies->hold(inputs.mechanism, plan);
  std::vector<std::shared_ptr<const FeltMechanism>> felt;
  std::vector<TickOutput> first;
  ByteWriter half;
  MechanismTicks ticks;
  constexpr int most = 1000, halfway = 18 * answerTicks; // a tick that takes another answer
  for (int i = 0; i < most; ++i)
  {
    if (i % answerTicks == 0)
    {
      bodies->tell(ticks.state().mechanismHand);
      EXPECT_TRUE(bodies->press(1e-3 * answerTicks));
      felt.push_back(std::make_shared<const FeltMechanism>(felt.size() + 1, plan, bodies->newest(), bodies->found()));
    }
    if (i == halfway)
    {
      putState(half, ticks.state());
    }
    first.push_back(ticks.next(i, handAt(i), *felt.back()));
  }
  EXPECT_GT(first.back().state.mechanism.touching, 0);
  EXPECT_EQ(first.back().state.contacts, first.back().state.mechanism.touching);
  EXPECT_GT(first.back().command.wrench_D.force.norm(), 0.1);

  auto middle = std::make_unique<RendererState>();
  ByteReader in(half.bytes().data(), half.bytes().size());
  getState(in, *middle);
  ASSERT_TRUE(in.ok());
  MechanismTicks again, fromHalfway(std::move(middle));
  std::shared_ptr<const FeltMechanism> read;
  for (int i = 0; i < most; ++i)
  {
    if (i % answerTicks == 0)
    {
      read = feltAgain(*felt[static_cast<std::size_t>(i / answerTicks)]);
    }
    const Wrench& expected = first[static_cast<std::size_t>(i)].command.wrench_D;
    const TickOutput now = again.next(i, handAt(i), *read);
    ASSERT_EQ(now.command.wrench_D.force, expected.force) << i;
    ASSERT_EQ(now.command.wrench_D.torque, expected.torque) << i;
    if (i >= halfway)
    {
      const Wrench& other = fromHalfway.next(i, handAt(i), *read).command.wrench_D;
      ASSERT_EQ(other.force, expected.force) << i;
      ASSERT_EQ(other.torque, expected.torque) << i;
    }
  }
}

TEST(FoundInTick, WhatIsRecordedIsComputedAnewToTheLastBitFromTheBeginningAndFromHalfway)
{
  expectComputedAnew(meshOnPad(makeIcosphere(3, 0.02), 8, 0.4), handAt);
}

TEST(FoundInTick, SoIsATissueThatIsPressedOntoAnotherOne)
{
  const auto down = [](int tick) {
    return Pose{ Vec3(0.08, 0.02 + 2e-6 * tick, barSize.z() + 0.015 - 6e-6 * tick), Quat::Identity() };
  };
  expectComputedAnew(onBarAndBed(2, 0.4), down);
}

TEST(FoundInTick, ContactsThatATickCannotComputeWithAreRefusedInARecording)
{
  const MechanismInputs inputs = meshOnPad(makeIcosphere(2, 0.02), 4);
  std::string refusal;
  const auto bodies = MechanismBodies::make(inputs.soft, refusal);
  const MechanismPlan plan = planMechanism(inputs.mechanism, bodies->atRest(), 1);
  const auto refused = [&](const auto& change)
  {
    FoundContacts found;
    found.answer = 1;
    found.count = 2;
    for (FoundContact& contact : found.contacts)
    {
      contact.body = 1;
    }
    change(found);
    ByteWriter out;
    putMechanism(out, FeltMechanism(1, plan, bodies->newest(), found));
    ByteReader in(out.bytes().data(), out.bytes().size());
    (void)readMechanism(in);
    return !in.ok();
  };
  EXPECT_FALSE(refused([](FoundContacts&) {}));
  EXPECT_TRUE(refused([](FoundContacts& f) { f.count = 17; }));
  EXPECT_TRUE(refused([](FoundContacts& f) { f.count = -1; }));
  EXPECT_TRUE(refused([](FoundContacts& f) { f.contacts[1].body = 0; }));
  EXPECT_TRUE(refused([](FoundContacts& f) { f.contacts[1].body = 2; }));
  EXPECT_TRUE(refused([](FoundContacts& f) { f.contacts[1].mesh = 1; })) << "a body with itself";
  EXPECT_TRUE(refused([](FoundContacts& f) { f.contacts[1].mesh = 2; }));
  EXPECT_TRUE(refused([](FoundContacts& f) { f.contacts[1].mesh = -1; }));
  EXPECT_TRUE(refused([](FoundContacts& f) { f.reach_u = std::nan(""); }));
  EXPECT_TRUE(refused([](FoundContacts& f) { f.contacts[0].normal_B *= 2.0; }));
  EXPECT_TRUE(refused([](FoundContacts& f) { f.contacts[0].place_B.vertices[1] = 1u << 20; }));
  EXPECT_TRUE(refused([](FoundContacts& f) { f.contacts[0].friction = -1.0; }));
  EXPECT_TRUE(refused([](FoundContacts& f) { f.held_W.q.coeffs().setZero(); }));
}

} // namespace
} // namespace palpate::test
