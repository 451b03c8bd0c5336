// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/report/ReportBits.h"

#include <algorithm>

namespace palpate
{
namespace
{

constexpr std::size_t idBits = 8;

std::size_t bitOf(const HidControl& control) noexcept
{
  return idBits + control.field->bit + std::size_t{ control.element } * control.field->bitCount;
}

} // namespace

std::uint64_t extractBits(std::span<const std::uint8_t> bytes, std::size_t bit, std::uint32_t bitCount) noexcept
{
  std::uint64_t value = 0;
  for (std::uint32_t done = 0; done < bitCount;)
  {
    const std::size_t at = bit + done;
    const auto shift = static_cast<std::uint32_t>(at % 8);
    const std::uint32_t taken = std::min(8 - shift, bitCount - done);
    if (at / 8 >= bytes.size())
    {
      break;
    }
    const std::uint64_t part = (bytes[at / 8] >> shift) & ((1U << taken) - 1U);
    value |= part << done;
    done += taken;
  }
  return value;
}

void insertBits(std::span<std::uint8_t> bytes, std::size_t bit, std::uint32_t bitCount, std::uint64_t value) noexcept
{
  for (std::uint32_t done = 0; done < bitCount;)
  {
    const std::size_t at = bit + done;
    const auto shift = static_cast<std::uint32_t>(at % 8);
    const std::uint32_t taken = std::min(8 - shift, bitCount - done);
    if (at / 8 >= bytes.size())
    {
      return;
    }
    const auto mask = static_cast<std::uint8_t>(((1U << taken) - 1U) << shift);
    const auto part = static_cast<std::uint8_t>((value >> done) << shift);
    bytes[at / 8] = static_cast<std::uint8_t>((bytes[at / 8] & ~mask) | (part & mask));
    done += taken;
  }
}

std::int64_t readControl(const HidControl& control, std::span<const std::uint8_t> report) noexcept
{
  const std::uint32_t bitCount = control.field->bitCount;
  const std::uint64_t value = extractBits(report, bitOf(control), bitCount);
  const std::uint64_t sign = std::uint64_t{ 1 } << (bitCount - 1);
  const bool negative = control.field->logicalMin < 0 && (value & sign) != 0;
  return static_cast<std::int64_t>(negative ? value - sign - sign : value);
}

void writeControl(const HidControl& control, std::span<std::uint8_t> report, std::int64_t value) noexcept
{
  writeRaw(control, report, std::clamp(value, control.field->logicalMin, control.field->logicalMax));
}

void writeRaw(const HidControl& control, std::span<std::uint8_t> report, std::int64_t value) noexcept
{
  insertBits(report, bitOf(control), control.field->bitCount, static_cast<std::uint64_t>(value));
}

} // namespace palpate
