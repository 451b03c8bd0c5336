// SPDX-License-Identifier: GPL-3.0-or-later
// Row 58: the cost of each stabiliser for a hand: drag in free air, error of a spring's impedance; and its gain.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "devices/FedDevice.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/simulation/CriticalStiffness.h"
#include "testing/lab/simulation/Stabilisers.h"

namespace palpate::lab
{
namespace transparency_experiment
{

constexpr double T = 1e-3, hand_m_per_s = 0.1;

/// Periods of whole ticks: their first harmonic is exact.
constexpr int periods_ticks[] = { 2000, 1000, 500, 200, 100, 50, 40, 32 };

double omegaOf(int ticks)
{
  return 2 * std::numbers::pi / (ticks * T);
}

/// Response to a hand that moves z = middle + amplitude sin(w t): peak force and first harmonic.
struct Response
{
  double peak_N = 0.0;
  std::complex<double> harmonic; ///< of the force over the harmonic of -z
};

Response moveSine(const WallSetup& setup, double middle_m, double amplitude_m, int ticks, double step_m)
{
  FedDevice device;
  WallSetup quantised = setup;
  quantised.parameters.velocity.resolution_m = step_m;
  WallRig rig(device, quantised);
  Response response;
  std::complex<double> force, way;
  constexpr int settling = 2;
  for (int k = 0; k < (settling + 1) * ticks; ++k)
  {
    const double z = middle_m + amplitude_m * std::sin(omegaOf(ticks) * k * T);
    DeviceSample sample;
    sample.pose_D.p.z() = step_m > 0.0 ? std::floor(z / step_m) * step_m : z;
    device.feed(sample);
    const double f = rig.tick().force_D.z();
    if (k >= settling * ticks)
    {
      const std::complex<double> turn = std::exp(std::complex<double>(0, -omegaOf(ticks) * k * T));
      force += f * turn;
      way -= z * turn;
      response.peak_N = std::max(response.peak_N, std::abs(f));
    }
  }
  const std::complex<double> j(0, 1);
  const double w = omegaOf(ticks);
  response.harmonic = force / way * (1.0 - std::exp(-j * w * T)) / (j * w * T);
  return response;
}

/// In free air at 0.1 m/s; the encoder's steps make the velocity jump, not the product's force.
void judgeDrag(const Stabiliser& s, const DeviceModel& device, int ticks, Table& table)
{
  const Subject subject{ "device=" + device.id + " " + caseName({ { "frequency", 1.0 / (ticks * T) } }), s.name, "drag",
    "N" };
  const double amplitude = hand_m_per_s / omegaOf(ticks);
  const double drag =
    moveSine(s.setup(1000.0, T), 2.0 * amplitude + 0.01, amplitude, ticks, device.encoderStep_m).peak_N;
  const double truth = s.viscosity_Ns_per_m * hand_m_per_s;
  if (truth > 0.0)
  {
    // A backward difference of whole steps is off by up to one step a tick.
    const double grain = s.viscosity_Ns_per_m * device.encoderStep_m / T;
    table.within(subject, drag, truth, grain + 0.01 * truth);
  }
  else
  {
    table.atMost(subject, drag, 0.05);
  }
}

void judgeImpedance(const Stabiliser& s, const DeviceModel& device, int ticks, Table& table)
{
  const double K = std::min(500.0, device.maxStiffness_N_per_m);
  const double frequency = 1.0 / (ticks * T);
  const std::string name = "device=" + device.id + " " + caseName({ { "frequency", frequency } });
  const auto error = [&](std::complex<double> response) { return std::abs(response - 1.0); };
  const double measured = error(moveSine(s.setup(K, T), -5e-3, 1e-3, ticks, 0.0).harmonic / K);
  const double theory = error(s.response(omegaOf(ticks), K, T));
  table.within({ name, s.name, "impedance error" }, measured, theory, 1e-3 + 0.02 * theory);
  constexpr double handBandwidth_Hz = 10.0, stiffnessNoticed = 0.08;
  if (s.name == "spring+passivity" && frequency <= handBandwidth_Hz)
  {
    table.atMost({ name, s.name, "impedance error within a hand's own motion" }, measured, stiffnessNoticed);
  }
}

/// Its gain: the stiffest wall nobody holds, friction and encoder left out.
void judgeStiffness(const Stabiliser& s, const DeviceModel& device, double plain, Table& table)
{
  FreeDevice pressed = FreeDevice{ device }.linear();
  pressed.push_N = 1.0;
  const double found = measuredCriticalStiffness(pressed, [&s](double K) { return s.setup(K, T); });
  const Subject subject{ "device=" + device.id, s.name, "K_max", "N/m" };
  if (s.name == "spring+passivity")
  {
    table.atLeast(subject, found, plain);
    return;
  }
  table.info(subject, found);
}

} // namespace transparency_experiment

void runTransparency(const Conditions& conditions, Table& table)
{
  using namespace transparency_experiment;
  const auto& devices = deviceModels();
  const std::size_t many = conditions.pick<std::size_t>(2, devices.size(), devices.size());
  std::size_t done = 0;
  for (const DeviceModel& device : devices)
  {
    if (done == many)
    {
      break;
    }
    FreeDevice pressed = FreeDevice{ device }.linear();
    pressed.push_N = 1.0;
    const double plain = measuredCriticalStiffness(pressed,
      [](double K) {
        return WallSetup{ T, plainSpring(K), {} };
      });
    for (const Stabiliser& s : stabilisers())
    {
      for (const int ticks : periods_ticks)
      {
        judgeDrag(s, device, ticks, table);
        judgeImpedance(s, device, ticks, table);
      }
      judgeStiffness(s, device, plain, table);
    }
    conditions.progress(static_cast<double>(++done) / static_cast<double>(many));
  }
}

} // namespace palpate::lab
