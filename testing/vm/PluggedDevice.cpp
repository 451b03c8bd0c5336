// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/PluggedDevice.h"

#include <utility>

namespace palpate::test
{

PluggedDevice::PluggedDevice(VirtualHid& firmware, PlugIdentity identity)
  : firmware_(firmware), identity_(std::move(identity))
{
}

void PluggedDevice::passMillisecond()
{
  const auto advanced = [this]
  {
    std::vector<std::vector<std::uint8_t>> inputs;
    this->firmware_.advance(1);
    for (auto input = this->firmware_.nextInput(); !input.empty(); input = this->firmware_.nextInput())
    {
      inputs.push_back(std::move(input));
    }
    return inputs;
  };
  for (const std::vector<std::uint8_t>& input : this->still(advanced))
  {
    this->send(input);
  }
  this->frame();
}

bool PluggedDevice::take(HidReportKind kind, std::span<const std::uint8_t> report)
{
  return this->still([&] { return this->firmware_.take(kind, report); });
}

std::vector<std::uint8_t> PluggedDevice::feature(std::uint8_t id)
{
  return this->still([&] { return this->firmware_.feature(id); });
}

} // namespace palpate::test
