// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/simulation/FreeDevice.h"

#include <cmath>
#include <deque>

namespace palpate::lab
{
namespace
{
// stand-in
struct StandIn final : public ObservedDevice, public HapticDevice
{
  FreeDevice w; double T; DeviceInfo i; double x, v; std::deque<double> queue; double f = 0; bool first = true;
  StandIn(const FreeDevice& what, double T_) : w(what), T(T_), x(what.z_m), v(what.speed_m_per_s)
  { i.mass_kg = { w.mass_kg, true }; i.damping_Ns_per_m = { w.damping_Ns_per_m, true }; i.resolution_m = { w.encoderStep_m, true }; i.simulated = true; queue.assign(w.delay_ticks, 0.0);}
  HapticDevice& device() override { return *this; }
  double z_m() const override { return x; }
  double speed_m_per_s() const override { return v; }
  const DeviceInfo& info() const noexcept override { return i; }
  std::string open() override { return {}; }
  void close() noexcept override {}
  void adv(double u, double h)
  {
    const double b = w.damping_Ns_per_m, m = w.mass_kg;
    if (b == 0) { x += v * h + .5 * u / m * h * h; v += u / m * h; }
    else { const double e = std::exp(-b * h / m), vi = u / b; x += vi * h + (v - vi) * m / b * (1 - e); v = vi + (v - vi) * e; }
  }
  DeviceStatus read(double t, DeviceSample& s) noexcept override
  {
    if (!first)
    {
      queue.push_back(f); const double force = queue.front() - w.push_N; queue.pop_front();
      if (w.friction_N == 0) adv(force, T);
      else { const int S = 50; for (int k = 0; k < S; ++k) { const double c = w.friction_N; double dir = v > 0 ? 1 : v < 0 ? -1 : 0; if (dir == 0) { if (std::abs(force) <= c) break; dir = force > 0 ? 1 : -1; } const double v0 = v; adv(force - c * dir, T / S); if (v0 != 0 && v * dir < 0) { v = 0; } } }
    }
    first = false;
    s = DeviceSample{}; s.time_s = t; s.pose_D.p.z() = w.encoderStep_m > 0 ? -std::floor(-x / w.encoderStep_m) * w.encoderStep_m : x;
    return DeviceStatus::Ok;
  }
  void write(const DeviceCommand& c) noexcept override { f = c.wrench_D.force.z(); f = std::min(f, w.maxForce_N); }
};
}
FreeDevice FreeDevice::linear() const
{
  FreeDevice plain = *this;
  plain.friction_N = plain.encoderStep_m = 0.0;
  plain.maxForce_N = plain.maxStiffness_N_per_m = std::numeric_limits<double>::infinity();
  return plain;
}

std::unique_ptr<ObservedDevice> makeFree(const FreeDevice& what, double period_s) { return std::make_unique<StandIn>(what, period_s); }
}
