// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/Rumble.h"

#include <algorithm>

#include "haptics/core/Clock.h"

namespace palpate
{
namespace
{

constexpr std::int64_t pulse_ns = 40 * perMs_ns, shake_ns = 200 * perMs_ns;
constexpr double pulsePeriod_ms = 40.0, shakePeriod_ms = 20.0, slidingPeriod_ms = 10.0;
// Two levels, so that a force at the limit does not pulse again and again.
constexpr double beginsAbove = 0.02, endsBelow = 0.01;
constexpr std::int64_t speedOver_ns = 16 * perMs_ns; ///< several reports of any link

} // namespace

Vibration Rumble::next(std::int64_t now_ns, const DeviceCommand& command, const Vec3& p_D) noexcept
{
  const Vec3& force_D = command.wrench_D.force;
  const double share = force_D.norm() / this->options_.maxForce_N;
  this->watchContact(now_ns, share);
  this->watchSignal(now_ns, command.signal);
  const double speed = this->slidingSpeed(now_ns, force_D, p_D);
  const double largest = this->options_.largestShare;
  if (now_ns < this->pulseUntil_ns_)
  {
    return { largest, pulsePeriod_ms };
  }
  if (now_ns < this->shakeUntil_ns_)
  {
    return { largest, shakePeriod_ms };
  }
  if (!this->touching_)
  {
    return { 0.0, slidingPeriod_ms };
  }
  return { std::min(largest, share) * std::min(1.0, speed / this->options_.fullSpeed_m_per_s), slidingPeriod_ms };
}

void Rumble::watchContact(std::int64_t now_ns, double share) noexcept
{
  if (!this->touching_ && share > beginsAbove)
  {
    this->touching_ = true;
    this->pulseUntil_ns_ = now_ns + pulse_ns;
  }
  else if (this->touching_ && share < endsBelow)
  {
    this->touching_ = false;
    this->pulseUntil_ns_ = 0; // out of contact nothing shakes
  }
}

void Rumble::watchSignal(std::int64_t now_ns, Signal signal) noexcept
{
  if (signal != this->lastSignal_)
  {
    this->shakeUntil_ns_ = signal == Signal::Oscillation ? now_ns + shake_ns : now_ns;
  }
  this->lastSignal_ = signal;
}

/// Across the force, over some reports: within one the hand shows no motion.
double Rumble::slidingSpeed(std::int64_t now_ns, const Vec3& force_D, const Vec3& p_D) noexcept
{
  if (!this->placed_)
  {
    this->placed_ = true;
    this->placedAt_D_ = p_D;
    this->placedAt_ns_ = now_ns;
  }
  const std::int64_t since_ns = now_ns - this->placedAt_ns_;
  if (since_ns >= speedOver_ns)
  {
    const Vec3 moved_D = p_D - this->placedAt_D_;
    const double force2 = force_D.squaredNorm();
    const Vec3 across_D = force2 > 0.0 ? Vec3(moved_D - force_D * (force_D.dot(moved_D) / force2)) : moved_D;
    this->speed_m_per_s_ = across_D.norm() / (1e-9 * static_cast<double>(since_ns));
    this->placedAt_D_ = p_D;
    this->placedAt_ns_ = now_ns;
  }
  return this->speed_m_per_s_;
}

} // namespace palpate
