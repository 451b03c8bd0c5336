// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "haptics/core/DeviceInfo.h"
#include "haptics/core/Outcome.h"

namespace palpate
{

/// Sensor and motor of one axis of a device's frame D: x to the right, y up or away, z towards the person. The driver
/// has axes of its own, which a maker may have swapped or turned round, for measuring and for pushing separately.
struct AxisCalibration
{
  int sensor = 0;     ///< the driver's axis that measures it: 0, 1, 2 are x, y, z
  int sensorSign = 1; ///< -1: it counts the other way
  double low_m = 0.0; ///< the ends along the driver's axis [m, as the driver scales them], low_m < high_m
  double high_m = 0.0;
  int motor = 0;                 ///< the driver's axis of force that pushes along it
  int motorSign = 1;             ///< -1: a positive command pushes towards the lower end in D
  double response_m_per_N = 0.0; ///< how far a resting hand was pushed for each N that was asked for; 0: not measured
  double strength = 0.0;         ///< N against the device's own spring for each N that was asked for; 0: not measured

  friend bool operator==(const AxisCalibration&, const AxisCalibration&) = default;
};

/// The result of a self-test of one device.
struct Calibration
{
  static constexpr int mostAxes = 3;

  std::string device; ///< the factory's name
  std::string serial; ///< empty where the device has none
  std::string date;   ///< YYYY-MM-DD
  int axisCount = 0;  ///< the first ones of D have force and are valid: 1 .. 3; 1: it is a wheel, whatever it says
  std::array<AxisCalibration, mostAxes> axes{};
  HeldProof held = HeldProof::Unfelt; ///< of the walls and the viscosity that it closes by itself

  /// Empty, or one phrase that names the fault: an axis twice, no range, a number that is not finite.
  [[nodiscard]] std::string refusal() const;

  friend bool operator==(const Calibration&, const Calibration&) = default;
};

/// A calibration as text, a line a fact, numbers exact:
///
///     palpate calibration 2
///     device NAME
///     serial TEXT
///     date YYYY-MM-DD
///     axis x sensor y- low -0.05 high 0.048 motor x+ response 0.002 strength 1
///     held felt
///     end
///
/// Version 1 was written while effects pointed where their force came from: its signs mean something else.
[[nodiscard]] std::string writeCalibration(const Calibration& calibration);

/// The reverse, strict: everything is there, in this order, and nothing else. Or one phrase with the number of the line.
[[nodiscard]] Outcome<std::optional<Calibration>> parseCalibration(std::string_view text);

} // namespace palpate
