// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/pid/PidInput.h"

#include <algorithm>

#include "devices/hid/report/InputReport.h"
#include "devices/hid/report/PidNumbers.h"
#include "devices/hid/report/PidUsages.h"
#include "devices/hid/report/ReportBits.h"

namespace palpate
{
namespace
{

/// An axis that tells where it is, not how far it went.
HidControl absoluteAxis(const HidReport& report, HidUsage usage) noexcept
{
  const HidControl axis = findControl(report, usage);
  return axis && axis.field->variable && !axis.field->relative ? axis : HidControl{};
}

} // namespace

PidInput::PidInput(const ReportDescriptor& descriptor, std::size_t axes)
{
  for (const HidReport& report : descriptor.reports)
  {
    if (report.kind == HidReportKind::Input && !this->axes_[0] && absoluteAxis(report, pid::axisX))
    {
      this->axes_ = { absoluteAxis(report, pid::axisX), axes > 1 ? absoluteAxis(report, pid::axisY) : HidControl{} };
      this->buttons_ = HidButtons(report);
    }
  }
}

double PidInput::step() const noexcept
{
  const HidField& field = *this->axes_[0].field;
  return 2.0 / static_cast<double>(std::max<std::int64_t>(1, field.logicalMax - field.logicalMin));
}

std::optional<PidHand> PidInput::hand(std::span<const std::uint8_t> report) const noexcept
{
  const HidReport& layout = *this->axes_[0].report;
  const InputReport whole(layout.id != 0, report);
  if (!whole.is(layout.id, layout.bytes()))
  {
    return std::nullopt;
  }
  PidHand hand;
  for (const std::size_t axis : { 0U, 1U })
  {
    if (const HidControl& control = this->axes_[axis])
    {
      const std::int64_t value = readControl(control, whole.bytes());
      hand.outOfRange |= value < control.field->logicalMin || value > control.field->logicalMax;
      hand.at[axis] = fieldToSignedShare(*control.field, value);
    }
  }
  hand.buttons = this->buttons_.down(whole.bytes());
  return hand;
}

} // namespace palpate
