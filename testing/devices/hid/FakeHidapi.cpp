// SPDX-License-Identifier: GPL-3.0-or-later
// hidapi's functions over a bus of virtual devices, as the library behaves on Linux: it lists a device once for each of
// its collections, takes reports that the device does not know without a word, and knows no report descriptors.
#include "testing/devices/hid/FakeHidapi.h"

#include <hidapi/hidapi.h>

/// The target of hidapi's handle.
struct hid_device_
{
  std::unique_ptr<palpate::HidConnection> connection;
  std::wstring error;
};

namespace palpate::test
{
namespace
{

constexpr int collections = 24;

FakeHidBus*& theBus() noexcept
{
  static FakeHidBus* bus = nullptr;
  return bus;
}

wchar_t* copyWide(const std::string& text)
{
  auto* const wide = new wchar_t[text.size() + 1]{};
  std::copy(text.begin(), text.end(), wide);
  return wide;
}

hid_device_info* listed(const HidEntry& entry, hid_device_info* next)
{
  auto* const info = new hid_device_info{};
  info->path = new char[entry.path.size() + 1]{};
  entry.path.copy(info->path, entry.path.size());
  info->vendor_id = entry.vendor;
  info->product_id = entry.product;
  info->serial_number = copyWide(entry.serial);
  info->product_string = copyWide(entry.name);
  info->next = next;
  return info;
}

} // namespace

FakeHidapi::FakeHidapi(FakeHidBus& bus) noexcept
{
  theBus() = &bus;
}

FakeHidapi::~FakeHidapi()
{
  theBus() = nullptr;
}

} // namespace palpate::test

using palpate::test::theBus;

extern "C"
{
  int hid_init(void)
  {
    return 0;
  }

  int hid_exit(void)
  {
    return 0;
  }

  hid_device_info* hid_enumerate(unsigned short, unsigned short)
  {
    hid_device_info* all = nullptr;
    for (const palpate::HidEntry& entry : theBus()->devices())
    {
      for (int i = 0; i < palpate::test::collections; ++i)
      {
        all = palpate::test::listed(entry, all);
      }
    }
    return all;
  }

  void hid_free_enumeration(hid_device_info* all)
  {
    while (all != nullptr)
    {
      hid_device_info* const next = all->next;
      delete[] all->path;
      delete[] all->serial_number;
      delete[] all->product_string;
      delete all;
      all = next;
    }
  }

  hid_device* hid_open_path(const char* path)
  {
    palpate::HidEntry entry;
    entry.path = path;
    palpate::HidBus::Opened opened = theBus()->open(entry);
    return opened.value == nullptr ? nullptr : new hid_device_{ std::move(opened.value), {} };
  }

  void hid_close(hid_device* device)
  {
    delete device;
  }

  int hid_write(hid_device* device, const unsigned char* data, std::size_t length)
  {
    return device->connection->write({ data, length }) ? static_cast<int>(length) : -1;
  }

  int hid_read_timeout(hid_device* device, unsigned char* data, std::size_t length, int timeout_ms)
  {
    return device->connection->read({ data, length }, timeout_ms);
  }

  int hid_send_feature_report(hid_device* device, const unsigned char* data, std::size_t length)
  {
    return device->connection->setFeature({ data, length }) ? static_cast<int>(length) : -1;
  }

  int hid_get_feature_report(hid_device* device, unsigned char* data, std::size_t length)
  {
    return device->connection->getFeature({ data, length });
  }

  const wchar_t* hid_error(hid_device* device)
  {
    const std::string text = device->connection->error();
    device->error.assign(text.begin(), text.end());
    return device->error.c_str();
  }
}
