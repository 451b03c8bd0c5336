// SPDX-License-Identifier: GPL-3.0-or-later
// A wire that is pushed round a bend, and pulled back, against one of ten times the pieces that is solved to rest.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "BentTube.h"
#include "testing/oracles/tube/RodInChannel.h"

namespace palpate::test
{
namespace
{

constexpr double pushed_mm = 150.0;

RodInChannel oracle(double friction)
{
  const BeamSection section = roundSection(0.25, 60e3, 0.3);
  RodInChannel::Form form;
  form.length_mm = length_mm;
  form.pieces = 640;
  form.stretch_N = section.stretch_N;
  form.bend_Nmm2 = section.bend_Nu2;
  form.angle_rad = bentTube().angle_rad;
  form.friction = friction;
  return RodInChannel(form);
}

/// The hand's force at each step of the way, .5 mm each; that of the wire is the mean of the ticks around.
struct Ways
{
  std::vector<double> wire_N;
  std::vector<double> truth_N;
  std::vector<bool> rests; ///< the truth
  int leftOut = 0;         ///< ticks

  [[nodiscard]] double rms() const
  {
    double off = 0.0, whole = 0.0;
    for (std::size_t i = 0; i < this->wire_N.size(); ++i)
    {
      if (!this->rests[i])
      {
        continue;
      }
      off += std::pow(this->wire_N[i] - this->truth_N[i], 2);
      whole += std::pow(this->truth_N[i], 2);
    }
    return std::sqrt(off / whole);
  }
};

Ways push(double friction)
{
  constexpr int ticks = 5;
  PushedWire wire(nitinolWire(length_mm, 64, friction), bentTube().mesh());
  RodInChannel truth = oracle(friction);
  Ways ways;
  double deepest_mm = 0.0;
  for (int i = 0; i < pushed_mm / way_mm / ticks; ++i)
  {
    double sum_N = 0.0;
    for (int k = 0; k < ticks; ++k)
    {
      const WireResult& result = wire.tick(way_mm * (ticks * i + k));
      sum_N -= result.wrench_W.force.x();
      deepest_mm = std::max(deepest_mm, result.deepest_u);
      EXPECT_EQ(result.crowded, 0);
      ways.leftOut += result.leftOut > 0 ? 1 : 0;
    }
    const double truth_N = truth.push(way_mm * ticks * (i + 0.4));
    ways.wire_N.push_back(sum_N / ticks);
    ways.truth_N.push_back(truth_N);
    ways.rests.push_back(truth.rests());
  }
  EXPECT_LE(deepest_mm, 0.03);
  EXPECT_GT(deepest_mm, 0.0);
  EXPECT_LE(ways.leftOut, pushed_mm / way_mm / 10); // in a straight part it lies on the wall everywhere
  EXPECT_GT(std::ranges::count(ways.rests, true), 0.9 * static_cast<double>(ways.rests.size()));
  return ways;
}

TEST(WireAgainstOracle, WithFrictionItsForceIsThatOfTenTimesThePiecesSolvedToRest)
{
  const double off = push(0.1).rms();
  RecordProperty("rms", std::to_string(off));
  EXPECT_LE(off, 0.07);
}

TEST(WireAgainstOracle, WithoutFrictionItsMeanForceInTheBendIsThatOfTenTimesThePieces)
{
  const Ways ways = push(0.0);
  double wire_N = 0.0, truth_N = 0.0;
  for (int i = 130; i < 190; ++i) // 65 to 95 mm: the tip is in the bend
  {
    ASSERT_TRUE(ways.rests[i]);
    wire_N += ways.wire_N[i];
    truth_N += ways.truth_N[i];
  }
  RecordProperty("rms", std::to_string(ways.rms()));
  RecordProperty("mean", std::to_string(wire_N / truth_N));
  EXPECT_NEAR(wire_N / truth_N, 1.0, 0.02);
  EXPECT_LE(ways.rms(), 0.03);
}

/// A hand that goes along the sheath, turns round, and goes back. The oracle goes by steps of five ticks, but tick by
/// tick from the turn on, where friction is turned round.
struct ThereAndBack
{
  static constexpr int ticksAStep = 5, turns = 1202, nearTurn = 10, ends = 1602;

  [[nodiscard]] static double hand_mm(int tick) { return way_mm * std::min(tick, 2 * turns - tick); }
  [[nodiscard]] static bool isTurning(int tick) { return tick >= turns && tick < turns + nearTurn; }
};

/// Beyond the bend the spring of 1 N/mm is .07 N, before and after the turn: two ticks turn the force round.
TEST(WireAgainstOracle, PushedThereAndPulledBackAgainstFrictionItsForceIsThatOfTenTimesThePieces)
{
  using Way = ThereAndBack;
  PushedWire wire(nitinolWire(length_mm, 64, 0.1), bentTube().mesh());
  RodInChannel truth = oracle(0.1);
  std::vector<double> wire_N;
  for (int i = 0; i <= Way::ends + 2; ++i)
  {
    wire_N.push_back(-wire.tick(Way::hand_mm(i)).wrench_W.force.x());
  }
  Ways ways, turning;
  for (int i = 2; i <= Way::ends; i += Way::isTurning(i) ? 1 : Way::ticksAStep)
  {
    const double mean_N = std::accumulate(wire_N.begin() + i - 2, wire_N.begin() + i + 3, 0.0) / 5.0;
    Ways& part = Way::isTurning(i) ? turning : ways;
    part.wire_N.push_back(Way::isTurning(i) ? wire_N[i] : mean_N);
    part.truth_N.push_back(truth.push(Way::hand_mm(i)));
    part.rests.push_back(truth.rests());
  }
  RecordProperty("rms", std::to_string(ways.rms()) + " " + std::to_string(turning.rms()));
  EXPECT_LE(ways.rms(), 0.07);
  EXPECT_LE(turning.rms(), 0.07);
  EXPECT_GT(turning.truth_N.front(), 0.06);
  EXPECT_LT(turning.truth_N.back(), -0.06) << "friction has turned the force round";
  EXPECT_GT(std::ranges::count(ways.rests, true), 0.9 * static_cast<double>(ways.rests.size()));
}

} // namespace
} // namespace palpate::test
