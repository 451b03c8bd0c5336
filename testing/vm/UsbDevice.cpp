// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/UsbDevice.h"

#include <utility>

namespace palpate::test
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t featureType = 3;
constexpr std::size_t longestQueue = 64;

Bytes hidDescriptor(std::size_t reportSize)
{
  return { 9, 0x21, 0x11, 0x01, 0, 1, 0x22, low(reportSize), high(reportSize) };
}

/// One interface with a report of 64 bytes each way a millisecond.
Bytes configuration(std::size_t reportSize)
{
  Bytes bytes{ 9, 2, 41, 0, 1, 1, 0, 0x80, 50, 9, 4, 0, 0, 2, 3, 0, 0, 0 };
  const Bytes hid = hidDescriptor(reportSize);
  bytes.insert(bytes.end(), hid.begin(), hid.end());
  for (const std::uint8_t endpoint : { 0x81, 0x02 })
  {
    bytes.insert(bytes.end(), { 7, 5, endpoint, 3, 64, 0, 1 });
  }
  return bytes;
}

} // namespace

void UsbTransport::detach() noexcept
{
  this->port_.detach();
  this->outs_.clear();
  this->ins_.clear();
  this->inputs_.clear();
}

void UsbTransport::serve(Instant until)
{
  std::optional<UsbRequest> request = this->port_.next(until);
  if (!request)
  {
    return;
  }
  if (request->unlinks != 0)
  {
    this->unlink(*request);
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

void UsbTransport::submit(UsbRequest request)
{
  if (!request.in && this->stalls && request.data == this->identity().stopOrder)
  {
    ++this->refusedStops;
  }
  (request.in ? this->ins_ : this->outs_).push_back(std::move(request));
}

void UsbTransport::unlink(const UsbRequest& request)
{
  std::size_t dropped = 0;
  for (std::deque<UsbRequest>* queue : { &this->outs_, &this->ins_ })
  {
    dropped += std::erase_if(*queue, [&](const UsbRequest& waiting) { return waiting.sequence == request.unlinks; });
  }
  this->port_.unlinked(request, dropped > 0);
}

void UsbTransport::frame()
{
  if (!this->outs_.empty() && !this->stalls)
  {
    const UsbRequest request = std::move(this->outs_.front());
    this->outs_.pop_front();
    static_cast<void>(this->take(HidReportKind::Output, request.data));
    this->port_.done(request, true);
  }
  if (!this->ins_.empty() && !this->inputs_.empty())
  {
    this->port_.done(this->ins_.front(), true, this->inputs_.front());
    this->ins_.pop_front();
    this->inputs_.pop_front();
  }
}

void UsbTransport::send(std::span<const std::uint8_t> input)
{
  this->inputs_.emplace_back(input.begin(), input.end());
  if (this->inputs_.size() > longestQueue)
  {
    this->inputs_.pop_front();
  }
}

void UsbTransport::control(const UsbRequest& request)
{
  constexpr std::uint8_t setReport = 9;
  const bool standard = (request.setup[0] & 0x60) == 0;
  if (request.in)
  {
    const Bytes answer = this->answerTo(request);
    this->port_.done(request, !answer.empty(), answer);
    return;
  }
  const HidReportKind kind = request.setup[3] == featureType ? HidReportKind::Feature : HidReportKind::Output;
  this->port_.done(request, standard || request.setup[1] != setReport || this->take(kind, request.data));
}

std::vector<std::uint8_t> UsbTransport::answerTo(const UsbRequest& request)
{
  constexpr std::uint8_t getDescriptor = 6, getReport = 1;
  const std::vector<std::uint8_t>& report = this->identity().descriptor;
  const bool standard = (request.setup[0] & 0x60) == 0;
  if (!standard)
  {
    return request.setup[1] == getReport ? this->feature(request.setup[2]) : Bytes{};
  }
  if (request.setup[1] == getDescriptor && request.setup[3] == 0x21)
  {
    return hidDescriptor(report.size());
  }
  return request.setup[1] == getDescriptor && request.setup[3] == 0x22
           ? report
           : standardAnswer(request, this->identity(), configuration(report.size()));
}

} // namespace palpate::test
