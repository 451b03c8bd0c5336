// SPDX-License-Identifier: GPL-3.0-or-later
// Row 57, force: a hand that moves smoothly must not feel anything faster than its own motion.
#include <cmath>
#include <numbers>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/shapes/AnalyticTouch.h"

namespace palpate::lab
{
namespace smooth_input_experiment
{

constexpr double rate_Hz = 1000.0;
constexpr double handEnds_Hz = 30.0;

/// Forces under a Hann window, so that the ends of a record do not look like noise.
std::vector<Vec3> windowed(std::vector<Vec3> signal)
{
  const double step = 2 * std::numbers::pi / static_cast<double>(signal.size());
  for (std::size_t i = 0; i < signal.size(); ++i)
  {
    signal[i] *= 0.5 - 0.5 * std::cos(step * (static_cast<double>(i) + 0.5));
  }
  return signal;
}

double energyOf(const std::vector<Vec3>& signal)
{
  double energy = 0.0;
  for (const Vec3& v : signal)
  {
    energy += v.squaredNorm();
  }
  return energy;
}

/// Energy of one line of the discrete Fourier transform and of its mirror image, by Parseval in units of energyOf().
double lineEnergy(const std::vector<Vec3>& signal, std::size_t line)
{
  const auto count = static_cast<double>(signal.size());
  const double step = 2 * std::numbers::pi * static_cast<double>(line) / count;
  Vec3 cosine = Vec3::Zero(), sine = Vec3::Zero();
  for (std::size_t i = 0; i < signal.size(); ++i)
  {
    cosine += std::cos(step * static_cast<double>(i)) * signal[i];
    sine += std::sin(step * static_cast<double>(i)) * signal[i];
  }
  return (line == 0 ? 1.0 : 2.0) * (cosine.squaredNorm() + sine.squaredNorm()) / count;
}

/// Energy above 30 Hz, added up line by line: the difference of all and the energy below would lose small shares in
/// rounding.
double fastEnergy(const std::vector<Vec3>& signal)
{
  const std::size_t half = signal.size() / 2;
  const auto first = static_cast<std::size_t>(handEnds_Hz * static_cast<double>(signal.size()) / rate_Hz) + 1;
  double energy = 0.0;
  for (std::size_t line = first; line < half; ++line)
  {
    energy += lineEnergy(signal, line);
  }
  return energy;
}

/// RMS above 30 Hz, relative to the RMS of the true force.
double fastShare(const std::vector<Vec3>& signal, const std::vector<Vec3>& truth_N)
{
  return std::sqrt(fastEnergy(windowed(signal)) / energyOf(windowed(truth_N)));
}

std::vector<Vec3> difference(const RenderedTouch& touch)
{
  std::vector<Vec3> error_N;
  for (std::size_t i = 0; i < touch.truth_N.size(); ++i)
  {
    error_N.emplace_back(touch.force_N[i] - touch.truth_N[i]);
  }
  return error_N;
}

struct Noise
{
  double truth, error;
  Cost cost;
};

Noise noiseOf(const AnalyticTouch& touch, const char* methodName, int ticks)
{
  const RenderedTouch rendered = render(touch, method(methodName), ticks);
  return { fastShare(rendered.truth_N, rendered.truth_N), fastShare(difference(rendered), rendered.truth_N),
    rendered.cost };
}

std::string nameOf(const AnalyticTouch& touch)
{
  return "body=" + touch.name + " triangles=" + std::to_string(touch.mesh.triangles.size());
}

constexpr double limit = 0.01;

} // namespace smooth_input_experiment

void runSmoothInput(const Conditions& conditions, Table& table)
{
  using namespace smooth_input_experiment;
  const int ticks = conditions.pick(2000, 6000, 16000);
  test::Random random(conditions.seed);
  const std::string quantity = "force error above 30 Hz, RMS";
  for (const AnalyticTouch& touch : { touchPlane(random), touchSphere(7) })
  {
    for (const char* const ours : { "god-object r=0", "god-object r=1mm" })
    {
      const Noise noise = noiseOf(touch, ours, ticks);
      table.atMost({ nameOf(touch), ours, quantity }, noise.error, limit).cost = noise.cost;
    }
    const Noise held = noiseOf(touch, "held-60Hz", ticks);
    table.atLeast({ nameOf(touch), "held-60Hz", quantity }, held.error, limit).cost = held.cost;
    table.atMost({ nameOf(touch), "truth", "force above 30 Hz, RMS" }, held.truth, 1e-3 * limit);
    conditions.progress(0.5);
  }
  // Facets of 4 mm tilt by 2.8 degrees at their corners, 2.3 % of the force in RMS, and are passed 26 times a second.
  const AnalyticTouch coarse = touchSphere(4);
  table.atLeast({ nameOf(coarse), "god-object r=0", quantity }, noiseOf(coarse, "god-object r=0", ticks).error, limit);
}

} // namespace palpate::lab
