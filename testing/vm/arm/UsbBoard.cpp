// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/arm/UsbBoard.h"

#include <algorithm>

namespace palpate::test
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t bulk = 2; ///< endpoints up to it carry the bytes

/// Endpoint 2 out and 1 in, packets of 64 bytes.
constexpr std::array<std::uint8_t, 14> bulkEndpoints{ 7, 5, 0x02, 2, 64, 0, 0, 7, 5, 0x81, 2, 64, 0, 0 };

/// A configuration of these descriptors.
Bytes configurationOf(std::uint8_t interfaces, const Bytes& rest)
{
  const std::size_t length = 9 + rest.size() + bulkEndpoints.size();
  Bytes all;
  all.reserve(length);
  all.insert(all.end(), { 9, 2, low(length), high(length), interfaces, 1, 0, 0x80, 50 });
  all.insert(all.end(), rest.begin(), rest.end());
  all.insert(all.end(), bulkEndpoints.begin(), bulkEndpoints.end());
  return all;
}

/// One interface of its maker's.
Bytes chipConfiguration()
{
  return configurationOf(1, { 9, 4, 0, 0, 2, 0xFF, 0xFF, 0xFF, 0 });
}

/// A modem's: one interface to talk about the line, one for its bytes (USB CDC 1.2, PSTN subclass).
Bytes lineConfiguration()
{
  return configurationOf(
    2, { 9, 4, 0, 0, 1, 2, 2, 1, 0,                      // about the line
         5, 0x24, 0x00, 0x10, 0x01, 5, 0x24, 0x01, 0, 1, // of release 1.1; calls are managed by nobody
         4, 0x24, 0x02, 2, 5, 0x24, 0x06, 0, 1,          // it has a rate, and these two belong together
         7, 5, 0x83, 3, 8, 0, 16,                        // never tells anything
         9, 4, 1, 0, 2, 0x0A, 0, 0, 0 });
}

bool isStandard(const UsbRequest& request)
{
  return (request.setup[0] & 0x60) == 0;
}

} // namespace

void UsbBoard::detach() noexcept
{
  this->port_.detach();
  this->outs_.clear();
  this->ins_.clear();
  this->others_.clear();
}

void UsbBoard::serve(Instant until)
{
  std::optional<UsbRequest> request = this->port_.next(until);
  if (!request)
  {
    return;
  }
  if (request->unlinks != 0)
  {
    std::size_t dropped = 0;
    for (std::deque<UsbRequest>* queue : { &this->outs_, &this->ins_, &this->others_ })
    {
      dropped += std::erase_if(*queue, [&](const UsbRequest& one) { return one.sequence == request->unlinks; });
    }
    this->port_.unlinked(*request, dropped > 0);
  }
  else if (request->endpoint == 0)
  {
    this->control(*request);
  }
  else
  {
    this->submit(std::move(*request));
  }
}

void UsbBoard::submit(UsbRequest request)
{
  std::deque<UsbRequest>& queue = request.endpoint > bulk ? this->others_ : request.in ? this->ins_ : this->outs_;
  queue.push_back(std::move(request));
  this->flush(false);
}

void UsbBoard::control(const UsbRequest& request)
{
  if (isStandard(request) && request.in)
  {
    const Bytes answer = standardAnswer(request, this->identity_, this->identity_.descriptor);
    this->port_.done(request, !answer.empty(), answer);
    return;
  }
  this->port_.done(request, isStandard(request) || this->still([&] { return this->order(request); }));
}

void UsbBoard::flush(bool millisecondIsOver)
{
  while (!this->outs_.empty() && !this->stalls)
  {
    this->still([this] { this->take(this->outs_.front().data); });
    this->port_.done(this->outs_.front(), true);
    this->outs_.pop_front();
  }
  while (!this->ins_.empty())
  {
    const std::optional<Bytes> given = this->still([&] { return this->give(millisecondIsOver); });
    if (!given)
    {
      return;
    }
    this->port_.done(this->ins_.front(), true, *given);
    this->ins_.pop_front();
    millisecondIsOver = false;
  }
}

void UsbBoard::passMillisecond()
{
  this->flush(true);
}

UsbFalcon::UsbFalcon(std::string serial)
  : UsbBoard({ "Falcon HAPTIC", std::move(serial), 0x0403, 0xCB48, 0x0600, chipConfiguration() })
{
}

bool UsbFalcon::order(const UsbRequest& request)
{
  constexpr std::uint8_t toChip = 0x40;
  const auto value = static_cast<std::uint16_t>(request.setup[2] | request.setup[3] << 8);
  return request.setup[0] == toChip && this->chip_.control(request.setup[1], value);
}

/// The chip answers after its latency, whatever it has by then.
std::optional<std::vector<std::uint8_t>> UsbFalcon::give(bool millisecondIsOver)
{
  const int latency_ms = this->chip_.latency_ms();
  this->awaited_ms_ += millisecondIsOver ? 1 : 0;
  if (!millisecondIsOver || this->awaited_ms_ < latency_ms)
  {
    return std::nullopt;
  }
  this->awaited_ms_ = 0;
  Bytes packet(64);
  packet.resize(static_cast<std::size_t>(std::max(0, this->chip_.read(packet, latency_ms + 1))));
  return packet;
}

UsbTwoDiy::UsbTwoDiy(std::string serial)
  : UsbBoard({ "Arduino Due", std::move(serial), 0x2341, 0x003E, 0x0100, lineConfiguration() })
{
}

bool UsbTwoDiy::order(const UsbRequest& request)
{
  constexpr std::uint8_t toInterface = 0x21, setRate = 0x20, setLines = 0x22;
  return request.setup[0] == toInterface && (request.setup[1] == setRate || request.setup[1] == setLines);
}

std::optional<std::vector<std::uint8_t>> UsbTwoDiy::give(bool /*millisecondIsOver*/)
{
  if (this->model_.said.empty())
  {
    return std::nullopt;
  }
  const std::size_t count = std::min<std::size_t>(64, this->model_.said.size());
  const auto end = this->model_.said.begin() + static_cast<std::ptrdiff_t>(count);
  const Bytes packet(this->model_.said.begin(), end);
  this->model_.said.erase(this->model_.said.begin(), end);
  return packet;
}

} // namespace palpate::test
