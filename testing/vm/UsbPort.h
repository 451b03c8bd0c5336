// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "testing/vm/PluggedDevice.h"

namespace palpate::test
{

/// A transfer that the host wants of a device on the bus, or does not want any more.
struct UsbRequest
{
  using Setup = std::array<std::uint8_t, 8>;

  std::uint32_t sequence = 0;
  std::uint32_t unlinks = 0; ///< the request of that number is wanted no longer; 0: this is a transfer
  bool in = false;           ///< to the host
  std::uint32_t endpoint = 0;
  std::uint32_t length = 0; ///< that the host has room for, or gives
  Setup setup{};            ///< of endpoint 0
  std::vector<std::uint8_t> data{};
};

/// The device's end of the kernel's virtual full-speed port: usbcore at one end of a socket, the usbip protocol on it.
class UsbPort
{
public:
  /// Throws std::system_error where the kernel does not take it.
  void attach();
  void detach() noexcept;

  /// None within that time.
  [[nodiscard]] std::optional<UsbRequest> next(RunningDevice::Instant until) const;
  /// A transfer is done: so many bytes went out, or these came in. Not good: it stalls.
  void done(const UsbRequest& request, bool good, std::span<const std::uint8_t> in = {}) const;
  /// Answers an unlinking: the transfer was still waiting, or not.
  void unlinked(const UsbRequest& request, bool waited) const;

private:
  [[nodiscard]] bool receive(void* to, std::size_t size) const;
  void reply(std::uint32_t command, std::uint32_t sequence, int status, std::size_t length,
    std::span<const std::uint8_t> data = {}) const;

  int socket_ = -1;
};

/// The answer to a standard request on endpoint 0, whose descriptors are these. Empty: none.
[[nodiscard]] std::vector<std::uint8_t> standardAnswer(
  const UsbRequest& request, const PlugIdentity& is, const std::vector<std::uint8_t>& configuration);

[[nodiscard]] constexpr std::uint8_t low(std::size_t number)
{
  return static_cast<std::uint8_t>(number & 0xFF);
}
[[nodiscard]] constexpr std::uint8_t high(std::size_t number)
{
  return static_cast<std::uint8_t>(number >> 8 & 0xFF);
}

} // namespace palpate::test
