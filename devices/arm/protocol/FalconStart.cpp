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
constexpr int latency_ms = 16; ///< of the chip while it loads
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

/// A chip and the time that its echoes are waited for.
class Echoes
{
public:
  Echoes(FtdiPort& port, const Clock& clock) : port_(port), clock_(clock) {}

  [[nodiscard]] bool write(std::span<const std::uint8_t> bytes) { return this->port_.write(bytes); }

  /// Reads until there are so many bytes or that time has passed. The chip answers after its latency also where it has
  /// nothing; a transfer that is given up before may lose its bytes.
  [[nodiscard]] std::vector<std::uint8_t> heard(std::size_t length, int longest_ms)
  {
    constexpr int ownBytes = 2, most = 64, patience_ms = latency_ms + 4;
    std::vector<std::uint8_t> all;
    const std::int64_t until_ns = this->clock_.now_ns() + longest_ms * perMs_ns;
    while (all.size() < length && this->clock_.now_ns() < until_ns)
    {
      std::array<std::uint8_t, most> transfer;
      const int count = this->port_.read(transfer, patience_ms);
      if (count < 0)
      {
        return {};
      }
      all.insert(all.end(), transfer.begin() + std::min(count, ownBytes), transfer.begin() + count);
    }
    return all;
  }

private:
  FtdiPort& port_;
  const Clock& clock_;
};

/// A 0 may come first.
bool greets(Echoes& echoes)
{
  for (int i = 0; i < attempts; ++i)
  {
    if (!echoes.write(greeting))
    {
      return false;
    }
    std::vector<std::uint8_t> answer = echoes.heard(greeted.size(), greetingEcho_ms);
    if (!answer.empty() && answer.front() == 0)
    {
      answer.erase(answer.begin());
      const std::vector<std::uint8_t> rest = echoes.heard(greeted.size() - answer.size(), greetingEcho_ms);
      answer.insert(answer.end(), rest.begin(), rest.end());
    }
    if (std::equal(answer.begin(), answer.end(), greeted.begin(), greeted.end()))
    {
      return true;
    }
  }
  return false;
}

bool comesBack(Echoes& echoes, std::span<const std::uint8_t> bytes)
{
  if (!echoes.write(bytes))
  {
    return false;
  }
  const std::vector<std::uint8_t> echo = echoes.heard(bytes.size(), pieceEcho_ms);
  return std::equal(echo.begin(), echo.end(), bytes.begin(), bytes.end());
}

} // namespace

bool setForPackets(FtdiPort& port) noexcept
{
  return tell(port, std::array<Control, 4>{ { { Latency, 1 }, { Divisor, forPackets }, { Purge, 1 }, { Purge, 2 } } });
}

std::string loadFalconFirmware(FtdiPort& port, std::span<const std::uint8_t> firmware, const Clock& clock)
{
  constexpr std::array<std::uint8_t, 1> begin{ 0x41 };
  constexpr std::array<Control, 8> slow{ { { Latency, latency_ms }, { Divisor, baud9600 }, { Format, eightBits },
    { Flow, 0 }, { Modem, rtsLow }, { Modem, dtrLow }, { Modem, dtrHigh }, { Purge, 1 } } };
  Echoes echoes(port, clock);
  if (!tell(port, slow) || !greets(echoes))
  {
    return "the device does not greet its loader: unplug its power and plug the power in again";
  }
  if (!tell(port, std::array<Control, 2>{ { { Modem, dtrLow }, { Divisor, baud140000 } } }) ||
      !comesBack(echoes, begin))
  {
    return "the device does not begin to load";
  }
  for (std::size_t at = 0; at < firmware.size(); at += piece)
  {
    if (!comesBack(echoes, firmware.subspan(at, std::min(piece, firmware.size() - at))))
    {
      return "the device echoed other bytes than those of the file at byte " + std::to_string(at) +
             ": unplug its power and plug the power in again";
    }
  }
  return {};
}

} // namespace palpate
