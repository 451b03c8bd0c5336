// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/LogitechWheel.h"

#include <cmath>
#include <utility>

namespace palpate::test
{
namespace
{

constexpr std::size_t orderBytes = 7;

} // namespace

bool LogitechWheel::take(HidReportKind kind, std::span<const std::uint8_t> bytes)
{
  if (kind != HidReportKind::Output || bytes.size() != orderBytes)
  {
    ++this->unknown;
    return false;
  }
  ++this->orders;
  switch (bytes[0])
  {
    case 0x11:
      this->level = bytes[1] == 0x08 ? bytes[2] : this->level;
      return true;
    case 0x13:
      this->level = 0x80;
      return true;
    case 0x14:
    case 0xF5:
      this->ownSpring = bytes[0] == 0x14;
      return true;
    case 0xF8:
      this->range_deg = bytes[1] == 0x81 ? bytes[2] + 256 * bytes[3] : this->range_deg;
      return true;
    case 0xFE:
      return true;
    default:
      ++this->unknown;
      return true;
  }
}

std::vector<std::uint8_t> LogitechWheel::nextInput()
{
  if (this->inputs_.empty())
  {
    return {};
  }
  std::vector<std::uint8_t> oldest = std::move(this->inputs_.front());
  this->inputs_.pop_front();
  return oldest;
}

/// It says where it is when that has changed.
void LogitechWheel::advance(int duration_ms)
{
  for (int i = 0; i < duration_ms; ++i)
  {
    const auto at = static_cast<std::uint32_t>(std::lround(32767.5 * (1.0 + this->position)));
    std::vector<std::uint8_t> report{ static_cast<std::uint8_t>(at & 0xFFU), static_cast<std::uint8_t>(at >> 8U), 0xFF,
      0xFF, 0xFF };
    for (unsigned shift = 0; shift < 24; shift += 8)
    {
      report.push_back(static_cast<std::uint8_t>(this->buttons >> shift & 0xFFU));
    }
    if (report != this->shown_)
    {
      this->shown_ = report;
      this->inputs_.push_back(std::move(report));
    }
  }
}

std::vector<std::uint8_t> wheelDescriptor()
{
  return {
    0x05, 0x01, 0x09, 0x04, 0xA1, 0x01,                                     // a joystick
    0x15, 0x00, 0x27, 0xFF, 0xFF, 0x00, 0x00, 0x75, 0x10, 0x95, 0x01,       // 0 .. 65535 in 16 bits, once
    0x09, 0x30, 0x81, 0x02,                                                 // x
    0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x03,                               // 0 .. 255 in 8 bits, three times
    0x09, 0x31, 0x09, 0x32, 0x09, 0x35, 0x81, 0x02,                         // y, z, z turned: the pedals
    0x05, 0x09, 0x19, 0x01, 0x29, 0x18, 0x25, 0x01, 0x75, 0x01, 0x95, 0x18, // 24 buttons
    0x81, 0x02,                                                             //
    0x06, 0x00, 0xFF, 0x09, 0x02, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x07, // its maker's seven bytes
    0x91, 0x02, 0xC0                                                        // out
  };
}

UsbWheel::UsbWheel() : UsbTransport(this->wheel_, { "G29", "", 0x046D, 0xC24F, 0x8900, wheelDescriptor() }) {}

} // namespace palpate::test
