// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include "haptics/core/Clock.h"
#include "haptics/core/Types.h"
#include "haptics/safety/PositionWatch.h"

namespace palpate
{

/// Share of the force while the readings of an arm stay the same to the last bit. A hand that holds still and an arm
/// that no longer measures look alike. As the force falls a live arm moves and gets its force back; a dead one does
/// not.
class StillReading
{
public:
  static constexpr double holds_s = 0.5; ///< so long the force stays
  static constexpr double falls_s = 1.0; ///< then the share falls from 1 to 0
  static constexpr double rises_s = 0.5; ///< after a reading that changes the share rises from 0 to 1

  /// After each reading. `force_N`: of the order before; one of `above_N` or less does not count.
  void follow(const Vec3& p_D, double force_N, double above_N, std::int64_t now_ns) noexcept
  {
    constexpr std::int64_t longest_ns = 20 * perMs_ns; // a clock that jumps has not shown that readings stay the same
    const std::int64_t passed_ns = std::clamp<std::int64_t>(now_ns - this->before_ns_, 0, longest_ns);
    const double passed_s = 1e-9 * static_cast<double>(passed_ns);
    static_cast<void>(this->watch_.look(p_D, this->p_D_, force_N, above_N, passed_s));
    this->share_ = this->watch_.same_s > holds_s ? std::max(0.0, this->share_ - passed_s / falls_s)
                                                 : std::min(1.0, this->share_ + passed_s / rises_s);
    this->p_D_ = p_D;
    this->before_ns_ = now_ns;
  }
  /// 0 .. 1, of the force that is asked for.
  [[nodiscard]] double share() const noexcept { return this->share_; }

private:
  Vec3 p_D_ = Vec3::Zero();
  std::int64_t before_ns_ = 0;
  PositionWatch watch_;
  double share_ = 1.0;
};

} // namespace palpate
