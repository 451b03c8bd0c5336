// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <deque>

#include "testing/vm/PluggedStick.h"

namespace palpate::test
{

/// A device on a virtual full-speed USB bus: the kernel's usbcore and usbhid on one end of a socket, the usbip
/// protocol on it, this device at the other. At most one report each way is done in a millisecond, as on a wire, and a
/// device that stalls keeps the host's writes waiting until the kernel gives them up.
class UsbTransport : public PluggedDevice
{
public:
  using PluggedDevice::PluggedDevice;

  /// How often the host has tried to stop all effects while it stalled.
  std::atomic<int> refusedStops = 0;

private:
  using Header = std::array<std::uint32_t, 10>;
  using Setup = std::array<std::uint8_t, 8>;
  struct Request
  {
    std::uint32_t sequence = 0;
    std::vector<std::uint8_t> report;
  };

  void attach() override;
  void detach() noexcept override;
  void serve(Instant until) override;
  void send(std::span<const std::uint8_t> input) override;
  void frame() override;

  bool receive(void* to, std::size_t size) const;
  void submit(const Header& header, const Setup& setup);
  void unlink(const Header& header);
  void reply(std::uint32_t command, std::uint32_t sequence, int status, std::size_t length,
    std::span<const std::uint8_t> data = {}) const;
  void control(const Header& header, const Setup& setup, std::span<const std::uint8_t> data);
  [[nodiscard]] std::vector<std::uint8_t> described(std::uint8_t type, std::uint8_t index) const;

  int socket_ = -1;
  std::deque<Request> outs_, ins_;
  std::deque<std::vector<std::uint8_t>> inputs_;
};

using UsbDevice = PluggedStick<UsbTransport>;

} // namespace palpate::test
