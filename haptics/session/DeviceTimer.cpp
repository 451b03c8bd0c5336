// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/DeviceTimer.h"

#include <algorithm>

namespace palpate
{

Wakeup DeviceTimer::wait() noexcept
{
  this->device_.await();
  const std::int64_t now_ns = this->clock_.now_ns();
  const std::int64_t elapsed_ns = this->started_ ? now_ns - this->last_ns_ : this->period_ns_;
  const std::int64_t periods = std::max<std::int64_t>(1, (elapsed_ns + this->period_ns_ / 2) / this->period_ns_);
  const std::int64_t lateness_ns = std::max<std::int64_t>(0, elapsed_ns - periods * this->period_ns_);
  this->last_ns_ = now_ns;
  this->started_ = true;
  return { now_ns - lateness_ns, lateness_ns, static_cast<std::uint64_t>(periods - 1) };
}

} // namespace palpate
