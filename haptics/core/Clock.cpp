// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/core/Clock.h"

#include <ctime>

namespace palpate
{

std::int64_t MonotonicClock::now_ns() const noexcept
{
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{ now.tv_sec } * 1'000'000'000 + now.tv_nsec;
}

} // namespace palpate
