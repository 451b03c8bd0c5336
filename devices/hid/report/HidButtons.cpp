// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/report/HidButtons.h"

#include <algorithm>

#include "devices/hid/report/PidUsages.h"
#include "devices/hid/report/ReportBits.h"

namespace palpate
{
namespace
{

constexpr std::uint32_t mostButtons = 32;

bool isButton(HidUsage usage) noexcept
{
  return usage > pid::buttonPage && usage <= pid::buttonPage + mostButtons;
}

std::uint32_t bitOf(HidUsage usage) noexcept
{
  return isButton(usage) ? std::uint32_t{ 1 } << (usage - pid::buttonPage - 1) : 0;
}

} // namespace

HidButtons::HidButtons(const HidReport& report) : report_(&report)
{
  for (const HidField& field : report.fields)
  {
    if (std::any_of(field.usages.begin(), field.usages.end(), isButton))
    {
      this->fields_.push_back(&field);
    }
  }
}

std::uint32_t HidButtons::count() const noexcept
{
  HidUsage last = pid::buttonPage;
  for (const HidField* const field : this->fields_)
  {
    for (const HidUsage usage : field->usages)
    {
      last = isButton(usage) ? std::max(last, usage) : last;
    }
  }
  return last - pid::buttonPage;
}

std::uint32_t HidButtons::down(std::span<const std::uint8_t> report) const noexcept
{
  std::uint32_t buttons = 0;
  for (const HidField* const field : this->fields_)
  {
    buttons |= this->down(*field, report);
  }
  return buttons;
}

std::uint32_t HidButtons::down(const HidField& field, std::span<const std::uint8_t> report) const noexcept
{
  std::uint32_t buttons = 0;
  const std::vector<HidUsage>& usages = field.usages;
  for (std::uint32_t element = 0; element < field.count; ++element)
  {
    const std::int64_t value = readControl({ this->report_, &field, element }, report);
    if (field.variable)
    {
      buttons |= value != 0 && element < usages.size() ? bitOf(usages[element]) : 0;
      continue;
    }
    const std::int64_t index = value - field.logicalMin;
    const bool listed = index >= 0 && index < static_cast<std::int64_t>(usages.size());
    buttons |= listed ? bitOf(usages[static_cast<std::size_t>(index)]) : 0;
  }
  return buttons;
}

} // namespace palpate
