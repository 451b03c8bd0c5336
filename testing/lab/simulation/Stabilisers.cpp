// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/simulation/Stabilisers.h"

namespace palpate::lab
{
namespace
{

using Complex = std::complex<double>;

constexpr double damper_Ns_per_m = 2.0, filter_s = 0.005;

/// First harmonic of a force that is held for a period.
Complex hold(double omega, double T)
{
  const Complex j(0, 1);
  return (1.0 - std::exp(-j * omega * T)) / (j * omega * T);
}

/// Backward difference times a period.
Complex difference(double omega, double T)
{
  return 1.0 - std::exp(Complex(0, -omega * T));
}

Stabiliser nothing()
{
  return { "spring",
    [](double K, double T) {
      return WallSetup{ T, plainSpring(K), {} };
    },
    [](double w, double, double T) { return hold(w, T); } };
}

Stabiliser damper()
{
  return { "spring+damper",
    [](double K, double T) {
      return WallSetup{ T, springDamper(K, damper_Ns_per_m), {} };
    },
    [](double w, double K, double T) { return hold(w, T) * (1.0 + damper_Ns_per_m / (K * T) * difference(w, T)); } };
}

/// The damper acts always, as in toolkits that damp the device itself.
Stabiliser viscosity()
{
  // The velocity is estimated by the same backward difference as the damper's.
  const auto drag = [](const HapticState& state) -> Vec3 { return state.force_D - damper_Ns_per_m * state.velocity_D; };
  Stabiliser s = damper();
  s.name = "viscosity everywhere";
  s.setup = [drag](double K, double T)
  {
    WallSetup setup{ T, springDamper(K, 0.0), drag };
    return setup;
  };
  s.viscosity_Ns_per_m = damper_Ns_per_m;
  return s;
}

/// One pole on the force: a usual remedy against buzzing.
Stabiliser filteredForce()
{
  return { "filtered force",
    [](double K, double T)
    {
      const double a = T / (filter_s + T);
      return WallSetup{ T, plainSpring(K),
        [a, filtered = Vec3(Vec3::Zero())](const HapticState& state) mutable -> Vec3
        { return filtered += a * (state.force_D - filtered); } };
    },
    [](double w, double, double T)
    {
      const double a = T / (filter_s + T);
      return hold(w, T) * a / (1.0 - (1.0 - a) * std::exp(Complex(0, -w * T)));
    } };
}

Stabiliser controller()
{
  return { "spring+passivity",
    [](double K, double T) {
      return WallSetup{ T, passiveSpring(K), {} };
    },
    [](double w, double, double T)
    {
      const PassivityPlan plan;
      return hold(w, T) * (1.0 + (0.5 + plan.reserve) * difference(w, T));
    } };
}

} // namespace

std::vector<Stabiliser> stabilisers()
{
  return { nothing(), damper(), viscosity(), filteredForce(), controller() };
}

} // namespace palpate::lab
