// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

/// The path along which the hand is led, in the device frame.
struct HandPath
{
  std::vector<Vec3> points_D; ///< polyline [m]; one point: the hand holds still there
  double speed_m_per_s = 0.05;
  bool loops = true;          ///< goes back and forth along it; else it stops at the end
  Vec3 turn_D = Vec3::Zero(); ///< rotation at its end, growing evenly along it [rad]
};

/// The path as a function of time.
class LedPath
{
public:
  explicit LedPath(HandPath path);

  /// Empty, or why the path is impossible: at least one point, all finite, and a positive speed are needed.
  [[nodiscard]] std::string refusal() const;
  [[nodiscard]] const Vec3& start_D() const { return this->path_.points_D.front(); }
  /// The pose on the path at a time since the start [s]. Not for a path that is refused.
  [[nodiscard]] Pose at_D(double time_s) const noexcept;

private:
  HandPath path_;
  std::vector<double> reached_m_; ///< length of the path up to each point
};

} // namespace palpate
