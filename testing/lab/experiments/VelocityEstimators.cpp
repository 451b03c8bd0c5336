// SPDX-License-Identifier: GPL-3.0-or-later
// Row 7: the velocity that an encoder shows, how late, and how much damping that allows.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "haptics/force/VelocityEstimator.h"
#include "testing/lab/Experiments.h"
#include "testing/support/Random.h"

namespace palpate::lab
{
namespace velocity_estimators_experiment
{

constexpr double T = 1e-3, D = 50e-6, ramp_s = 1.0, top_m_per_s = 0.2;

struct Estimator
{
  const char* name;
  VelocityFilter filter;
};

std::vector<Estimator> estimators()
{
  VelocityFilter backward{ VelocityMethod::BackwardDifference, D };
  VelocityFilter lowPass{ VelocityMethod::LowPass, D };
  VelocityFilter adaptive{ VelocityMethod::AdaptiveWindow, D };
  return { { "backward difference", backward }, { "low pass", lowPass }, { "adaptive window", adaptive } };
}

struct Error
{
  double rms_m_per_s = 0.0;
  double lag_s = 0.0;
};

/// A hand that goes from rest to 0.2 m/s in one second, from a random place between two encoder steps. The lag is
/// the mean error over the acceleration, for which a ramp is the test signal.
Error onRamp(const VelocityFilter& filter, double start_m)
{
  VelocityHistory history;
  const double acceleration = top_m_per_s / ramp_s;
  double squares = 0.0, sum = 0.0;
  int count = 0;
  const int ticks = static_cast<int>(ramp_s / T);
  for (int k = 0; k <= ticks; ++k)
  {
    const double t = k * T, x = start_m + 0.5 * acceleration * t * t;
    const Vec3 shown(std::floor(x / D) * D, 0, 0);
    const double error = estimateVelocity(filter, shown, T, history).x() - acceleration * t;
    constexpr int settled = 20;
    if (k >= settled)
    {
      squares += error * error;
      sum += error;
      ++count;
    }
  }
  return { std::sqrt(squares / count), -sum / count / acceleration };
}

Error overStarts(const VelocityFilter& filter, int starts, std::uint64_t seed)
{
  test::Random random(seed);
  Error mean;
  for (int i = 0; i < starts; ++i)
  {
    const Error one = onRamp(filter, random.uniform(0.0, D));
    mean.rms_m_per_s += one.rms_m_per_s * one.rms_m_per_s / starts;
    mean.lag_s += one.lag_s / starts;
  }
  mean.rms_m_per_s = std::sqrt(mean.rms_m_per_s);
  return mean;
}

/// The same error at a speed just above half an encoder step a tick, where the plain difference jumps most: 0 or D / T.
double stepNoise(const VelocityFilter& filter)
{
  VelocityHistory history;
  const double speed = 0.5 * (1.0 + std::sqrt(5.0)) / 3.0 * D / T; // irrational: all phases occur
  double squares = 0.0;
  constexpr int ticks = 5000, settled = 50;
  for (int k = 0; k < ticks; ++k)
  {
    const Vec3 shown(std::floor(speed * k * T / D) * D, 0, 0);
    const double error = estimateVelocity(filter, shown, T, history).x() - speed;
    squares += k >= settled ? error * error : 0.0;
  }
  return std::sqrt(squares / (ticks - settled));
}

} // namespace velocity_estimators_experiment

void runVelocityEstimators(const Conditions& conditions, Table& table)
{
  using namespace velocity_estimators_experiment;
  const int starts = conditions.pick(50, 500, 5000);
  const double resolution = D / T;
  double backwardNoise = 0.0;
  for (const Estimator& e : estimators())
  {
    const Error error = overStarts(e.filter, starts, conditions.seed);
    const double noise = stepNoise(e.filter);
    const std::string ramp = "ramp 0 to 0.2 m/s", constant = "constant speed";
    if (e.filter.method == VelocityMethod::BackwardDifference)
    {
      backwardNoise = noise;
      // A share p of the ticks shows D / T, the rest 0: the variance is p (1 - p) (D / T)^2.
      const double p = 0.5 * (1.0 + std::sqrt(5.0)) / 3.0;
      const double truth = std::sqrt(p * (1 - p)) * resolution;
      table.within({ constant, e.name, "RMS error", "m/s" }, noise, truth, 0.01 * truth);
      table.atLeast({ ramp, e.name, "RMS error", "m/s" }, error.rms_m_per_s, 5e-3);
      continue;
    }
    // Same force noise B * error: the usable damping grows as the noise falls.
    table.atLeast({ constant, e.name, "usable damping over that of the backward difference" }, backwardNoise / noise,
      e.filter.method == VelocityMethod::AdaptiveWindow ? 3.0 : 1.0);
    if (e.filter.method == VelocityMethod::AdaptiveWindow)
    {
      table.atMost({ ramp, e.name, "RMS error", "m/s" }, error.rms_m_per_s, 5e-3);
      table.atMost({ ramp, e.name, "lag", "s" }, error.lag_s, 5e-3);
    }
    else
    {
      // One pole: the error to a ramp settles at the time constant, and half a tick of the difference.
      table.within({ ramp, e.name, "lag", "s" }, error.lag_s, e.filter.lowPass_s + T / 2, 0.05 * e.filter.lowPass_s);
    }
  }
}

} // namespace palpate::lab
