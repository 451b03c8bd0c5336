// SPDX-License-Identifier: GPL-3.0-or-later
// Row 40, chart C4: a body that is computed at a low rate, felt by its compliance, by a force that is held from one
// computation to the next, and by a spring to where the ball was at the last one.
#include <algorithm>
#include <cmath>

#include "haptics/force/LinearPlant.h"
#include "haptics/force/SampledWall.h"
#include "testing/haptics/compliance/SoftLoop.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/Felt.h"
#include "testing/lab/simulation/ExactLoops.h"
#include "testing/support/CostSample.h"
#include "testing/support/Random.h"

namespace palpate::lab
{
namespace multirate_experiment
{

constexpr double servo_s = 1e-3, mass_kg = 0.1, damping_Ns_per_m = 1.0;

enum class Feel
{
  SharedCompliance,
  HeldForce,
  LowRateCoupling,
};

constexpr const char* nameOf(Feel feel)
{
  return feel == Feel::SharedCompliance ? "ours: shared compliance"
         : feel == Feel::HeldForce      ? "held force"
                                        : "low-rate coupling";
}

struct Pad
{
  std::unique_ptr<SoftBody> body;
  SoftSurface surface;

  explicit Pad(double young_Pa)
  {
    SoftBodyInput input = test::pad(4);
    input.young_Pa = { young_Pa };
    input.element = ElementKind::Linear;
    SoftBodyResult made = makeSoftBody(input);
    this->surface = makeSoftSurface(*made.body, made.checked.mesh);
    this->body = std::move(made.body);
  }
};

/// The body's force on a hand that is `at_m` along z, from the contact that is solved in every tick.
class Felt
{
public:
  Felt(Feel feel, int period_ticks, double coupling_N_per_m)
    : feel_(feel), period_ticks_(period_ticks), coupling_N_per_m_(coupling_N_per_m)
  {
  }

  double tick(const SoftResult& now, double at_m)
  {
    if (this->ticks_++ % this->period_ticks_ == 0)
    {
      this->force_N_ = now.force_N.z();
      this->proxy_m_ = now.proxy_W.z();
    }
    switch (this->feel_)
    {
      case Feel::HeldForce:
        return this->force_N_;
      case Feel::LowRateCoupling:
        return this->force_N_ > 0.0 ? this->coupling_N_per_m_ * (this->proxy_m_ - at_m) : 0.0;
      default:
        return now.force_N.z();
    }
  }

private:
  Feel feel_;
  int period_ticks_;
  double coupling_N_per_m_;
  int ticks_ = 0;
  double force_N_ = 0.0;
  double proxy_m_ = 0.0;
};

/// How snapshots come.
struct Link
{
  int period_ticks = 40;
  int periodsLate = 1;
  double lost = 0.0;
};

/// Growth rate of the swings of a device that 1 N presses on the pad, and that was pushed at rest, as a power of e a
/// second.
double growth_per_s(Pad& pad, Feel feel, const Link& link, double coupling_N_per_m, std::uint64_t seed)
{
  test::Random random(seed);
  ContactPlan plan;
  plan.radius_u = 0.005;
  plan.coupling_N_per_m = coupling_N_per_m;
  pad.body->place(Eigen::VectorXd::Zero(pad.body->displacement().size()));
  // Forces without shared compliance are not computed from snapshots: those only say how the body lies.
  const int packets_ticks = feel == Feel::SharedCompliance ? link.period_ticks : 1000;
  test::SoftLoop loop(*pad.body, pad.surface, packets_ticks, plan, link.periodsLate);
  Felt felt(feel, link.period_ticks, coupling_N_per_m);
  const LinearPlant plant(mass_kg, damping_Ns_per_m, 0.0, servo_s);
  const double yield_m = loop.snapshot().compliance(2, 2) + 1.0 / coupling_N_per_m;
  Vec3 p = test::middleOfPad() + Vec3(0.0, 0.0, plan.radius_u - yield_m);
  Vec3 v(0.0, 0.0, 3e-3);
  (void)loop.tick(test::middleOfPad() + Vec3(0.0, 0.0, 2.0 * plan.radius_u));
  double early = 0.0, late = 0.0;
  for (int tick = 0; tick < 3500; ++tick)
  {
    const double force_N = felt.tick(loop.tick(p, random.uniform() >= link.lost), p.z());
    plant.step(p, v, Vec3(0.0, 0.0, force_N - 1.0));
    early += tick >= 500 && tick < 1500 ? v.z() * v.z() : 0.0;
    late += tick >= 2500 ? v.z() * v.z() : 0.0;
  }
  return 0.5 * std::log(late / early) / 2.0;
}

/// Coupling from which on a spring to where the ball was `ticks` ago at most lets a device grow [N/m]: the ball rests
/// between coupling and body.
double couplingLimit(int ticks, double body_m_per_N)
{
  const ExactStep step = ExactStep::of(mass_kg, damping_Ns_per_m, servo_s);
  return threshold(
    [&](double K)
    {
      const double yields = K * body_m_per_N / (1.0 + K * body_m_per_N);
      Eigen::Matrix2d loop = Eigen::Matrix2d::Identity();
      const Eigen::Matrix2d drawn = step.held * Eigen::RowVector2d(K * yields, 0.0);
      for (int i = 0; i < ticks; ++i)
      {
        loop = step.onSpring(K) * loop + drawn;
      }
      return spectralRadius(loop) > 1.0;
    },
    1e-6);
}

/// Coupling at which coupling and body in series are a wall of the limit of that period [N/m].
double seriesLimit(int ticks, double body_m_per_N)
{
  SampledWall wall;
  wall.mass_kg = mass_kg;
  wall.damping_Ns_per_m = damping_Ns_per_m;
  wall.period_s = servo_s * ticks;
  return 1.0 / (1.0 / criticalStiffness(wall) - body_m_per_N);
}

double limitOf(Feel feel, int ticks, double body_m_per_N)
{
  return feel == Feel::LowRateCoupling ? couplingLimit(ticks, body_m_per_N)
                                       : seriesLimit(feel == Feel::SharedCompliance ? 1 : ticks, body_m_per_N);
}

/// The stiffest coupling [N/m]: where growth changes its sign, between two couplings beside the exact limit.
void judgeStability(
  Pad& pad, double body_m_per_N, Feel feel, const Link& link, const Conditions& conditions, Table& table)
{
  const double limit = limitOf(feel, link.period_ticks, body_m_per_N);
  const auto at = [&](double share)
  { return growth_per_s(pad, feel, link, share * limit, conditions.seed + link.period_ticks); };
  const double below = at(0.95), above = at(1.05);
  const double found = limit * (0.95 - 0.1 * below / (above - below));
  const std::string name = caseName({ { "rate", 1000.0 / link.period_ticks },
    { "late_ms", 1.0 * link.period_ticks * link.periodsLate }, { "lost", link.lost } });
  table.within({ name, nameOf(feel), "stiffest contact", "N/m" }, found, limit, 0.01 * limit);
}

void judgeLimits(const Conditions& conditions, Table& table)
{
  Pad pad(60e3);
  const ContactPlan plan;
  const double body_m_per_N = test::SoftLoop(*pad.body, pad.surface, 100, plan).snapshot().compliance(2, 2);
  table.info({ "pad of 60 kPa", "the body alone", "stiffness", "N/m" }, 1.0 / body_m_per_N);
  for (const Link& link : { Link{ 40 }, Link{ 100 }, Link{ 100, 3 }, Link{ 100, 1, 0.5 } })
  {
    judgeStability(pad, body_m_per_N, Feel::SharedCompliance, link, conditions, table);
  }
  judgeStability(pad, body_m_per_N, Feel::HeldForce, { 10 }, conditions, table);
  for (const int ticks : { 20, 40, 100 }) // a coupling of more than 50 Hz is so stiff that 1 N keeps no contact
  {
    judgeStability(pad, body_m_per_N, Feel::HeldForce, { ticks }, conditions, table);
    judgeStability(pad, body_m_per_N, Feel::LowRateCoupling, { ticks }, conditions, table);
  }
}

constexpr double pressCoupling_N_per_m = 1000.0, pressed_Pa = 3e3, speed_m_per_s = 0.2;

/// A ball of 10 mm that is pressed 15 mm deep at .2 m/s into a pad of 3 kPa, and held there as long.
class Press
{
public:
  Press()
  {
    const test::LeastCosts cost(costRuns,
      [&](auto call)
      {
        Pad pad(pressed_Pa);
        test::SoftLoop loop = this->loopOn(pad, 1);
        this->truth_.clear();
        for (int tick = 0; tick < this->ticks(); ++tick)
        {
          call([&] { this->truth_.push_back(loop.tick(this->at(tick))); });
          loop.state.offset_W.setZero(); // a change of snapshots is felt at once
        }
      });
    this->cost_ = Cost::of(cost);
  }

  [[nodiscard]] int ticks() const { return 2 * static_cast<int>(0.0155 / speed_m_per_s / servo_s); }
  [[nodiscard]] Vec3 at(int tick) const
  {
    return { 0.052, 0.047, 0.0605 - std::min(speed_m_per_s * servo_s * tick, 0.0155) };
  }
  /// Of the whole body, solved in every tick.
  [[nodiscard]] const std::vector<SoftResult>& truth() const { return this->truth_; }
  [[nodiscard]] Cost cost() const { return this->cost_; }

  [[nodiscard]] test::SoftLoop loopOn(Pad& pad, int period_ticks) const
  {
    ContactPlan plan;
    plan.radius_u = 0.01;
    plan.coupling_N_per_m = pressCoupling_N_per_m;
    return { *pad.body, pad.surface, period_ticks, plan };
  }

private:
  std::vector<SoftResult> truth_;
  Cost cost_;
};

/// Forces of every tick along z, and the time of a tick of the servo.
struct Trace
{
  std::vector<double> force_N;
  Cost cost;
};

Trace traceOf(const Press& press, Feel feel, int period_ticks)
{
  Trace trace;
  const test::LeastCosts cost(costRuns,
    [&](auto call)
    {
      Pad pad(pressed_Pa);
      test::SoftLoop loop = press.loopOn(pad, feel == Feel::SharedCompliance ? period_ticks : 1000);
      Felt felt(feel, period_ticks, pressCoupling_N_per_m);
      trace.force_N.clear();
      for (int tick = 0; tick < press.ticks(); ++tick)
      {
        const Vec3 p_W = press.at(tick);
        SoftResult now = press.truth()[tick];
        const auto servo = [&]
        {
          now = feel == Feel::SharedCompliance ? loop.tick(p_W) : now;
          trace.force_N.push_back(felt.tick(now, p_W.z()));
        };
        tick % period_ticks == 0 ? servo() : call(servo); // then the worker's snapshot is made as well
      }
    });
  trace.cost = Cost::of(cost);
  return trace;
}

std::string pressName(int period_ticks)
{
  return caseName({ { "speed", speed_m_per_s }, { "rate", 1000.0 / period_ticks } });
}

void judgePress(const Press& press, int period_ticks, Feel feel, Table& table)
{
  const Trace trace = traceOf(press, feel, period_ticks);
  double off2 = 0.0, all2 = 0.0, worst_N = 0.0, most_N = 0.0;
  for (std::size_t tick = 0; tick < trace.force_N.size(); ++tick)
  {
    const double true_N = press.truth()[tick].force_N.z();
    const double off_N = trace.force_N[tick] - true_N;
    off2 += off_N * off_N;
    all2 += true_N * true_N;
    worst_N = std::max(worst_N, std::abs(off_N));
    most_N = std::max(most_N, true_N);
  }
  const std::string name = pressName(period_ticks);
  const Subject rms{ name, nameOf(feel), "RMS error of the force" };
  const Subject worst{ name, nameOf(feel), "error", "JND" };
  const double share = std::sqrt(off2 / all2), jnds = worst_N / (forceJnd * most_N);
  const bool ours = feel == Feel::SharedCompliance;
  constexpr double most = 0.03;
  const bool asked = period_ticks <= 40; // of shared compliance, by row 40
  ours&& asked ? table.atMost(rms, share, most) : ours ? table.info(rms, share) : table.atLeast(rms, share, most);
  (ours ? table.atMost(worst, jnds, 1.0) : table.atLeast(worst, jnds, 1.0)).cost = trace.cost;
  const Subject outcome{ name, nameOf(feel), "outcome", outcomeUnit };
  table.info(outcome, static_cast<double>(jnds > 1.0 ? Outcome::Wrong : Outcome::Held));
}

} // namespace multirate_experiment

void runMultirate(const Conditions& conditions, Table& table)
{
  using namespace multirate_experiment;
  judgeLimits(conditions, table);
  conditions.progress(0.7);
  const Press press;
  for (const int period_ticks : { 10, 20, 40, 100 })
  {
    table.info({ pressName(period_ticks), "whole body in every tick", "error", "JND" }, 0.0).cost = press.cost();
    for (const Feel feel : { Feel::SharedCompliance, Feel::HeldForce, Feel::LowRateCoupling })
    {
      judgePress(press, period_ticks, feel, table);
    }
  }
}

} // namespace palpate::lab
