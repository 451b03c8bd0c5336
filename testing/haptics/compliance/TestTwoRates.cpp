// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "SoftLoop.h"
#include "SoftPads.h"
#include "haptics/compliance/servo/SoftEnergy.h"
#include "haptics/force/LinearPlant.h"
#include "haptics/force/SampledWall.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

constexpr double servo_s = 1e-3;

SoftPad stiffPad(double young_Pa)
{
  return SoftPad(4, 2.0, ElementKind::EdgeSmoothed,
    [young_Pa](SoftBodyInput& input)
    {
      input.young_Pa = { young_Pa };
      input.model = ElasticModel::NeoHookean;
    });
}

/// How much faster a device of .1 kg and 1 N s/m moves after 3.5 s than after .5 s, which 1 N presses on a pad and
/// which was pushed by 1 mm/s at rest. `held_ticks`: the force is computed once in so many ticks. Half of the snapshots
/// get lost.
double growth(SoftPad& pad, double coupling_N_per_m, int held_ticks)
{
  Random random(testSeed(191));
  ContactPlan plan;
  plan.radius_u = 0.005;
  plan.coupling_N_per_m = coupling_N_per_m;
  SoftLoop loop(*pad.body, pad.surface, 100, plan);
  const LinearPlant plant(0.1, 1.0, 0.0, servo_s);
  const double compliance = loop.snapshot().compliance(2, 2) + 1.0 / coupling_N_per_m;
  Vec3 p = SoftPad::middle() + Vec3(0.0, 0.0, 0.005 - compliance);
  Vec3 v(0.0, 0.0, 1e-3);
  double force_N = 1.0;
  double early = 0.0;
  double late = 0.0;
  (void)loop.tick(p + Vec3(0.0, 0.0, 0.01));
  for (int tick = 0; tick < 4000; ++tick)
  {
    const double now_N = loop.tick(p, random.uniform() < 0.5).force_N.z();
    force_N = tick % held_ticks == 0 ? now_N : force_N;
    plant.step(p, v, Vec3(0.0, 0.0, force_N - 1.0));
    const double speed = std::abs(v.z());
    early = tick >= 500 && tick < 1000 ? std::max(early, speed) : early;
    late = tick >= 3500 ? std::max(late, speed) : late;
  }
  return late / early;
}

TEST(TwoRates, SharedComplianceHoldsWhatTheServoHoldsAtTenPacketsASecondOfWhichHalfAreLost)
{
  SoftPad pad = stiffPad(1e6);
  SampledWall wall;
  wall.damping_Ns_per_m = 1.0;
  const double limit_N_per_m = criticalStiffness(wall); // of a wall that the servo itself closes
  const double body_m_per_N = pad.snapshot(0.0, 0.0)->compliance(2, 2);
  for (const double share : { 0.99, 1.01 })
  {
    // Coupling and body in series are as stiff as that wall: then the loop is as stable as that wall's, mode by mode.
    const double series = share * limit_N_per_m;
    const double coupling = 1.0 / (1.0 / series - body_m_per_N);
    EXPECT_NEAR(growth(pad, coupling, 1), std::pow(spectralRadius(wall, series), 3000.0), 0.05) << share;
  }
  // A force that is held for 20 ms has a twentieth of the limit: contact is lost and met again without end.
  EXPECT_GT(growth(pad, 0.08 * limit_N_per_m, 20), 1.0);
}

/// The body's own force on a device that stays at p: snapshot after snapshot until force and state agree.
double restingForce(SoftPad& pad, const ContactPlan& plan, const Vec3& p_W)
{
  SoftLoop loop(*pad.body, pad.surface, 1, plan);
  double force_N = 0.0;
  for (int i = 0; i < 14; ++i)
  {
    loop.state.offset_W.setZero();
    force_N = loop.tick(i == 0 ? Vec3(p_W + Vec3(0.0, 0.0, 0.05)) : p_W).force_N.norm();
  }
  return force_N;
}

void pressFast(Factoring factoring)
{
  ContactPlan plan;
  plan.radius_u = 0.01;
  const double speed = 0.2;
  SoftPad pad = stiffPad(20e3);
  pad.body->factorsBe(factoring);
  SoftPad truth = stiffPad(20e3);
  SoftLoop loop(*pad.body, pad.surface, 40, plan);
  const auto pressed = [speed](int tick)
  { return Vec3(0.052, 0.047, 0.0605 - std::min(speed * servo_s * tick, 0.0155)); };
  double last_N = 0.0;
  double rise_N = 0.0;
  double step_N = 0.0;
  double off2 = 0.0;
  double all2 = 0.0;
  for (int tick = 0; tick < 160; ++tick)
  {
    const double force_N = loop.tick(pressed(tick)).force_N.norm();
    // Beyond the rise that the hand's own speed makes, tick by tick.
    step_N = std::max(step_N, std::abs(force_N - last_N - rise_N));
    rise_N = force_N - last_N;
    last_N = force_N;
    if (tick % 16 == 15)
    {
      const double true_N = restingForce(truth, plan, pressed(tick));
      off2 += std::pow(force_N - true_N, 2);
      all2 += true_N * true_N;
    }
  }
  std::cout << "RMS " << 100.0 * std::sqrt(off2 / all2) << " %, largest step " << step_N << " N\n";
  EXPECT_LE(std::sqrt(off2 / all2), 0.03);
  EXPECT_LE(step_N, 0.12);
}

TEST(TwoRates, PressedFastTheForceIsThatOfTheWholeBodyAndHasNoSteps)
{
  pressFast(Factoring::EachStep);
  pressFast(Factoring::WhenOld);
}

TEST(TwoRates, AChangeOfPacketsLeavesTheForceAsItIs)
{
  ContactPlan plan;
  plan.radius_u = 0.005;
  SoftPad pad = stiffPad(20e3);
  SoftLoop loop(*pad.body, pad.surface, 40, plan);
  const Vec3 p(0.05, 0.05, 0.047);
  double before_N = 0.0;
  for (int tick = 0; tick < 41; ++tick) // the first snapshot that knows of the contact comes at 80
  {
    before_N = loop.tick(tick == 0 ? Vec3(p + Vec3(0, 0, 0.02)) : p).force_N.norm();
  }
  for (int tick = 41; tick < 120; ++tick)
  {
    const double now_N = loop.tick(p).force_N.norm();
    EXPECT_LE(std::abs(now_N - before_N), 0.06 * before_N);
    before_N = now_N;
  }
}

/// A constitutive law of one dimension that gets stiffer: 300 x + 3e6 x^3 [N], felt through 1000 N/m.
struct Hardening
{
  static double force(double x) { return 300.0 * x + 3e6 * x * x * x; }
  static double slope(double x) { return 300.0 + 9e6 * x * x; }
  static double energy(double x) { return 150.0 * x * x + 0.75e6 * x * x * x * x; }
  /// Where it rests with the coupling drawn to p.
  static double rest(double p)
  {
    double x = 0.0;
    for (int i = 0; i < 50 && p > 0.0; ++i)
    {
      x -= (force(x) - 1000.0 * (p - x)) / (slope(x) + 1000.0);
    }
    return x;
  }
};

struct Delivered
{
  double energy_J = 0.0; ///< to the hand, over press and release
  double step_N = 0.0;   ///< largest of a tick
};

/// Goes 12 mm in and out again, at a speed, with snapshots every so many ticks, so late, and lost.
Delivered pressAndRelease(double speed, int period, int late, double lost, const EnergyBalancePlan& plan)
{
  Random random(testSeed(192));
  EnergyBalance balance;
  const double deepest = 0.012;
  double x0 = 0.0; // state of the snapshot in use
  double offset = 0.0;
  double felt_N = 0.0;
  double p = 0.0;
  Delivered found;
  const int turn = static_cast<int>(deepest / (speed * servo_s));
  for (int tick = 1; tick <= 2 * turn + 20; ++tick)
  {
    const auto at = [&](int t) { return std::max(speed * servo_s * std::min(t, 2 * turn - t), 0.0); };
    const double step = at(tick) - p;
    p = at(tick);
    found.energy_J -= felt_N * step;
    const auto line = [&](double from) // force with the snapshot of a state
    {
      const double c = 1.0 / Hardening::slope(from);
      return std::max((p - from + c * Hardening::force(from) - offset) / (c + 1e-3), 0.0);
    };
    offset *= 0.95;
    if (tick % period == 0 && random.uniform() >= lost)
    {
      const double f = line(x0);
      const double next = Hardening::rest(at(tick - late));
      const auto place = [f](double from) { return from + (f - Hardening::force(from)) / Hardening::slope(from); };
      offset += place(x0) - place(next);
      x0 = next;
    }
    const double force_N = line(x0);
    const double over = force_N - Hardening::force(x0);
    const double stored = Hardening::energy(x0) +
                          (Hardening::force(x0) * over + 0.5 * over * over) / Hardening::slope(x0) +
                          0.5e-3 * force_N * force_N;
    const double now_N = force_N + balanceEnergy(plan, stored, step, felt_N, force_N, balance);
    found.step_N = std::max(found.step_N, std::abs(now_N - felt_N));
    felt_N = now_N;
  }
  return found;
}

TEST(TwoRates, AHandGetsNoEnergyFromPacketsOnTimeAndLittleFromLateOnes)
{
  const EnergyBalancePlan usual;
  EnergyBalancePlan late = usual;
  late.share = 0.15;
  EnergyBalancePlan none = usual;
  none.share = 0.0;
  const double x = Hardening::rest(0.012);
  const double stored_J = Hardening::energy(x) + 500.0 * (0.012 - x) * (0.012 - x);
  EXPECT_NEAR(stored_J, 0.0207, 1e-4);
  double worstWithout_J = 0.0;
  for (const double speed : { 0.05, 0.1, 0.2 })
  {
    for (const int period : { 20, 40 })
    {
      const Delivered found = pressAndRelease(speed, period, period, 0.0, usual);
      EXPECT_LE(found.energy_J, 0.0) << speed << " m/s, " << period;
      EXPECT_LE(found.step_N, 0.12);
      worstWithout_J = std::max(worstWithout_J, pressAndRelease(speed, period, period, 0.0, none).energy_J);
    }
    EXPECT_LE(pressAndRelease(speed, 40, 200, 0.0, late).energy_J, 0.02 * stored_J);
    EXPECT_LE(pressAndRelease(speed, 40, 40, 0.5, late).energy_J, 0.02 * stored_J);
    EXPECT_LE(pressAndRelease(speed, 100, 100, 0.0, late).energy_J, 0.02 * stored_J);
  }
  std::cout << "without balance " << 1e3 * worstWithout_J << " mJ\n";
  EXPECT_GT(worstWithout_J, 0.0);
}

TEST(TwoRates, TheEnergyThatIsStoredIsTheWorkThatTheHandHasDone)
{
  SoftPad pad(6);
  ContactPlan plan;
  plan.radius_u = 0.01;
  SoftLoop loop(*pad.body, pad.surface, 1000, plan);
  double work_J = 0.0;
  Vec3 felt_N = Vec3::Zero();
  Vec3 p = SoftPad::middle() + Vec3(0.0, 0.0, 0.0101);
  (void)loop.tick(p);
  for (int tick = 0; tick < 800; ++tick)
  {
    const Vec3 step(0.0, 0.0, -1e-5);
    p += step;
    const Vec3 now_N = loop.tick(p).force_N;
    work_J -= 0.5 * (felt_N + now_N).dot(step);
    felt_N = now_N;
  }
  const SoftSurfaceRef touch{ 0, &loop.snapshot() };
  EXPECT_NEAR(storedEnergy(std::span(&touch, 1), loop.state, plan.coupling_N_per_m) / work_J, 1.0, 2e-3);
}

} // namespace
} // namespace palpate::test
