// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>

#include "testing/vm/PluggedStick.h"
#include "testing/vm/UsbPort.h"

namespace palpate::test
{

/// A HID device on a virtual full-speed USB bus: the kernel's usbcore and usbhid. At most one report each way is done
/// in a millisecond, as on a wire, and a device that stalls keeps the host's writes waiting until the kernel gives them
/// up.
class UsbTransport : public PluggedDevice
{
public:
  using PluggedDevice::PluggedDevice;

  /// How often the host has tried to stop all effects while it stalled.
  std::atomic<int> refusedStops = 0;

private:
  void attach() override { this->port_.attach(); }
  void detach() noexcept override;
  void serve(Instant until) override;
  void send(std::span<const std::uint8_t> input) override;
  void frame() override;

  void submit(UsbRequest request);
  void unlink(const UsbRequest& request);
  void control(const UsbRequest& request);
  [[nodiscard]] std::vector<std::uint8_t> answerTo(const UsbRequest& request);

  UsbPort port_;
  std::deque<UsbRequest> outs_, ins_;
  std::deque<std::vector<std::uint8_t>> inputs_;
};

using UsbDevice = PluggedStick<UsbTransport>;

} // namespace palpate::test
