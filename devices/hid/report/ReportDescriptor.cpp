// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/report/ReportDescriptor.h"

#include <algorithm>

namespace palpate
{

bool HidField::isWithin(HidUsage collection) const noexcept
{
  return std::find(this->path.begin(), this->path.end(), collection) != this->path.end();
}

const HidReport* ReportDescriptor::report(HidReportKind kind, HidUsage collection) const noexcept
{
  for (const HidReport& candidate : this->reports)
  {
    for (const HidField& field : candidate.fields)
    {
      if (candidate.kind == kind && field.isWithin(collection))
      {
        return &candidate;
      }
    }
  }
  return nullptr;
}

bool ReportDescriptor::hasCollection(HidUsage collection) const noexcept
{
  return std::any_of(this->reports.begin(), this->reports.end(),
    [collection](const HidReport& report)
    {
      return std::any_of(report.fields.begin(), report.fields.end(),
        [collection](const HidField& field) { return field.isWithin(collection); });
    });
}

bool ReportDescriptor::numbered() const noexcept
{
  return std::any_of(
    this->reports.begin(), this->reports.end(), [](const HidReport& report) { return report.id != 0; });
}

HidControl findControl(const HidReport& report, HidUsage usage, HidUsage parent) noexcept
{
  for (const HidField& field : report.fields)
  {
    const bool placed = parent == 0 || (!field.path.empty() && field.path.back() == parent);
    const auto found = std::find(field.usages.begin(), field.usages.end(), usage);
    if (placed && found != field.usages.end())
    {
      const auto index = static_cast<std::uint32_t>(found - field.usages.begin());
      return { &report, &field, field.variable ? index : std::min(index, field.count - 1) };
    }
  }
  return {};
}

HidSelector findSelector(const HidReport& report, HidUsage usage) noexcept
{
  const HidControl control = findControl(report, usage);
  if (!control || control.field->variable)
  {
    return { control, 1 };
  }
  const auto& usages = control.field->usages;
  const std::int64_t index = std::find(usages.begin(), usages.end(), usage) - usages.begin();
  const std::int64_t first = control.field->logicalMin;
  return { { control.report, control.field, 0 }, (first == 0 ? 1 : first) + index };
}

} // namespace palpate
