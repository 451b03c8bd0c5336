// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "testing/devices/hid/FirmwareModel.h"

namespace palpate::test
{

/// SunFFB. Facts from sunwj/SunFFBJoystick, firmware/src/ffb_report_handler.cpp and ffb_force_calculator.cpp:
/// - the unit vector of a force is (-sin, cos) of the angle: it comes from there; it acts along an axis whose bit is
/// set
///   or along both with Direction Enable;
/// - any trigger button but 0xFF makes a start wait for that button, and 0 is none that can be pressed: nothing plays;
/// - conditions of both axes act each along its own once one beyond the first has come; a single one acts along the
///   angle;
/// - reset enables; stop all only stops; blocks are handed out in turn.
class SunFfbModel : public FirmwareModel
{
public:
  explicit SunFfbModel(std::span<const std::uint8_t> descriptor);

protected:
  void started(Effect& effect) override;
  void tick(Effect& effect) override;
  void control(int number) override;
  [[nodiscard]] double forceOf(const Effect& effect, std::size_t axis) const override;
  [[nodiscard]] bool givesForce() const override { return this->on_; }

private:
  bool on_ = false;
};

} // namespace palpate::test
