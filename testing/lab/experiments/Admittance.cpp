// SPDX-License-Identifier: GPL-3.0-or-later
// Row 86: an admittance in a stiff grip and in air, an impedance beside it: each is bad where the other is good.
#include <string>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/force/StabilityLimits.h"
#include "testing/lab/Experiments.h"
#include "testing/support/Admittance.h"

namespace palpate::lab
{
namespace admittance_experiment
{

using test::runInAir;

void judgeGrip(const AdmittancePlan& plan, Table& table)
{
  const double formula = stiffestHold(plan);
  const std::string name = caseName({ { "mass", plan.mass_kg }, { "damping", plan.damping_Ns_per_m },
    { "lag_ms", 1e3 * plan.lag_s }, { "rate", 1.0 / plan.period_s } });
  table.within(
    { name, "admittance", "stiffest grip", "N/m" }, test::stiffestHoldFound(plan, formula), formula, 0.03 * formula);
}

/// Force that a hand needs at .1 m/s.
void judgeAir(Table& table)
{
  HandPath away;
  away.points_D = { Vec3::Zero(), Vec3(1.0, 0.0, 0.0) };
  away.speed_m_per_s = 0.1;
  const HandModel& hand = *handModel("stylus");
  const AdmittancePlan plan;
  AdmittanceDevice device(plan, hand, away);
  static_cast<void>(device.open());
  runInAir(device, 8000, plan.period_s, [](int) {});
  const double drag = plan.damping_Ns_per_m * away.speed_m_per_s;
  table.within({ "in air at 0.1 m/s", "admittance", "drag", "N" }, device.handForce_D().x(), drag, 1e-3 * drag);
  const DeviceModel& model = *deviceModel("simulated-generic");
  SimulatedDevice impedance(model, hand, away);
  static_cast<void>(impedance.open());
  // The simulated hand holds its pull for a period in which the handle goes on: the drag is the mean of the period.
  double before_m = 0.0, now_m = 0.0;
  runInAir(impedance, 8000, 1e-3,
    [&](int)
    {
      before_m = now_m;
      now_m = impedance.position_D().x();
    });
  const double pulled_N = hand.stiffness_N_per_m * (impedance.target(7.999).x() - 0.5 * (before_m + now_m)) +
                          hand.damping_Ns_per_m * (away.speed_m_per_s - impedance.speed_D().x());
  const double own = model.damping_Ns_per_m * away.speed_m_per_s;
  table.within({ "in air at 0.1 m/s", "impedance", "drag", "N" }, pulled_N, own, 0.01 * own);
  LoopSettings loop;
  loop.passivity.enabled = false;
  table.info({ "wall", "impedance", "stiffest wall", "N/m" }, stabilityLimits(infoOf(model), loop).stable_N_per_m);
  table.info({ "wall", "admittance", "stiffest grip at a rigid wall", "N/m" }, stiffestHold(plan));
}

} // namespace admittance_experiment

void runAdmittance(const Conditions& conditions, Table& table)
{
  using namespace admittance_experiment;
  for (const double lag_s : { 0.005, 0.02 })
  {
    for (const double period_s : { 1e-3, 2.5e-4 })
    {
      AdmittancePlan plan;
      plan.lag_s = lag_s;
      plan.period_s = period_s;
      judgeGrip(plan, table);
    }
  }
  conditions.progress(0.9);
  judgeAir(table);
}

} // namespace palpate::lab
