// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that knows libusb.
#include "devices/arm/link/FtdiPort.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <libusb-1.0/libusb.h>
#include <unistd.h>

#include "devices/hid/HidapiBus.h"

namespace palpate
{
namespace
{

constexpr unsigned wait_ms = 50;
constexpr int firstInterface = 0;
constexpr std::uint8_t toVendor = 0x40;

/// A file of the system's, libusb's context and its handle on that file: nothing is searched for, and the file can be
/// handed to a guard.
class LibusbFtdi final : public FtdiPort
{
public:
  explicit LibusbFtdi(int file) noexcept : file_(file) {}
  ~LibusbFtdi() override
  {
    if (this->device_ != nullptr)
    {
      libusb_release_interface(this->device_, firstInterface);
      libusb_close(this->device_);
    }
    if (this->context_ != nullptr)
    {
      libusb_exit(this->context_);
    }
    ::close(this->file_);
  }
  LibusbFtdi(const LibusbFtdi&) = delete;
  LibusbFtdi& operator=(const LibusbFtdi&) = delete;

  /// 0, or libusb's number for the reason.
  [[nodiscard]] int begin() noexcept
  {
    libusb_set_option(nullptr, LIBUSB_OPTION_NO_DEVICE_DISCOVERY);
    int failed = libusb_init(&this->context_);
    failed = failed == 0 ? libusb_wrap_sys_device(this->context_, this->file_, &this->device_) : failed;
    if (failed != 0)
    {
      return failed;
    }
    libusb_set_auto_detach_kernel_driver(this->device_, 1);
    return libusb_claim_interface(this->device_, firstInterface);
  }

  bool control(std::uint8_t request, std::uint16_t value) noexcept override
  {
    this->failed_ = libusb_control_transfer(this->device_, toVendor, request, value, 0, nullptr, 0, wait_ms);
    return this->failed_ >= 0;
  }
  bool write(std::span<const std::uint8_t> bytes) noexcept override
  {
    int written = 0;
    // libusb takes bytes that it may change for either way; it does not change those that go out.
    auto* const data = const_cast<std::uint8_t*>(bytes.data());
    const auto count = static_cast<int>(bytes.size());
    this->failed_ = libusb_bulk_transfer(this->device_, out, data, count, &written, wait_ms);
    return this->failed_ == 0 && written == count;
  }
  int read(std::span<std::uint8_t> bytes, int timeout_ms) noexcept override
  {
    int count = 0;
    // To libusb no time at all means for ever.
    this->failed_ = libusb_bulk_transfer(this->device_, in, bytes.data(), static_cast<int>(bytes.size()), &count,
      static_cast<unsigned>(std::max(1, timeout_ms)));
    return this->failed_ == 0 || this->failed_ == LIBUSB_ERROR_TIMEOUT ? count : -1;
  }
  std::string error() const override { return libusb_strerror(this->failed_); }
  int handle() const noexcept override { return this->file_; }

private:
  int file_;
  libusb_context* context_ = nullptr;
  libusb_device_handle* device_ = nullptr;
  int failed_ = 0;
};

} // namespace

std::string ftdiAbsence()
{
  return {};
}

Outcome<std::unique_ptr<FtdiPort>> openFtdi(const std::string& path)
{
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0)
  {
    return { nullptr, openProblem(path, errno) };
  }
  auto port = std::make_unique<LibusbFtdi>(file);
  const int failed = port->begin();
  if (failed == LIBUSB_ERROR_BUSY)
  {
    return { nullptr, openProblem(path, EBUSY) };
  }
  if (failed != 0)
  {
    return { nullptr, path + " cannot be used: " + libusb_strerror(failed) };
  }
  return { std::move(port), {} };
}

} // namespace palpate
