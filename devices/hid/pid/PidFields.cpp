// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/pid/PidFields.h"

#include "devices/hid/report/PidNumbers.h"
#include "devices/hid/report/ReportBits.h"

namespace palpate::pid
{
namespace
{

template<class Convert>
void putNumber(const HidReport& report, std::vector<std::uint8_t>& bytes, HidUsage usage, Convert convert) noexcept
{
  if (const HidControl control = findControl(report, usage))
  {
    writeControl(control, bytes, convert(*control.field));
  }
}

} // namespace

void put(const HidReport& report, std::vector<std::uint8_t>& bytes, HidUsage usage, std::int64_t value,
  HidUsage parent) noexcept
{
  if (const HidControl control = findControl(report, usage, parent))
  {
    writeControl(control, bytes, value);
  }
}

void putShare(const HidReport& report, std::vector<std::uint8_t>& bytes, HidUsage usage, double share) noexcept
{
  putNumber(report, bytes, usage, [share](const HidField& field) { return shareToField(field, share); });
}

void putSignedShare(const HidReport& report, std::vector<std::uint8_t>& bytes, HidUsage usage, double share) noexcept
{
  putNumber(report, bytes, usage, [share](const HidField& field) { return signedShareToField(field, share); });
}

void putTime(const HidReport& report, std::vector<std::uint8_t>& bytes, HidUsage usage, double time_ms) noexcept
{
  putNumber(report, bytes, usage, [time_ms](const HidField& field) { return timeToField(field, time_ms); });
}

void putAllOnes(const HidReport& report, std::vector<std::uint8_t>& bytes, HidUsage usage) noexcept
{
  if (const HidControl control = findControl(report, usage))
  {
    writeRaw(control, bytes, -1);
  }
}

bool select(const HidReport& report, std::vector<std::uint8_t>& bytes, HidUsage usage) noexcept
{
  const HidSelector selector = findSelector(report, usage);
  if (selector)
  {
    writeRaw(selector.control, bytes, selector.value); // may lie beyond a range that begins with 0
  }
  return static_cast<bool>(selector);
}

std::int64_t get(
  const HidReport& report, std::span<const std::uint8_t> bytes, HidUsage usage, std::int64_t otherwise) noexcept
{
  const HidControl control = findControl(report, usage);
  return control ? readControl(control, bytes) : otherwise;
}

bool says(const HidReport& report, std::span<const std::uint8_t> bytes, HidUsage usage) noexcept
{
  const HidSelector selector = findSelector(report, usage);
  return selector && readControl(selector.control, bytes) == selector.value;
}

} // namespace palpate::pid
