// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <linux/input.h>

#include "devices/hid/HidConnection.h"
#include "haptics/core/Outcome.h"

namespace palpate
{

/// Abilities of an event device according to the kernel, each bit by its number in linux/input-event-codes.h.
struct EvdevTraits
{
  std::bitset<FF_CNT> forces;
  std::bitset<ABS_CNT> axes;
  std::bitset<KEY_CNT> keys;
};

/// Result of the upload of an effect to the kernel.
enum class EvdevTaken : std::uint8_t
{
  Yes,
  Later, ///< the driver is still busy with the last one: try again
  No,
};

/// An open event device. Calls may block: the kernel waits for the driver while an effect is uploaded, and every other
/// call but read() waits for that. read() may run in one thread while another does the rest.
class EvdevConnection
{
public:
  virtual ~EvdevConnection() = default;

  /// Events that wait; for the first one up to `timeout_ms`. How many, 0 when none came, -1 when the device is gone.
  [[nodiscard]] virtual int read(std::span<input_event> events, int timeout_ms) noexcept = 0;
  /// Range and newest value of an axis; none: it has no such axis.
  [[nodiscard]] virtual std::optional<input_absinfo> axis(std::uint16_t code) noexcept = 0;
  /// Those that are down.
  [[nodiscard]] virtual std::bitset<KEY_CNT> keys() noexcept = 0;
  /// Makes the effect, or changes the one with its number. A new one, -1, gets its number.
  [[nodiscard]] virtual EvdevTaken upload(ff_effect& effect) noexcept = 0;
  [[nodiscard]] virtual bool erase(int effect) noexcept = 0;
  /// Starts an effect by its number, or sets FF_GAIN or FF_AUTOCENTER, 0 .. 0xFFFF. False: the device is gone.
  [[nodiscard]] virtual bool tell(std::uint16_t code, std::int32_t value) noexcept = 0;
  /// The driver's value of a setting by that name; most drivers have none.
  [[nodiscard]] virtual std::optional<int> setting(const std::string& name) noexcept = 0;
  /// The system's message for the last failure, for a person.
  [[nodiscard]] virtual std::string error() const = 0;
};

/// Where event devices come from: the system, or a test. The descriptor of an entry is that of its HID interface, empty
/// where it is none.
class EvdevBus : public DeviceListing
{
public:
  /// Needs no permission.
  [[nodiscard]] virtual EvdevTraits traits(const HidEntry& entry) = 0;
  /// The descriptors of all HID interfaces behind the same plug, its own among them. Needs no permission.
  [[nodiscard]] virtual std::vector<std::vector<std::uint8_t>> behindPlug(const HidEntry& entry) = 0;

  using Opened = Outcome<std::unique_ptr<EvdevConnection>>; ///< or why it cannot be opened, and the remedy
  [[nodiscard]] virtual Opened open(const HidEntry& entry) = 0;
};

/// The event devices of this computer.
[[nodiscard]] std::shared_ptr<EvdevBus> systemEvdevBus();

} // namespace palpate
