// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/pid/PidWatch.h"

namespace palpate
{

void PidWatch::begin() noexcept
{
  this->own_ = this->engine_.lastLoad();
  if (this->own_ != this->engine_.lastLoad())
  {
    this->own_.clear();
  }
}

bool PidWatch::undisturbed(std::int64_t now_ns) noexcept
{
  constexpr std::int64_t askEvery_ns = 100'000'000;
  if (this->own_.empty() || now_ns - this->asked_ns_ < askEvery_ns)
  {
    return true;
  }
  this->asked_ns_ = now_ns;
  const std::vector<std::uint8_t> now = this->engine_.lastLoad();
  if (now.empty())
  {
    this->own_.clear(); // a device that is gone fails where it is written to
    return true;
  }
  return now == this->own_;
}

} // namespace palpate
