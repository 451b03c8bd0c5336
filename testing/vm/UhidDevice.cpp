// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/UhidDevice.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <linux/input.h>
#include <linux/uhid.h>
#include <poll.h>
#include <unistd.h>

namespace palpate::test
{
namespace
{

/// The kernel's structures are packed, so no reference binds to their members.
void copyText(const std::string& text, __u8* to, std::size_t size)
{
  std::memcpy(to, text.data(), std::min(text.size(), size - 1));
}

bool tell(int file, const uhid_event& event)
{
  ssize_t written = -1;
  do
  {
    written = ::write(file, &event, sizeof event);
  } while (written < 0 && errno == EINTR);
  return written == static_cast<ssize_t>(sizeof event);
}

std::span<const std::uint8_t> bytesAt(const __u8* data, std::size_t size)
{
  return { data, size };
}

HidReportKind kindOf(std::uint8_t type)
{
  return type == UHID_FEATURE_REPORT ? HidReportKind::Feature : HidReportKind::Output;
}

timespec until(PluggedDevice::Instant instant)
{
  const auto left = std::max(instant - std::chrono::steady_clock::now(), std::chrono::steady_clock::duration::zero());
  return { 0, std::min<std::int64_t>(std::chrono::nanoseconds(left).count(), 999999999) };
}

} // namespace

void UhidTransport::attach()
{
  this->file_ = ::open("/dev/uhid", O_RDWR | O_CLOEXEC);
  if (this->file_ < 0)
  {
    throw std::system_error(errno, std::generic_category(), "/dev/uhid");
  }
  const PlugIdentity& is = this->identity();
  uhid_event event{};
  event.type = UHID_CREATE2;
  copyText(is.name, event.u.create2.name, sizeof event.u.create2.name);
  copyText(is.serial, event.u.create2.uniq, sizeof event.u.create2.uniq);
  event.u.create2.bus = BUS_USB;
  event.u.create2.vendor = is.vendor;
  event.u.create2.product = is.product;
  event.u.create2.version = is.release;
  event.u.create2.rd_size = static_cast<__u16>(is.descriptor.size());
  std::copy(is.descriptor.begin(), is.descriptor.end(), event.u.create2.rd_data);
  if (!tell(this->file_, event))
  {
    throw std::system_error(errno, std::generic_category(), "the kernel does not take " + is.name);
  }
}

void UhidTransport::detach() noexcept
{
  uhid_event event{};
  event.type = UHID_DESTROY;
  static_cast<void>(tell(this->file_, event));
  ::close(this->file_);
  this->file_ = -1;
  this->opened_ = false;
}

void UhidTransport::serve(Instant instant)
{
  pollfd waiting{ this->file_, POLLIN, 0 };
  const timespec left = until(instant);
  if (::ppoll(&waiting, this->stalls ? 0 : 1, &left, nullptr) > 0)
  {
    this->answer();
  }
}

void UhidTransport::answer()
{
  uhid_event asked{};
  if (::read(this->file_, &asked, sizeof asked) <= 0)
  {
    return;
  }
  uhid_event reply{};
  switch (asked.type)
  {
    case UHID_OPEN:
    case UHID_CLOSE:
      this->opened_ = asked.type == UHID_OPEN;
      break;
    case UHID_OUTPUT:
      static_cast<void>(this->take(kindOf(asked.u.output.rtype), bytesAt(asked.u.output.data, asked.u.output.size)));
      break;
    case UHID_SET_REPORT:
    {
      const auto& set = asked.u.set_report;
      reply.type = UHID_SET_REPORT_REPLY;
      reply.u.set_report_reply.id = set.id;
      reply.u.set_report_reply.err = this->take(kindOf(set.rtype), bytesAt(set.data, set.size)) ? 0 : EIO;
      static_cast<void>(tell(this->file_, reply));
      break;
    }
    case UHID_GET_REPORT:
    {
      const std::vector<std::uint8_t> bytes = this->feature(asked.u.get_report.rnum);
      reply.type = UHID_GET_REPORT_REPLY;
      reply.u.get_report_reply.id = asked.u.get_report.id;
      reply.u.get_report_reply.err = bytes.empty() ? EIO : 0;
      reply.u.get_report_reply.size = static_cast<__u16>(bytes.size());
      std::copy(bytes.begin(), bytes.end(), reply.u.get_report_reply.data);
      static_cast<void>(tell(this->file_, reply));
      break;
    }
    default:
      break;
  }
}

void UhidTransport::send(std::span<const std::uint8_t> input)
{
  if (!this->opened_)
  {
    return;
  }
  uhid_event event{};
  event.type = UHID_INPUT2;
  event.u.input2.size = static_cast<__u16>(input.size());
  std::copy(input.begin(), input.end(), event.u.input2.data);
  static_cast<void>(tell(this->file_, event));
}

} // namespace palpate::test
