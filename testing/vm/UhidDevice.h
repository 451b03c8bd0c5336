// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "testing/vm/PluggedStick.h"

namespace palpate::test
{

/// A device behind /dev/uhid: the kernel's own HID layer without any bus. A write of the host is only put in a queue
/// there, so a device that stalls is not noticed by writing; a feature that is not answered costs the host 5 s.
class UhidTransport : public PluggedDevice
{
public:
  using PluggedDevice::PluggedDevice;

private:
  void attach() override;
  void detach() noexcept override;
  void serve(Instant until) override;
  void send(std::span<const std::uint8_t> input) override;
  void answer();

  int file_ = -1;
  bool opened_ = false; ///< a program has it open: only then does the kernel take input
};

using UhidDevice = PluggedStick<UhidTransport>;

} // namespace palpate::test
