// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace palpate
{

/// A step of a person before a device can push: one sentence, and one button where the program must be told.
struct DeviceStep
{
  std::string sentence;
  std::string button;     ///< its text; empty: the device says by itself when it is done
  bool wantsFile = false; ///< the button asks for a file
};

/// A device that a person has to prepare after it was opened. Any thread but the servo's.
class PreparedDevice
{
public:
  virtual ~PreparedDevice() = default;

  /// The next one; none: nothing is left to do.
  [[nodiscard]] virtual std::optional<DeviceStep> step() const = 0;
  /// The button of that step was pressed.
  virtual void stepDone(const std::string& file) const = 0;
};

/// A device whose force is limited until pushes along each of its axes have passed once.
class ProvenDevice
{
public:
  static constexpr double unproven_N = 1.0;

  virtual ~ProvenDevice() = default;

  /// The pushes have passed for a device with this serial number. Before it is opened.
  virtual void prove() noexcept = 0;
};

} // namespace palpate
