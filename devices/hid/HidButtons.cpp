// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/HidButtons.h"

#include <algorithm>

#include "devices/hid/PidUsages.h"
#include "devices/hid/ReportBits.h"

namespace palpate
{
namespace
{

constexpr std::uint32_t mostButtons = 32;

bool isButton(HidUsage usage) noexcept
{
  return usage > pid::buttonPage && usage <= pid::buttonPage + mostButtons;
}

} // namespace

HidButtons::HidButtons(const HidReport& report) noexcept
{
  for (const HidField& field : report.fields)
  {
    if (this->field_ == nullptr && std::any_of(field.usages.begin(), field.usages.end(), isButton))
    {
      this->report_ = &report;
      this->field_ = &field;
    }
  }
}

std::uint32_t HidButtons::count() const noexcept
{
  if (this->field_ == nullptr)
  {
    return 0;
  }
  HidUsage last = pid::buttonPage;
  for (const HidUsage usage : this->field_->usages)
  {
    last = isButton(usage) ? std::max(last, usage) : last;
  }
  return last - pid::buttonPage;
}

std::uint32_t HidButtons::bitOf(HidUsage usage) const noexcept
{
  return isButton(usage) ? std::uint32_t{ 1 } << (usage - pid::buttonPage - 1) : 0;
}

std::uint32_t HidButtons::down(std::span<const std::uint8_t> report) const noexcept
{
  std::uint32_t buttons = 0;
  for (std::uint32_t element = 0; this->field_ != nullptr && element < this->field_->count; ++element)
  {
    const std::int64_t value = readControl({ this->report_, this->field_, element }, report);
    const auto& usages = this->field_->usages;
    if (this->field_->variable)
    {
      buttons |= value != 0 && element < usages.size() ? this->bitOf(usages[element]) : 0;
      continue;
    }
    const std::int64_t index = value - this->field_->logicalMin;
    const bool listed = index >= 0 && index < static_cast<std::int64_t>(usages.size());
    buttons |= listed ? this->bitOf(usages[static_cast<std::size_t>(index)]) : 0;
  }
  return buttons;
}

} // namespace palpate
