// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/SpaceMouseInput.h"

#include <algorithm>

#include "devices/hid/report/InputReport.h"
#include "devices/hid/report/PidNumbers.h"
#include "devices/hid/report/PidUsages.h"
#include "devices/hid/report/ReportBits.h"

namespace palpate
{
namespace
{

constexpr HidUsage multiAxisController = 0x010008;

} // namespace

SpaceMouseInput::SpaceMouseInput(const ReportDescriptor& descriptor) noexcept : numbered_(descriptor.numbered())
{
  for (const HidReport& report : descriptor.reports)
  {
    if (report.kind != HidReportKind::Input)
    {
      continue;
    }
    for (std::uint32_t axis = 0; axis < this->axes_.size(); ++axis)
    {
      const HidControl control = findControl(report, pid::axisX + axis);
      if (!this->axes_[axis] && control && control.field->variable && control.field->isWithin(multiAxisController))
      {
        this->axes_[axis] = control;
      }
    }
    if (const HidButtons buttons(report); buttons)
    {
      this->buttons_.push_back(buttons);
    }
  }
}

bool SpaceMouseInput::describes(const ReportDescriptor& descriptor) noexcept
{
  return descriptor.hasCollection(multiAxisController);
}

std::string SpaceMouseInput::refusal() const
{
  const bool all = std::all_of(this->axes_.begin(), this->axes_.end(), [](const HidControl& axis) { return !!axis; });
  return all ? "" : "the device lacks some of the six axes x, y, z and the rotations about them";
}

std::uint32_t SpaceMouseInput::buttonCount() const noexcept
{
  std::uint32_t most = 0;
  for (const HidButtons& buttons : this->buttons_)
  {
    most = std::max(most, buttons.count());
  }
  return most;
}

SpaceMouseInput::Said SpaceMouseInput::take(std::span<const std::uint8_t> report, Cap& cap) const noexcept
{
  const InputReport whole(this->numbered_, report);
  Said said = Said::Nothing;
  for (std::size_t axis = 0; axis < this->axes_.size(); ++axis)
  {
    const HidControl& control = this->axes_[axis];
    if (!control || !whole.is(control.report->id, control.report->bytes()))
    {
      continue;
    }
    const std::int64_t value = readControl(control, whole.bytes());
    const bool beyond = value < control.field->logicalMin || value > control.field->logicalMax;
    cap.at[axis] = fieldToSignedShare(*control.field, value);
    said = beyond ? Said::OutOfRange : std::max(said, Said::Part);
  }
  for (const HidButtons& buttons : this->buttons_)
  {
    if (whole.is(buttons.report().id, buttons.report().bytes()))
    {
      cap.buttons = buttons.down(whole.bytes());
      said = std::max(said, Said::Part);
    }
  }
  return said;
}

} // namespace palpate
