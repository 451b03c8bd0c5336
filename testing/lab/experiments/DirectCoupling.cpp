// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 67 and 68: an object that is stable alone and not when it is touched, and one whose force is held at its own
// rate.
#include <cmath>

#include "haptics/force/SampledWall.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/ExactLoops.h"

namespace palpate::lab
{
namespace direct_coupling_experiment
{

struct Object
{
  double mass_kg = 0.0;
  double stiffness_N_per_m = 0.0;
  double damping_Ns_per_m = 0.0;
  double step_s = 0.0;
};

/// The stiffness at which a loop begins to grow [N/m], by bisection.
template<class Radius>
double criticalOf(const Radius& radius)
{
  double low = 1e-3;
  double high = 1e8;
  for (int i = 0; i < 100; ++i)
  {
    const double middle = std::sqrt(low * high);
    (radius(middle) > 1.0 + 1e-10 ? high : low) = middle;
  }
  return low;
}

/// Touched through a spring by a device that stays in place: first the speed, then the place by it.
double semiImplicitRadius(const Object& o, double contact)
{
  const double a = o.step_s * (o.stiffness_N_per_m + contact) / o.mass_kg;
  Eigen::Matrix2d step;
  step << 1.0 - o.step_s * a, o.step_s, -a, 1.0;
  return spectralRadius(step);
}

/// The same with the place at the end of the step.
double implicitRadius(const Object& o, double contact)
{
  const double a = o.step_s * (o.stiffness_N_per_m + contact) / o.mass_kg;
  Eigen::Matrix2d step;
  step << 1.0, o.step_s, -a, 1.0;
  return spectralRadius(step / (1.0 + o.step_s * a));
}

/// A device of .1 kg and 1 N s/m whose place drives the object once a step, and which feels a force that is held for
/// it.
double heldForceRadius(const Object& o, double contact)
{
  constexpr double mass_kg = 0.1, damping_Ns_per_m = 1.0;
  const double fall = std::exp(-damping_Ns_per_m * o.step_s / mass_kg);
  const double glide_s = mass_kg / damping_Ns_per_m * (1.0 - fall);
  const double h = o.step_s;
  Eigen::Matrix4d step; // place and speed of the device, of the object
  for (int i = 0; i < 4; ++i)
  {
    const Eigen::Vector4d s = Eigen::Vector4d::Unit(i);
    const double force = -contact * (s[0] - s[2]);
    const double speed = (o.mass_kg * s[3] - h * o.stiffness_N_per_m * s[2] - h * force) /
                         (o.mass_kg + h * o.damping_Ns_per_m + h * h * o.stiffness_N_per_m);
    step.col(i) << s[0] + glide_s * s[1] + (h - glide_s) / damping_Ns_per_m * force,
      fall * s[1] + (1.0 - fall) / damping_Ns_per_m * force, s[2] + h * speed, speed;
  }
  return spectralRadius(step);
}

} // namespace direct_coupling_experiment

void runDirectCoupling(const Conditions&, Table& table)
{
  using namespace direct_coupling_experiment;
  for (const Object& o :
    { Object{ 1e-3, 1e3, 0.0, 1e-3 }, Object{ 1e-2, 1e3, 0.0, 1e-3 }, Object{ 0.1, 1e3, 0.0, 1e-2 } })
  {
    const std::string name = caseName({ { "mass_g", 1e3 * o.mass_kg }, { "step_ms", 1e3 * o.step_s } });
    // Alone stable up to 4 m / T^2; the contact's spring adds to its own.
    const double truth = 4.0 * o.mass_kg / (o.step_s * o.step_s) - o.stiffness_N_per_m;
    const double found = criticalOf([&o](double contact) { return semiImplicitRadius(o, contact); });
    table.within({ name, "semi-implicit object", "stiffest contact", "N/m" }, found, truth, 0.01 * truth);
    table.atMost(
      { name, "implicit object", "growth a step at a hundred times that" }, implicitRadius(o, 100.0 * truth), 1.0);
  }
  SampledWall wall;
  wall.damping_Ns_per_m = 1.0;
  const double limit = criticalStiffness(wall);
  // docs/theory.md, "Objects that move, touched": of an object of 5 g, 3000 N/m and .5 N s/m.
  for (const auto& [rate_Hz, truth] : { std::pair(1000.0, 23998.0), { 100.0, 260.0 }, { 50.0, 115.0 }, { 25.0, 56.0 } })
  {
    const Object o{ 5e-3, 3e3, 0.5, 1.0 / rate_Hz };
    const std::string name = caseName({ { "rate", rate_Hz } });
    const double held = criticalOf([&o](double contact) { return heldForceRadius(o, contact); });
    table.within({ name, "held force", "stiffest contact", "N/m" }, held, truth, 0.02 * truth);
    // Compliance that the servo shares is felt at the servo's rate whatever the object's: in series with the contact.
    const double shared = 1.0 / (1.0 / limit - 1.0 / o.stiffness_N_per_m);
    table.info({ name, "shared compliance", "stiffest contact", "N/m" }, shared);
  }
}

} // namespace palpate::lab
