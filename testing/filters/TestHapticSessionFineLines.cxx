// SPDX-License-Identifier: GPL-3.0-or-later
// Lines finer than a hand feels: all of their segments first, their coarsest level that nobody can tell later. Virtual
// time; every force from the formula of the line without its noise.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "haptics/core/PoseMath.h"
#include "testing/support/Random.h"
#include "testing/support/Says.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;

namespace
{
constexpr double jnd_N = stiffness * notNoticed / scale;
constexpr double noise = 0.005;
constexpr double ringRadius = 50.0;
constexpr double step = 0.2; // a tick, 0.2 m/s
constexpr int many = 300000;

Vec3 onRing(double r, double angle)
{
  return r * Vec3(std::cos(angle), std::sin(angle), 0.0);
}

/// `off`: how far a point is from the line it is drawn along.
std::vector<Vec3> makeRing(int points, double off)
{
  palpate::test::Random random(palpate::test::testSeed(671));
  std::vector<Vec3> ring_W;
  for (int i = 0; i < points; ++i)
  {
    const double angle = 2 * std::numbers::pi * i / points;
    ring_W.push_back((ringRadius + random.uniform(-off, off)) * Vec3(std::cos(angle), std::sin(angle), 0.0));
  }
  ring_W.push_back(ring_W.front());
  return ring_W;
}

/// So smooth that a hand slides along: its slopes are a fifth.
std::vector<Vec3> makeRippledRing()
{
  constexpr int ripples = 2000;
  std::vector<Vec3> ring_W;
  for (int i = 0; i < many; ++i)
  {
    const double angle = 2 * std::numbers::pi * i / many;
    ring_W.push_back((ringRadius + noise * std::sin(ripples * angle)) * Vec3(std::cos(angle), std::sin(angle), 0.0));
  }
  ring_W.push_back(ring_W.front());
  return ring_W;
}

std::vector<Vec3> makeLine(int points, double off)
{
  palpate::test::Random random(palpate::test::testSeed(672));
  std::vector<Vec3> line_W;
  for (int i = 0; i < points; ++i)
  {
    line_W.emplace_back(2 * ringRadius * i / (points - 1) - ringRadius, random.uniform(-off, off), 0.0);
  }
  return line_W;
}

class HapticSessionFineLines : public VirtualSession
{
protected:
  HapticSessionFineLines() { this->session_->SetSetting("Passivity", false); }

  void showLine(const std::vector<Vec3>& line_W)
  {
    this->session_->SetSetting(
      "LinesAsWalls", this->session_->GetSetting("LineRadius") > 0.0 ? vtkHapticSession::Off : vtkHapticSession::On);
    this->show(makePath(line_W));
  }

  void touch(const Vec3& from_W, const Vec3& press_W)
  {
    this->session_->SetHandPosition(from_W.data());
    this->startTouching();
    this->session_->Step(ticksToEngage);
    this->stepTo(press_W);
    this->session_->Step(ticksToSettle);
  }

  void stepTo(const Vec3& hand_W)
  {
    this->session_->SetHandPosition(hand_W.data());
    this->session_->Step(1);
  }

  /// From inside along the ring, 0.2 m/s; once a level of it is felt, by no other force than the circle's.
  void slide(int ticks)
  {
    const bool level = !this->sentence().starts_with("all");
    for (int tick = 0; tick < ticks; ++tick)
    {
      this->angle_ += step / ringRadius;
      this->stepTo(onRing(ringRadius + depth, this->angle_));
      if (level)
      {
        ASSERT_NEAR(this->force_N(), stiffness * depth / scale, jnd_N + stiffness * noise / scale) << "tick " << tick;
        ASSERT_LE(Vec3(this->session_->GetProxyPosition()).norm(), ringRadius + noise) << "tick " << tick;
      }
    }
  }

  /// The level takes the place of the line under the hand, which rests.
  double largestStepOfSwap_N()
  {
    EXPECT_TRUE(this->session_->FinishSimplification()) << this->sentence();
    double last_N = this->force_N(), largest_N = 0.0;
    for (int tick = 0; tick < ticksToSettle; ++tick)
    {
      this->session_->Step(1);
      largest_N = std::max(largest_N, std::abs(this->force_N() - std::exchange(last_N, this->force_N())));
    }
    return largest_N;
  }

  [[nodiscard]] double force_N() const { return this->session_->GetForceMagnitude(); }
  [[nodiscard]] std::string sentence() const { return this->session_->GetPlanText(); }

  double angle_ = 0.0; ///< of the hand on the ring
};

} // namespace

// From inside: the force is the stiffness times how far the hand is outside. A slide of 0.2 m/s over all segments needs
// more passes than a tick has; over those of the level none does, and the change of level under the pressed hand is
// below the threshold of a hand.
TEST_F(HapticSessionFineLines, ARingOf300000PointsIsFeltThroughACoarserLevelWithoutATickThatRunsOutOfPasses)
{
  this->showLine(makeRippledRing());
  EXPECT_TRUE(test::says(this->sentence(), { "300000 segments", "coarser", "meanwhile" }));
  this->touch(onRing(ringRadius - 5.0, 0.0), onRing(ringRadius + depth, 0.0));
  this->slide(100);
  EXPECT_GT(this->session_->GetCappedTicks(), 50); // it goes over 190 segments a tick, once it goes
  this->session_->Step(ticksToSettle);
  const auto capped = this->session_->GetCappedTicks();

  EXPECT_LE(this->largestStepOfSwap_N(), jnd_N);
  EXPECT_TRUE(test::says(this->sentence(), { "300000 segments", "proven", "further", "0.0" }));
  EXPECT_LE(std::stoi(this->sentence()), 300);
  EXPECT_TRUE(this->session_->GetPlaneWorld());
  EXPECT_THAT(
    this->session_->GetSceneReport(), HasSubstr("surface (walls): " + std::to_string(std::stoi(this->sentence()))));
  this->slide(5000); // three times round
  EXPECT_EQ(this->session_->GetCappedTicks(), capped);
  EXPECT_STREQ(this->session_->GetFaultText(), "");
}

// Noise of points far nearer than it is large is steep: it would hold a hand fast. Of the level only its size is felt.
TEST_F(HapticSessionFineLines, NoiseIsFeltNoMoreThanItIsLarge)
{
  this->showLine(makeRing(many, noise));
  this->touch(onRing(ringRadius - 5.0, 0.0), onRing(ringRadius + depth, 0.0));
  EXPECT_LE(this->largestStepOfSwap_N(), jnd_N);
  this->slide(2000);
  EXPECT_EQ(this->session_->GetCappedTicks(), 0);
}

TEST_F(HapticSessionFineLines, ANoisyLineIsFeltAsTheStraightLineFromBothSides)
{
  this->showLine(makeLine(many, noise));
  ASSERT_TRUE(this->session_->FinishSimplification()) << this->sentence();
  EXPECT_LE(std::stoi(this->sentence()), 2);
  for (const double side : { 1.0, -1.0 })
  {
    this->session_->TouchingOff();
    this->touch({ -40.0, 5.0 * side, 0.0 }, { -40.0, -depth * side, 0.0 });
    for (double x = -40.0; x < 40.0; x += step)
    {
      this->stepTo({ x, -depth * side, 0.0 });
      ASSERT_NEAR(this->session_->GetForce()[1], side * stiffness * depth / scale, jnd_N) << x;
      ASSERT_NEAR(this->session_->GetForce()[0], 0.0, jnd_N) << x;
    }
  }
  EXPECT_EQ(this->session_->GetCappedTicks(), 0);
}

TEST_F(HapticSessionFineLines, TubesOfAFineCurveAreFeltThroughACoarserLevelToo)
{
  constexpr double tube = 1.0;
  this->session_->SetSetting("LineRadius", tube);
  this->showLine(makeRing(30000, noise));
  ASSERT_TRUE(this->session_->FinishSimplification()) << this->sentence();
  EXPECT_THAT(this->sentence(), HasSubstr(" of 30000 segments are used (proven"));
  this->touch(onRing(ringRadius - 5.0, 0.0), onRing(ringRadius - tube + depth / 2, 0.0));
  const double ball = 1e-3 * tube; // a point is taken to be so large
  const double expected_N = stiffness * (depth / 2 + ball) / scale;
  for (int tick = 0; tick < 1000; ++tick)
  {
    this->stepTo(onRing(ringRadius - tube + depth / 2, step / ringRadius * tick));
    ASSERT_NEAR(this->force_N(), expected_N, jnd_N + stiffness * noise / scale) << "tick " << tick;
  }
  EXPECT_EQ(this->session_->GetCappedTicks(), 0);
}

TEST_F(HapticSessionFineLines, CoarseLinesStayAsTheyAreAndFineOnesDoWhereThatIsWanted)
{
  this->showLine(makeRing(1000, 0.0));
  EXPECT_TRUE(test::says(this->sentence(), { "1000 segments", "coarser", "worthwhile", "64 segments" }));
  EXPECT_FALSE(this->session_->FinishSimplification());
  this->session_->SetSetting("Simplify", vtkHapticSession::On);
  EXPECT_TRUE(this->session_->FinishSimplification());
  EXPECT_THAT(this->sentence(), HasSubstr(" of 1000 segments are used (proven"));
  this->session_->SetSetting("Simplify", vtkHapticSession::Off);
  EXPECT_FALSE(this->session_->FinishSimplification());
  EXPECT_TRUE(test::says(this->sentence(), { "1000 segments", "simpler", "surfaces" }));
  this->showLine(makeRing(many, noise));
  EXPECT_FALSE(this->session_->FinishSimplification());
  EXPECT_TRUE(test::says(this->sentence(), { "300000 segments", "simpler", "surfaces" }));
}

// The walls of a slice stand across any plane.
TEST_F(HapticSessionFineLines, InASlantedPlaneTheLevelLiesInThatPlane)
{
  const Quat turn = shortestTurn(Vec3::UnitZ(), Vec3(1, 2, 3));
  std::vector<Vec3> ring_W = makeRing(30000, noise);
  std::transform(ring_W.begin(), ring_W.end(), ring_W.begin(), [&](const Vec3& p) { return Vec3(turn * p); });
  this->showLine(ring_W);
  ASSERT_TRUE(this->session_->FinishSimplification()) << this->sentence();
  EXPECT_TRUE(this->session_->GetPlaneWorld());
  this->touch(turn * onRing(ringRadius - 5.0, 0.0), turn * onRing(ringRadius + depth, 0.0));
  for (int tick = 0; tick < 1000; ++tick)
  {
    this->stepTo(turn * onRing(ringRadius + depth, step / ringRadius * tick));
    ASSERT_NEAR(this->force_N(), stiffness * depth / scale, jnd_N + stiffness * noise / scale) << "tick " << tick;
  }
  EXPECT_EQ(this->session_->GetCappedTicks(), 0);
}

TEST_F(HapticSessionFineLines, MoreSegmentsThanCanBeFeltAreRefusedWithTheirNumberAndWhatToDo)
{
  const auto line = makePath(makeLine(4000002, 0.0));
  for (const double tube : { 0.0, 1.0 })
  {
    this->session_->SetSetting("LineRadius", tube);
    this->session_->SetSetting("LinesAsWalls", tube > 0.0 ? vtkHapticSession::Off : vtkHapticSession::On);
    const std::vector<std::string> said =
      errorsOf(this->session_, [&] { this->session_->AddSurface("line", line, nullptr); });
    ASSERT_EQ(said.size(), 1U);
    EXPECT_THAT(said[0], ::testing::AllOf(HasSubstr("line: its lines have 4000001 segments; at most 4000000"),
                           HasSubstr("Decimate Polyline")));
  }
}
