// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "testing/devices/hid/FirmwareModel.h"

namespace palpate::test
{

/// The Arduino joystick library. Facts from YukMingLaw/ArduinoJoystickWithFFBLibrary, src/Joystick.cpp (getEffectForce,
/// ConditionForceCalculator) and src/DynamicHID/PIDReportHandler.cpp:
/// - the angle counts in 255 steps, as -sin for x and cos for y: a force comes from there; an axis acts where its bit
/// is
///   set or Direction Enable alone is;
/// - with both conditions and Direction Enable alone each axis has its own; else factors of the angle mix them;
/// - the position, -1 .. 1, is compared with centre and dead band in ten thousandths: beyond a wall there is no force,
///   and before it there is;
/// - the trigger button is not read; enabling and disabling only change a state that nobody asks for.
class ArduinoLibraryModel final : public FirmwareModel
{
public:
  explicit ArduinoLibraryModel(std::span<const std::uint8_t> descriptor) : FirmwareModel(descriptor, {}) {}

protected:
  void control(int number) override;
  [[nodiscard]] double forceOf(const Effect& effect, std::size_t axis) const override;
};

} // namespace palpate::test
