// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "devices/arm/protocol/WireProtocol.h"
#include "devices/common/DeviceSteps.h"
#include "devices/hid/HidConnection.h"
#include "haptics/core/Outcome.h"

namespace palpate
{

/// An arm that is open, whatever carries its messages: one order out, one reading back. Calls may block; one thread,
/// but stepDone().
class ArmLine
{
public:
  enum class Said : std::uint8_t
  {
    Reading,
    Nothing,  ///< no answer came in time
    Nonsense, ///< something came that is no answer
    Gone,
  };
  struct Answer
  {
    Said said = Said::Gone;
    WireReading reading;
  };

  virtual ~ArmLine() = default;

  [[nodiscard]] virtual Answer exchange(const WireOrder& order, int timeout_ms) = 0;
  /// Says "no force" once more, without waiting for an answer.
  virtual void letGo() noexcept = 0;
  /// The cause of the last answer that was none, for a person.
  [[nodiscard]] virtual std::string error() const = 0;
  /// The step that is due before the first exchange; none: no step.
  [[nodiscard]] virtual std::optional<DeviceStep> step() const { return std::nullopt; }
  virtual void stepDone(const std::string& /*file*/) {}
  /// Carries out the step that the person asked for. Exchange thread.
  virtual void proceed() {}
};

/// Where arms of one kind come from: a link of the system, a library, or a test. A descriptor is empty where the link
/// has none.
class ArmBus : public DeviceListing
{
public:
  using Opened = Outcome<std::unique_ptr<ArmLine>>; ///< or the reason why it cannot be opened, and the remedy
  [[nodiscard]] virtual Opened open(const HidEntry& entry) = 0;
  /// Empty, or the reason why it could not be opened now, and the remedy. Tells the device nothing.
  [[nodiscard]] virtual std::string refusal(const HidEntry& entry) = 0;
  /// Empty, or the step of a person that a usable arm awaits before it pushes, as far as that is known without opening
  /// the arm. Tells the device nothing.
  [[nodiscard]] virtual std::string note(const HidEntry& /*entry*/) { return {}; }
};

} // namespace palpate
