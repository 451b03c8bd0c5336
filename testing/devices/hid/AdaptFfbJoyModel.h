// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "testing/devices/hid/FirmwareModel.h"

namespace palpate::test
{

/// A SideWinder Force Feedback Pro behind adapt-ffb-joy. Facts from tloimu/adapt-ffb-joy, ffb.c and ffb-pro.c:
/// - the angle, in steps of 2 degrees, is handed to the stick, turned round for a negative force; axis bits are not
///   read; on the stick a force comes from it;
/// - any trigger button but 0xFF binds: bit 1 << number of the stick's buttons, 0 being its first; a button that goes
///   down plays the effect again;
/// - reset switches the spring to the centre on, stop all off; asking for the pool and reset forget all effects; blocks
///   begin with 2; no state report is ever sent;
/// - a condition is a centre and one coefficient, in bytes.
class AdaptFfbJoyModel final : public FirmwareModel
{
public:
  explicit AdaptFfbJoyModel(std::span<const std::uint8_t> descriptor);

  [[nodiscard]] bool centring() const { return this->centring_; }

protected:
  void tick(Effect& effect) override;
  void control(int number) override;
  [[nodiscard]] double forceOf(const Effect& effect, std::size_t axis) const override;
  [[nodiscard]] bool givesForce() const override { return this->on_; }
  [[nodiscard]] double ownForce(std::size_t axis) const override;

private:
  bool on_ = true, centring_ = true;
};

} // namespace palpate::test
