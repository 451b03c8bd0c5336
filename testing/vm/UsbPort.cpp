// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/UsbPort.h"

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
using Header = std::array<std::uint32_t, 10>;

const std::string bus = "/sys/devices/platform/vhci_hcd.0/";
constexpr std::uint32_t submitCommand = 1, unlinkCommand = 2, submitted = 3, unlinkedReply = 4;
constexpr std::uint32_t deviceNumber = 0x00010001, fullSpeed = 2;

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

Bytes descriptorOf(
  const PlugIdentity& is, const std::vector<std::uint8_t>& configuration, std::uint8_t type, std::uint8_t index)
{
  switch (type)
  {
    case 1:
      return { 18, 1, 0x00, 0x02, 0, 0, 0, 64, low(is.vendor), high(is.vendor), low(is.product), high(is.product),
        low(is.release), high(is.release), 1, 2, 3, 1 };
    case 2:
      return configuration;
    case 3:
      return index == 0   ? Bytes{ 4, 3, 0x09, 0x04 }
             : index == 3 ? text(is.serial)
             : index == 2 ? text(is.name)
                          : text("Palpate");
    default:
      return {};
  }
}

} // namespace

std::vector<std::uint8_t> standardAnswer(
  const UsbRequest& request, const PlugIdentity& is, const std::vector<std::uint8_t>& configuration)
{
  constexpr std::uint8_t getStatus = 0, getDescriptor = 6;
  const std::uint8_t asked = request.setup[1];
  return asked == getDescriptor ? descriptorOf(is, configuration, request.setup[3], request.setup[2])
         : asked == getStatus   ? Bytes{ 0, 0 }
                                : Bytes{};
}

void UsbPort::attach()
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

void UsbPort::detach() noexcept
{
  {
    std::ofstream file(bus + "detach");
    file << "0" << std::flush;
  }
  ::shutdown(this->socket_, SHUT_RDWR);
  ::close(this->socket_);
}

bool UsbPort::receive(void* to, std::size_t size) const
{
  return size == 0 || ::recv(this->socket_, to, size, MSG_WAITALL) == static_cast<ssize_t>(size);
}

std::optional<UsbRequest> UsbPort::next(RunningDevice::Instant until) const
{
  const auto left = std::max(until - std::chrono::steady_clock::now(), std::chrono::steady_clock::duration::zero());
  const timespec wait{ 0, std::min<std::int64_t>(std::chrono::nanoseconds(left).count(), 999999999) };
  pollfd waiting{ this->socket_, POLLIN, 0 };
  Header header{};
  UsbRequest request;
  if (::ppoll(&waiting, 1, &wait, nullptr) <= 0 || !this->receive(header.data(), sizeof header) ||
      !this->receive(request.setup.data(), request.setup.size()))
  {
    return std::nullopt;
  }
  std::transform(header.begin(), header.end(), header.begin(), [](std::uint32_t word) { return ntohl(word); });
  request.sequence = header[1];
  if (header[0] == unlinkCommand)
  {
    request.unlinks = header[5];
    return request;
  }
  request.in = header[3] == 1;
  request.endpoint = header[4];
  request.length = header[6];
  request.data.resize(request.in ? 0 : request.length);
  const bool whole = header[0] == submitCommand && this->receive(request.data.data(), request.data.size());
  return whole ? std::optional(request) : std::nullopt;
}

void UsbPort::done(const UsbRequest& request, bool good, std::span<const std::uint8_t> in) const
{
  const std::span<const std::uint8_t> fits = in.first(std::min<std::size_t>(in.size(), request.length));
  this->reply(submitted, request.sequence, good ? 0 : -EPIPE, request.in ? fits.size() : request.data.size(), fits);
}

void UsbPort::unlinked(const UsbRequest& request, bool waited) const
{
  this->reply(unlinkedReply, request.sequence, waited ? -ECONNRESET : 0, 0);
}

void UsbPort::reply(std::uint32_t command, std::uint32_t sequence, int status, std::size_t length,
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

} // namespace palpate::test
