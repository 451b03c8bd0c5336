// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/UsbDevice.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "testing/vm/Ticking.h"

namespace palpate::test
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

const std::string bus = "/sys/devices/platform/vhci_hcd.0/";
constexpr std::uint32_t submitCommand = 1, unlinkCommand = 2, submitted = 3, unlinked = 4;
constexpr std::uint32_t deviceNumber = 0x00010001, fullSpeed = 2;
constexpr std::uint8_t featureType = 3;
constexpr std::size_t longestQueue = 64;

constexpr std::uint8_t low(std::size_t number)
{
  return static_cast<std::uint8_t>(number & 0xFF);
}
constexpr std::uint8_t high(std::size_t number)
{
  return static_cast<std::uint8_t>(number >> 8 & 0xFF);
}

/// A USB string: UTF-16.
Bytes text(const std::string& ascii)
{
  Bytes bytes{ low(2 + 2 * ascii.size()), 3 };
  for (const char c : ascii)
  {
    bytes.push_back(static_cast<std::uint8_t>(c));
    bytes.push_back(0);
  }
  return bytes;
}

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

void UsbTransport::attach()
{
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
  {
    throw std::system_error(errno, std::generic_category(), "socketpair");
  }
  // The port may still be that of a device that was just unplugged.
  const bool taken = waitUntil(
    [&]
    {
      std::ofstream file(bus + "attach");
      file << "0 " << ends[1] << " " << deviceNumber << " " << fullSpeed << std::flush;
      return file.good();
    });
  ::close(ends[1]);
  this->socket_ = ends[0];
  if (!taken)
  {
    ::close(this->socket_);
    throw std::system_error(EIO, std::generic_category(), bus + "attach");
  }
}

void UsbTransport::detach() noexcept
{
  {
    std::ofstream file(bus + "detach");
    file << "0" << std::flush;
  }
  ::shutdown(this->socket_, SHUT_RDWR);
  ::close(this->socket_);
  this->outs_.clear();
  this->ins_.clear();
  this->inputs_.clear();
}

bool UsbTransport::receive(void* to, std::size_t size) const
{
  return size == 0 || ::recv(this->socket_, to, size, MSG_WAITALL) == static_cast<ssize_t>(size);
}

void UsbTransport::serve(Instant until)
{
  const auto left = std::max(until - std::chrono::steady_clock::now(), std::chrono::steady_clock::duration::zero());
  const timespec wait{ 0, std::min<std::int64_t>(std::chrono::nanoseconds(left).count(), 999999999) };
  pollfd waiting{ this->socket_, POLLIN, 0 };
  Header header{};
  Setup setup{};
  if (::ppoll(&waiting, 1, &wait, nullptr) <= 0 || !this->receive(header.data(), sizeof header) ||
      !this->receive(setup.data(), setup.size()))
  {
    return;
  }
  std::transform(header.begin(), header.end(), header.begin(), [](std::uint32_t word) { return ntohl(word); });
  if (header[0] == submitCommand)
  {
    this->submit(header, setup);
  }
  else if (header[0] == unlinkCommand)
  {
    this->unlink(header);
  }
}

void UsbTransport::submit(const Header& header, const Setup& setup)
{
  const bool in = header[3] == 1;
  Bytes data(in ? 0 : header[6]);
  if (!this->receive(data.data(), data.size()))
  {
    return;
  }
  if (header[4] == 0)
  {
    this->control(header, setup, data);
    return;
  }
  if (!in && this->stalls && data == this->identity().stopOrder)
  {
    ++this->refusedStops;
  }
  (in ? this->ins_ : this->outs_).push_back({ header[1], std::move(data) });
}

void UsbTransport::unlink(const Header& header)
{
  std::size_t dropped = 0;
  for (std::deque<Request>* queue : { &this->outs_, &this->ins_ })
  {
    dropped += std::erase_if(*queue, [&](const Request& request) { return request.sequence == header[5]; });
  }
  this->reply(unlinked, header[1], dropped > 0 ? -ECONNRESET : 0, 0);
}

void UsbTransport::frame()
{
  if (!this->outs_.empty() && !this->stalls)
  {
    const Request request = std::move(this->outs_.front());
    this->outs_.pop_front();
    static_cast<void>(this->take(HidReportKind::Output, request.report));
    this->reply(submitted, request.sequence, 0, request.report.size());
  }
  if (!this->ins_.empty() && !this->inputs_.empty())
  {
    this->reply(submitted, this->ins_.front().sequence, 0, this->inputs_.front().size(), this->inputs_.front());
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

void UsbTransport::reply(std::uint32_t command, std::uint32_t sequence, int status, std::size_t length,
  std::span<const std::uint8_t> data) const
{
  std::array<std::uint32_t, 12> words{ command, sequence, 0, 0, 0, static_cast<std::uint32_t>(status),
    static_cast<std::uint32_t>(length) };
  std::transform(words.begin(), words.end(), words.begin(), [](std::uint32_t word) { return htonl(word); });
  Bytes message(sizeof words);
  std::copy_n(reinterpret_cast<const std::uint8_t*>(words.data()), sizeof words, message.begin());
  message.insert(message.end(), data.begin(), data.end());
  static_cast<void>(::send(this->socket_, message.data(), message.size(), MSG_NOSIGNAL));
}

void UsbTransport::control(const Header& header, const Setup& setup, std::span<const std::uint8_t> data)
{
  const std::uint8_t requestType = setup[0], request = setup[1], valueLow = setup[2], valueHigh = setup[3];
  const bool standard = (requestType & 0x60) == 0, in = (requestType & 0x80) != 0;
  const HidReportKind kind = valueHigh == featureType ? HidReportKind::Feature : HidReportKind::Output;
  Bytes answer;
  bool good = !in;
  if (in)
  {
    answer = standard && request == 6   ? this->described(valueHigh, valueLow)
             : standard && request == 0 ? Bytes{ 0, 0 }
             : request == 1             ? this->feature(valueLow)
                                        : Bytes{};
    good = !answer.empty();
    answer.resize(std::min<std::size_t>(answer.size(), header[6]));
  }
  else if (!standard && request == 9)
  {
    good = this->take(kind, data);
  }
  this->reply(submitted, header[1], good ? 0 : -EPIPE, in ? answer.size() : data.size(), answer);
}

std::vector<std::uint8_t> UsbTransport::described(std::uint8_t type, std::uint8_t index) const
{
  const PlugIdentity& is = this->identity();
  switch (type)
  {
    case 1:
      return { 18, 1, 0x00, 0x02, 0, 0, 0, 64, low(is.vendor), high(is.vendor), low(is.product), high(is.product),
        low(is.release), high(is.release), 1, 2, 3, 1 };
    case 2:
      return configuration(is.descriptor.size());
    case 3:
      return index == 0   ? Bytes{ 4, 3, 0x09, 0x04 }
             : index == 3 ? text(is.serial)
             : index == 2 ? text(is.name)
                          : text("Palpate");
    case 0x21:
      return hidDescriptor(is.descriptor.size());
    case 0x22:
      return is.descriptor;
    default:
      return {};
  }
}

} // namespace palpate::test
