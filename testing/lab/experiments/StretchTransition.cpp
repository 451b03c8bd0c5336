// SPDX-License-Identifier: GPL-3.0-or-later
// Row 76: a hand pulls a slack wire taut. In the tick it is felt where it is; as a packet it is not noticed.
#include <cmath>

#include "testing/lab/Experiments.h"
#include "testing/support/WireScenes.h"

namespace palpate::lab
{
namespace stretch_transition_experiment
{

constexpr int beams = 20;
constexpr double period_s = 1e-3, speed_mm_per_s = 100.0, hand_N_per_mm = 1.0;
constexpr double length_mm = test::PinnedColumn::length_mm;
constexpr double slack_mm = 2.0, beyond_mm = 3.0; // from where it begins to taut, and on
constexpr int ticks = static_cast<int>((slack_mm + beyond_mm) / (speed_mm_per_s * period_s));

/// A slack wire with a pinned end, whose other end a hand's spring holds.
class PulledWire
{
public:
  PulledWire() : rig_(test::straightPoints(beams, length_mm), test::PinnedColumn::section())
  {
    this->rig_.loads.held[0] = 0b001111; // the place, and the turn along it
    this->rig_.loads.spring_N_per_u[beams] = hand_N_per_mm;
    this->rig_.loads.force[beams / 2][1] = 0.05;
    this->lead(length_mm - slack_mm);
    this->rig_.settle();
    this->rig_.loads.force[beams / 2][1] = 0.0;
    this->rig_.settle();
  }

  void lead(double hand_mm)
  {
    this->hand_mm_ = hand_mm;
    this->rig_.loads.pulledTo_W[beams] = hand_mm * Vec3::UnitX();
  }
  void steps(int most)
  {
    (void)this->rig_.newton->toRest(this->rig_.wire, this->rig_.loads, most, 1e-9, this->rig_.places_W);
  }
  /// Of the hand's spring.
  [[nodiscard]] double force_N() const { return hand_N_per_mm * (this->hand_mm_ - this->rig_.tip_W().x()); }
  /// How far the end goes with the hand.
  [[nodiscard]] double follows()
  {
    (void)this->rig_.newton->linearise(this->rig_.wire, this->rig_.places_W, this->rig_.loads);
    this->rig_.newton->factor().invert();
    return hand_N_per_mm * this->rig_.newton->factor().inverse(beams)(0, 0);
  }

private:
  test::WireRig rig_;
  double hand_mm_ = 0.0;
};

double handAt(int tick)
{
  return length_mm - slack_mm + speed_mm_per_s * period_s * tick;
}

std::vector<double> inTheTick(int stepsATick)
{
  PulledWire wire;
  std::vector<double> force_N;
  for (int tick = 0; tick < ticks; ++tick)
  {
    wire.lead(handAt(tick));
    wire.steps(stepsATick);
    force_N.push_back(wire.force_N());
  }
  return force_N;
}

/// Rest and compliance of a period ago, until the next packet comes.
std::vector<double> asPackets(int ticksAPacket)
{
  PulledWire wire;
  std::vector<double> force_N;
  double at_mm = handAt(0), packet_N = wire.force_N(), follows = wire.follows();
  double nextAt_mm = at_mm, next_N = packet_N, nextFollows = follows;
  constexpr int toRest = 100;
  for (int tick = 0; tick < ticks; ++tick)
  {
    if (tick % ticksAPacket == 0)
    {
      at_mm = nextAt_mm;
      packet_N = next_N;
      follows = nextFollows;
      nextAt_mm = handAt(tick);
      wire.lead(nextAt_mm);
      wire.steps(toRest);
      next_N = wire.force_N();
      nextFollows = wire.follows();
    }
    force_N.push_back(packet_N + hand_N_per_mm * (1.0 - follows) * (handAt(tick) - at_mm));
  }
  return force_N;
}

struct Felt
{
  double off_N = 0.0;      ///< largest
  double step_N = 0.0;     ///< largest from tick to tick
  double late_share = 0.0; ///< largest error over the force, 5 ms after it is taut
};

Felt against(const std::vector<double>& truth_N, const std::vector<double>& force_N)
{
  constexpr int taut = static_cast<int>(slack_mm / (speed_mm_per_s * period_s));
  Felt felt;
  for (int tick = 1; tick < ticks; ++tick)
  {
    const double off_N = std::abs(force_N[tick] - truth_N[tick]);
    felt.off_N = std::max(felt.off_N, off_N);
    felt.step_N = std::max(felt.step_N, std::abs(force_N[tick] - force_N[tick - 1]));
    if (tick >= taut + 5)
    {
      felt.late_share = std::max(felt.late_share, off_N / truth_N[tick]);
    }
  }
  return felt;
}

} // namespace stretch_transition_experiment

void runStretchTransition(const Conditions&, Table& table)
{
  using namespace stretch_transition_experiment;
  const std::vector<double> truth_N = inTheTick(100);
  const Felt truth = against(truth_N, truth_N);
  const double series_mm_per_N = 1.0 / hand_N_per_mm + length_mm / test::PinnedColumn::section().stretch_N;
  const double last_N = (handAt(ticks - 1) - length_mm) / series_mm_per_N;
  table.within({ "taut", "at rest in each tick", "force", "N" }, truth_N.back(), last_N, 0.01 * last_N);
  const std::string taut = "through the end of slack";
  table.info({ taut, "at rest in each tick", "largest step", "N" }, truth.step_N);
  for (const int steps : { 1, 2 })
  {
    const std::string method = std::to_string(steps) + (steps == 1 ? " step a tick" : " steps a tick");
    const Felt felt = against(truth_N, inTheTick(steps));
    table.atMost({ taut, method, "off by", "N" }, felt.off_N, 0.15);
    table.atMost({ taut, method, "off 5 ms later, over the force" }, felt.late_share, 0.01);
    table.atMost({ taut, method, "largest step over the truth's" }, felt.step_N / truth.step_N, 1.01);
  }
  for (const int ticksAPacket : { 2, 10, 20 })
  {
    const std::string name = caseName({ { "rate", 1000.0 / ticksAPacket } });
    const Felt felt = against(truth_N, asPackets(ticksAPacket));
    // A packet is as old as two periods at most, in which the hand goes on with all of its spring.
    table.atLeast({ name, "packets, a period late", "off by", "N" }, felt.off_N, 0.15);
  }
}

} // namespace palpate::lab
