// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "testing/devices/hid/FirmwareModel.h"

namespace palpate::test
{

/// OpenFFBoard with two axes. Facts from Ultrawipf/OpenFFBoard, Firmware/FFBoard/Src/HidFFB.cpp (set_effect,
/// set_condition, ffb_control), Src/EffectsCalculator.cpp and Inc/ffb_defs.h:
/// - the angle, in hundredths of a degree, counts where Direction Enable is set, the bit behind those of the axes; else
///   a set axis bit takes (direction - 18000) / 18000, and an axis without its bit nothing;
/// - a force is the negative of its magnitude times sin for x and -cos for y: it comes from the angle;
/// - conditions have such a factor, too: 1 where a condition is already there when settings come and that of the angle
///   where none is; a condition that comes while its factor is exactly 0 makes it 1;
/// - one condition serves both axes until a second one with force comes;
/// - control bits: 1 on, 2 off, 4 stop all is off as well, 8 reset is off; settings switch on;
/// - effects end by their duration whether on or off; the trigger button is not used.
class OpenFFBoardModel final : public FirmwareModel
{
public:
  explicit OpenFFBoardModel(std::span<const std::uint8_t> descriptor);

protected:
  void settingsCame(Effect& effect) override;
  void conditionCame(Effect& effect, std::size_t axis) override;
  void control(int number) override;
  [[nodiscard]] double forceOf(const Effect& effect, std::size_t axis) const override;
  [[nodiscard]] bool givesForce() const override { return this->on_; }

private:
  bool on_ = false;
};

} // namespace palpate::test
