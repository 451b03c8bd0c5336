// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as an input report of any descriptor: the hand and the cap stay within their travel, and a report that is
// too short or another one says nothing. First two bytes: how many of the following are the descriptor.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "devices/hid/SpaceMouseInput.h"
#include "devices/hid/pid/PidInput.h"
#include "testing/fuzz/Require.h"

namespace
{

void judgeJoystick(const palpate::ReportDescriptor& descriptor, std::span<const std::uint8_t> report)
{
  const palpate::PidInput input(descriptor);
  if (!input.usable())
  {
    return;
  }
  require(input.step() > 0.0 && input.buttonCount() <= 32);
  const std::optional<palpate::PidHand> hand = input.hand(report);
  require(!hand || (hand->at[0] >= -1.0 && hand->at[0] <= 1.0 && hand->at[1] >= -1.0 && hand->at[1] <= 1.0));
  require(!input.hand(report.first(0)) || !descriptor.numbered());
}

void judgeSpaceMouse(const palpate::ReportDescriptor& descriptor, std::span<const std::uint8_t> report)
{
  const palpate::SpaceMouseInput input(descriptor);
  require(input.buttonCount() <= 32);
  palpate::Cap cap;
  const bool said = input.take(report, cap) != palpate::SpaceMouseInput::Said::Nothing;
  require(std::all_of(cap.at.begin(), cap.at.end(), [](double at) { return at >= -1.0 && at <= 1.0; }));
  const palpate::Cap untouched;
  require(said || (cap.at == untouched.at && cap.buttons == untouched.buttons));
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::size_t promised = size < 2 ? 0 : data[0] + 256U * data[1];
  if (size < 2 || promised > size - 2)
  {
    return 0;
  }
  const palpate::ReportDescriptor descriptor = palpate::parseReportDescriptor({ data + 2, promised });
  const std::span<const std::uint8_t> report(data + 2 + promised, size - 2 - promised);
  judgeJoystick(descriptor, report);
  judgeSpaceMouse(descriptor, report);
  return 0;
}
