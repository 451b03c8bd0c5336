// SPDX-License-Identifier: GPL-3.0-or-later
// libusb's functions over a chip that is made up, as far as devices/arm/link/LibusbFtdi.cpp calls them.
#include "testing/devices/arm/FakeLibusb.h"

#include <chrono>
#include <thread>
#include <utility>

#include <libusb-1.0/libusb.h>

/// The targets of libusb's handles.
struct libusb_context
{
};
struct libusb_device_handle
{
};

namespace palpate::test
{
namespace
{

FakeLibusb*& theChip() noexcept
{
  static FakeLibusb* chip = nullptr;
  return chip;
}

libusb_context theContext;
libusb_device_handle theHandle;

} // namespace

FakeLibusb::FakeLibusb(FtdiPort& chip) noexcept : chip_(chip)
{
  theChip() = this;
}

FakeLibusb::~FakeLibusb()
{
  theChip() = nullptr;
}

bool FakeLibusb::claim()
{
  return this->alone([this](FtdiPort&) { return !std::exchange(this->claimed_, true); });
}

} // namespace palpate::test

using palpate::FtdiPort;
using palpate::test::theChip;

extern "C"
{
  int libusb_set_option(libusb_context*, libusb_option, ...)
  {
    return 0;
  }

  int libusb_init(libusb_context** context)
  {
    *context = &palpate::test::theContext;
    return 0;
  }

  void libusb_exit(libusb_context*) {}

  int libusb_wrap_sys_device(libusb_context*, std::intptr_t, libusb_device_handle** device)
  {
    *device = &palpate::test::theHandle;
    theChip()->open();
    return 0;
  }

  void libusb_close(libusb_device_handle*) {}

  int libusb_set_auto_detach_kernel_driver(libusb_device_handle*, int)
  {
    return 0;
  }

  int libusb_claim_interface(libusb_device_handle*, int)
  {
    return theChip()->claim() ? 0 : LIBUSB_ERROR_BUSY;
  }

  int libusb_release_interface(libusb_device_handle*, int)
  {
    theChip()->release();
    return 0;
  }

  int libusb_control_transfer(libusb_device_handle*, std::uint8_t, std::uint8_t request, std::uint16_t value,
    std::uint16_t, unsigned char*, std::uint16_t, unsigned)
  {
    return theChip()->alone([&](FtdiPort& chip) { return chip.control(request, value) ? 0 : LIBUSB_ERROR_NO_DEVICE; });
  }

  int libusb_bulk_transfer(libusb_device_handle*, unsigned char endpoint, unsigned char* data, int length,
    int* transferred, unsigned timeout_ms)
  {
    constexpr int ownBytes = 2;
    const auto size = static_cast<std::size_t>(length);
    int count = 0;
    theChip()->alone(
      [&](FtdiPort& chip)
      {
        count = endpoint == FtdiPort::in     ? chip.read({ data, size }, static_cast<int>(timeout_ms))
                : chip.write({ data, size }) ? length
                                             : -1;
      });
    if (endpoint == FtdiPort::in && count == ownBytes)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    *transferred = count < 0 ? 0 : count;
    return count < 0 ? LIBUSB_ERROR_NO_DEVICE : 0;
  }

  const char* libusb_strerror(int)
  {
    return "No such device";
  }
}
