// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/PidInput.h"

#include <algorithm>

#include "devices/hid/PidNumbers.h"
#include "devices/hid/PidUsages.h"
#include "devices/hid/ReportBits.h"

namespace palpate
{
namespace
{

constexpr std::uint32_t mostButtons = 32;
constexpr std::size_t longestReport = 2049;

/// An axis that tells where it is, not how far it went.
HidControl absoluteAxis(const HidReport& report, HidUsage usage) noexcept
{
  const HidControl axis = findControl(report, usage);
  return axis && axis.field->variable && !axis.field->relative ? axis : HidControl{};
}

} // namespace

PidInput::PidInput(const ReportDescriptor& descriptor) noexcept
{
  for (const HidReport& report : descriptor.reports)
  {
    if (report.kind == HidReportKind::Input && !this->axes_[0] && absoluteAxis(report, pid::axisX))
    {
      this->axes_ = { absoluteAxis(report, pid::axisX), absoluteAxis(report, pid::axisY) };
      this->firstButton_ = findControl(report, pid::buttonPage + 1);
    }
  }
}

std::uint32_t PidInput::buttonCount() const noexcept
{
  const bool bits = this->firstButton_ && this->firstButton_.field->variable;
  return bits ? std::min(mostButtons, this->firstButton_.field->count - this->firstButton_.element) : 0;
}

double PidInput::step() const noexcept
{
  const HidField& field = *this->axes_[0].field;
  return 2.0 / static_cast<double>(std::max<std::int64_t>(1, field.logicalMax - field.logicalMin));
}

std::optional<PidHand> PidInput::hand(std::span<const std::uint8_t> report) const noexcept
{
  const HidReport& layout = *this->axes_[0].report;
  // A device without IDs sends none: give it the 0 that hidapi leaves out.
  std::array<std::uint8_t, longestReport> whole;
  if (layout.id == 0 && report.size() < whole.size())
  {
    whole[0] = 0;
    std::copy(report.begin(), report.end(), whole.begin() + 1);
    report = { whole.data(), report.size() + 1 };
  }
  if (report.empty() || report[0] != layout.id || report.size() < layout.bytes())
  {
    return std::nullopt;
  }
  PidHand hand;
  for (const std::size_t axis : { 0U, 1U })
  {
    if (const HidControl& control = this->axes_[axis])
    {
      const std::int64_t value = readControl(control, report);
      hand.outOfRange |= value < control.field->logicalMin || value > control.field->logicalMax;
      hand.at[axis] = fieldToSignedShare(*control.field, value);
    }
  }
  for (std::uint32_t button = 0; button < this->buttonCount(); ++button)
  {
    const HidControl control{ this->firstButton_.report, this->firstButton_.field,
      this->firstButton_.element + button };
    hand.buttons |= static_cast<std::uint32_t>(readControl(control, report) != 0) << button;
  }
  return hand;
}

} // namespace palpate
