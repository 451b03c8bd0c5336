// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/protocol/FalconStart.h"

#include <algorithm>
#include <array>
#include <vector>

namespace palpate
{
namespace
{

enum Request : std::uint8_t
{
  Purge = 0,
  Modem = 1,
  Flow = 2,
  Divisor = 3,
  Format = 4,
  Latency = 9,
};
constexpr std::uint16_t dtrHigh = 0x0101, dtrLow = 0x0100, rtsLow = 0x0200;
constexpr std::uint16_t baud9600 = 0x4138, baud140000 = 0x15, forPackets = 0x2, eightBits = 8;
constexpr std::size_t piece = 62;
constexpr int attempts = 100, pieceEcho_ms = 500, greetingEcho_ms = 20;
constexpr std::array<std::uint8_t, 3> greeting{ 0x0A, 0x43, 0x0D };
constexpr std::array<std::uint8_t, 4> greeted{ 0x0A, 0x44, 0x2C, 0x0D };

struct Control
{
  Request request;
  std::uint16_t value;
};

template<std::size_t N>
bool tell(FtdiPort& port, const std::array<Control, N>& all) noexcept
{
  return std::all_of(
    all.begin(), all.end(), [&port](const Control& one) { return port.control(one.request, one.value); });
}

/// Reads until there are so many bytes or no more come.
std::vector<std::uint8_t> heard(FtdiPort& port, std::size_t length, int longest_ms)
{
  constexpr int ownBytes = 2, most = 64;
  std::vector<std::uint8_t> all;
  for (int left_ms = longest_ms; left_ms > 0 && all.size() < length; --left_ms)
  {
    std::array<std::uint8_t, most> transfer;
    const int count = port.read(transfer, 1);
    if (count < 0)
    {
      return {};
    }
    all.insert(all.end(), transfer.begin() + std::min(count, ownBytes), transfer.begin() + count);
  }
  return all;
}

/// A 0 may come first.
bool greets(FtdiPort& port)
{
  for (int i = 0; i < attempts; ++i)
  {
    if (!port.write(greeting))
    {
      return false;
    }
    std::vector<std::uint8_t> answer = heard(port, greeted.size(), greetingEcho_ms);
    if (!answer.empty() && answer.front() == 0)
    {
      answer.erase(answer.begin());
      const std::vector<std::uint8_t> rest = heard(port, greeted.size() - answer.size(), greetingEcho_ms);
      answer.insert(answer.end(), rest.begin(), rest.end());
    }
    if (std::equal(answer.begin(), answer.end(), greeted.begin(), greeted.end()))
    {
      return true;
    }
  }
  return false;
}

bool echoes(FtdiPort& port, std::span<const std::uint8_t> bytes)
{
  if (!port.write(bytes))
  {
    return false;
  }
  const std::vector<std::uint8_t> echo = heard(port, bytes.size(), pieceEcho_ms);
  return std::equal(echo.begin(), echo.end(), bytes.begin(), bytes.end());
}

} // namespace

bool setForPackets(FtdiPort& port) noexcept
{
  return tell(port, std::array<Control, 4>{ { { Latency, 1 }, { Divisor, forPackets }, { Purge, 1 }, { Purge, 2 } } });
}

std::string loadFalconFirmware(FtdiPort& port, std::span<const std::uint8_t> firmware)
{
  constexpr std::array<std::uint8_t, 1> begin{ 0x41 };
  constexpr std::array<Control, 8> slow{ { { Latency, 16 }, { Divisor, baud9600 }, { Format, eightBits }, { Flow, 0 },
    { Modem, rtsLow }, { Modem, dtrLow }, { Modem, dtrHigh }, { Purge, 1 } } };
  if (!tell(port, slow) || !greets(port))
  {
    return "the device does not greet its loader: unplug its power and plug the power in again";
  }
  if (!tell(port, std::array<Control, 2>{ { { Modem, dtrLow }, { Divisor, baud140000 } } }) || !echoes(port, begin))
  {
    return "the device does not begin to load";
  }
  for (std::size_t at = 0; at < firmware.size(); at += piece)
  {
    if (!echoes(port, firmware.subspan(at, std::min(piece, firmware.size() - at))))
    {
      return "the device echoed other bytes than those of the file at byte " + std::to_string(at) +
             ": unplug its power and plug the power in again";
    }
  }
  return {};
}

} // namespace palpate
