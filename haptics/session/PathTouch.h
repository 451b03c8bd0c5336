// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "haptics/tick/ForceRenderer.h"

namespace palpate
{

/// The tick along a path of the hand that is known before, one tick a place, without a device and its limits.
class PathTouch
{
public:
  /// `first_s`: how long the first tick is, of which nobody knows when the one before was.
  PathTouch(std::shared_ptr<const Scene> scene, const HapticParameters& parameters, double first_s)
    : scene_(std::move(scene)), parameters_(parameters)
  {
    this->parameters_.safety = SafetyLimits::none();
    this->parameters_.contact.seatsBySide = true;
    this->input_.scene = this->scene_.get();
    this->input_.dt_s = first_s;
  }

  /// The hand is there at that time, which is later than the time before.
  [[nodiscard]] HapticState next(double time_s, const Pose& hand_D) noexcept
  {
    this->input_.dt_s = this->begun_ ? time_s - this->input_.sample.time_s : this->input_.dt_s;
    this->input_.tick += this->begun_ ? 1 : 0;
    this->begun_ = true;
    this->input_.sample.time_s = time_s;
    this->input_.sample.pose_D = hand_D;
    return renderTick(this->input_, this->parameters_, this->state_).state;
  }

private:
  std::shared_ptr<const Scene> scene_;
  HapticParameters parameters_;
  RendererState state_;
  TickInput input_;
  bool begun_ = false;
};

} // namespace palpate
