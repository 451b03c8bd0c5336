// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/core/HapticDevice.h"

namespace palpate::test
{

/// The common part of devices that tests make up: it opens and closes, and that is all.
class BareDevice : public HapticDevice
{
public:
  BareDevice(const std::string& name, bool simulated)
  {
    this->info_.name = name;
    this->info_.simulated = simulated;
  }
  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override { return {}; }
  void close() noexcept override {}

private:
  DeviceInfo info_;
};

} // namespace palpate::test
