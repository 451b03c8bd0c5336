// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "testing/devices/arm/BoardModel.h"

namespace palpate::test
{

/// A Novint Falcon: the closed form of its inverse kinematics and its packets, from the facts that are public
/// (libnifalcon/libnifalcon; R. E. Stamper's manipulator). Torque stays until another packet comes.
class FalconModel final : public BoardModel
{
public:
  FalconModel();

  void take(std::span<const std::uint8_t> bytes) override;
  [[nodiscard]] Vec3 tipOf(const Vec3& joints_rad) const override;
  /// Angles of the three arms with the tip there [rad].
  [[nodiscard]] static Vec3 anglesAt(const Vec3& tip_m);
  [[nodiscard]] Vec3 force_N() const override;
  [[nodiscard]] double step_N() const override;

  std::array<int, 3> motor{};
  bool homing = false; ///< so it was told last
  std::array<bool, 3> homed{};
  unsigned buttons = 0;
  int packets = 0;

private:
  void answer();

  std::string inbox_;
};

} // namespace palpate::test
