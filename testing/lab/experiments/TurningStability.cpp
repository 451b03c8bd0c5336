// SPDX-License-Identifier: GPL-3.0-or-later
// How stiff a spring may hold a tool's turn: the simulated handle that turns, nobody's and in each hand, against rate.
#include <cmath>
#include <string>

#include "devices/simulated/TurningPart.h"
#include "haptics/force/SampledWall.h"
#include "haptics/tool/motion/Turn.h"
#include "testing/lab/Experiments.h"

namespace palpate::lab
{
namespace turning_stability_experiment
{

/// The assumptions of linear theory: no friction, no steps of an encoder, no largest torque.
TurningModel linearHandle()
{
  TurningModel handle = deviceModel("simulated-6d")->turning;
  handle.friction_Nm = handle.step_rad = 0.0;
  handle.maxTorque_Nm = DeviceModel::unlimited;
  return handle;
}

/// The handle swings about its rest under -K times its turn, held for each period: does it swing further later on?
bool grows(const TurningModel& hand, double period_s, double stiffness_Nm_per_rad)
{
  constexpr int settles = 400, watched = 400, waits = 2000;
  const TurningModel handle = linearHandle();
  TurningPart part(handle, hand, period_s);
  part.begin(turnBy(Vec3(1e-6, 0, 0)));
  const double inertia_kg_m2 = handle.inertia_kg_m2 + hand.inertia_kg_m2;
  double early = 0.0, late = 0.0;
  for (int i = 0; i < settles + waits + 2 * watched; ++i)
  {
    const Vec3 turn = rotationVector(part.turn_D());
    const double energy = (stiffness_Nm_per_rad + hand.stiffness_Nm_per_rad) * turn.squaredNorm() +
                          inertia_kg_m2 * part.rate_D().squaredNorm();
    early += i >= settles && i < settles + watched ? energy : 0.0;
    late += i >= settles + watched + waits ? energy : 0.0;
    if (turn.norm() > 0.1)
    {
      return true;
    }
    part.step(Quat::Identity(), Quat::Identity(), -stiffness_Nm_per_rad * turn);
  }
  return late > early;
}

double measured(const TurningModel& hand, double period_s)
{
  double low = 1e-3, high = 1e3;
  while (high / low > 1.0005)
  {
    const double middle = std::sqrt(low * high);
    (grows(hand, period_s, middle) ? high : low) = middle;
  }
  return std::sqrt(low * high);
}

} // namespace turning_stability_experiment

void runTurningStability(const Conditions& conditions, Table& table)
{
  using namespace turning_stability_experiment;
  const TurningModel handle = linearHandle();
  for (const HandModel& hand : handModels())
  {
    for (const double rate_Hz : { 100.0, 250.0, 500.0, 1000.0, 2000.0, 4000.0 })
    {
      SampledWall exact;
      exact.mass_kg = handle.inertia_kg_m2 + hand.turning.inertia_kg_m2;
      exact.damping_Ns_per_m = handle.damping_Nms + hand.turning.damping_Nms;
      exact.handStiffness_N_per_m = hand.turning.stiffness_Nm_per_rad;
      exact.period_s = 1.0 / rate_Hz;
      const double truth = criticalStiffness(exact);
      const std::string name = caseName({ { "rate", rate_Hz } });
      table.within({ name, hand.name, "K_max", "N m/rad" }, measured(hand.turning, 1.0 / rate_Hz), truth, 0.01 * truth);
      if (hand.name == "none")
      {
        table.info({ name, "2 b / T", "K_passive", "N m/rad" }, 2.0 * handle.damping_Nms * rate_Hz);
      }
    }
  }
  conditions.progress(1.0);
}

} // namespace palpate::lab
