// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that knows hidapi.
#include "devices/hid/HidapiBus.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <mutex>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <hidapi/hidapi.h>
#include <unistd.h>

#include "devices/common/AttributeFile.h"

namespace palpate
{
namespace
{

/// UTF-8 of the wide strings that hidapi gives; numbers that are no characters are left out.
std::string narrow(const wchar_t* wide)
{
  std::string text;
  for (; wide != nullptr && *wide != L'\0'; ++wide)
  {
    const auto code = static_cast<std::uint32_t>(*wide);
    if (code >= 0x20 && code < 0x7F)
    {
      text += static_cast<char>(code);
    }
    else if (code >= 0x80 && code < 0x800)
    {
      text += static_cast<char>(0xC0 | code >> 6);
      text += static_cast<char>(0x80 | (code & 0x3F));
    }
    else if (code >= 0x800 && code < 0x10000)
    {
      text += static_cast<char>(0xE0 | code >> 12);
      text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
      text += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  return text;
}

class HidapiConnection final : public HidConnection
{
public:
  explicit HidapiConnection(hid_device* device) noexcept : device_(device) {}
  ~HidapiConnection() override { hid_close(this->device_); }
  HidapiConnection(const HidapiConnection&) = delete;
  HidapiConnection& operator=(const HidapiConnection&) = delete;

  int read(std::span<std::uint8_t> report, int timeout_ms) noexcept override
  {
    return hid_read_timeout(this->device_, report.data(), report.size(), timeout_ms);
  }

  bool write(std::span<const std::uint8_t> report) noexcept override
  {
    return hid_write(this->device_, report.data(), report.size()) == static_cast<int>(report.size());
  }

  bool setFeature(std::span<const std::uint8_t> report) noexcept override
  {
    return hid_send_feature_report(this->device_, report.data(), report.size()) >= 0;
  }

  int getFeature(std::span<std::uint8_t> report) noexcept override
  {
    return hid_get_feature_report(this->device_, report.data(), report.size());
  }

  std::string error() const override { return narrow(hid_error(this->device_)); }

  void wait(int duration_ms) noexcept override { std::this_thread::sleep_for(std::chrono::milliseconds(duration_ms)); }

private:
  hid_device* device_;
};

class HidapiBus final : public HidBus
{
public:
  explicit HidapiBus(std::string sysfs) : sysfs_(std::move(sysfs)) { hid_init(); }
  ~HidapiBus() override { hid_exit(); }
  HidapiBus(const HidapiBus&) = delete;
  HidapiBus& operator=(const HidapiBus&) = delete;

  std::vector<HidEntry> devices() override
  {
    const std::lock_guard lock(this->mutex_);
    std::vector<HidEntry> found;
    hid_device_info* const all = hid_enumerate(0, 0);
    for (const hid_device_info* one = all; one != nullptr; one = one->next)
    {
      // Some versions list a device once for each of its collections.
      const bool known =
        std::any_of(found.begin(), found.end(), [one](const HidEntry& entry) { return entry.path == one->path; });
      if (!known)
      {
        found.push_back({ one->path, one->vendor_id, one->product_id, narrow(one->serial_number),
          narrow(one->product_string), HidUsage{ one->usage_page } << 16U | one->usage });
      }
    }
    hid_free_enumeration(all);
    return found;
  }

  /// From sysfs, which everybody may read: hidapi itself gives it only from version 0.14 on, and only to users who may
  /// open the device.
  Descriptor descriptor(const HidEntry& entry) override
  {
    const std::string node = entry.path.substr(entry.path.rfind('/') + 1);
    const std::string file = this->sysfs_ + "/" + node + "/device/report_descriptor";
    const std::string bytes = contentOf(file);
    Descriptor read;
    read.value.assign(bytes.begin(), bytes.end());
    if (read.value.empty())
    {
      read.problem = file + " cannot be read";
    }
    return read;
  }

  Opened open(const HidEntry& entry) override
  {
    const std::lock_guard lock(this->mutex_);
    if (hid_device* const device = hid_open_path(entry.path.c_str()))
    {
      return { std::make_unique<HidapiConnection>(device), {} };
    }
    // hidapi has only words; the system's own number says which cure helps.
    const int again = ::open(entry.path.c_str(), O_RDWR | O_CLOEXEC);
    const int reason = again < 0 ? errno : EIO;
    if (again >= 0)
    {
      ::close(again);
    }
    return { nullptr, openProblem(entry.path, reason) };
  }

private:
  std::string sysfs_;
  std::mutex mutex_; ///< hidapi's own lists are not made for two threads
};

} // namespace

std::shared_ptr<HidBus> systemHidBus(const std::string& sysfs)
{
  return std::make_shared<HidapiBus>(sysfs);
}

std::string openProblem(const std::string& path, int systemError)
{
  switch (systemError)
  {
    case EACCES:
    case EPERM:
      return "no permission to use " + path +
             ": copy devices/udev/70-palpate.rules to /etc/udev/rules.d/, see that it has a line for this device, and "
             "plug the device in again";
    case EBUSY:
      return path + " is busy: close the other program that uses it";
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return path + " is gone: plug the device in again";
    default:
      return path + " cannot be opened: " + std::strerror(systemError);
  }
}

} // namespace palpate
