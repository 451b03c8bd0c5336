// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticAdvance.h"

#include <algorithm>

using palpate::Vec3;

namespace
{
/// A gap between hand and proxy of this share of the depth is a resistance, not rounding.
constexpr double resistedShare = 0.25;
/// Unit vectors that differ by no more are the same.
constexpr double sameDirection = 1e-9;

Vec3 Within(const Vec3& way, double longest)
{
  const double length = way.norm();
  return length > longest ? Vec3(longest / length * way) : way;
}
} // namespace

void vtkHapticAdvance::Place(const Vec3& anchor_W, const Vec3& axis_W)
{
  this->Placed = true;
  this->Pressed = false;
  this->Anchor = anchor_W;
  this->Axis = axis_W;
  this->Along = this->Chosen = 0.0;
}

void vtkHapticAdvance::FollowAxis(const Frame& frame)
{
  if ((frame.Axis - this->Axis).norm() > sameDirection)
  {
    const Vec3 resisted_W = frame.Held ? frame.Proxy : this->Middle();
    this->Place(this->IsResisted(frame) ? resisted_W : frame.Led, frame.Axis);
  }
}

bool vtkHapticAdvance::IsResisted(const Frame& frame) const
{
  return (frame.Hand - frame.Proxy).norm() > resistedShare * frame.Depth;
}

/// The tip is advanced no further than to there. A hand in a field keeps the plane that was chosen: otherwise the force
/// would depend on the path of the hand.
void vtkHapticAdvance::Stop(const Vec3& at_W, const Frame& frame)
{
  const double reached = this->GetAlongOf(at_W);
  this->Along = std::min(this->Along, frame.Held ? reached : std::max(reached, this->Chosen));
}

/// Pressing goes on, slower against a resistance, which grows the force at a rate that a person can stop. A thing that
/// is not pressed any more rests where its proxy is.
void vtkHapticAdvance::Press(const Frame& frame)
{
  const bool resisted = this->IsResisted(frame);
  this->Gap = frame.Pressing && resisted ? this->Gap : frame.Depth;
  if (frame.Pressing && resisted)
  {
    this->Gap = std::clamp(this->Gap + frame.PressOn, frame.Depth, std::max(frame.Firm, frame.Depth));
    this->Along = std::max(this->Along, this->GetAlongOf(frame.Led) + frame.PressOn);
  }
  else if (frame.Pressing)
  {
    this->Along += frame.Press;
  }
  else if (this->Pressed && resisted)
  {
    this->Stop(frame.Proxy, frame);
  }
  else if (this->Pressed)
  {
    this->Chosen = this->Along;
  }
  this->Pressed = frame.Pressing;
}

Vec3 vtkHapticAdvance::Next(const Vec3& aimed_W, const Frame& frame)
{
  this->Press(frame);
  const Vec3 across = aimed_W - this->Anchor - this->GetAlongOf(aimed_W) * this->Axis;
  const Vec3 wanted_W = this->Anchor + across + this->Along * this->Axis;
  Vec3 next_W = frame.Led + Within(wanted_W - frame.Led, frame.Pace);
  if (this->IsResisted(frame) && (next_W - frame.Proxy).norm() > this->Gap)
  {
    next_W = frame.Proxy + Within(next_W - frame.Proxy, this->Gap);
    this->Stop(this->GetAlongOf(next_W) > this->GetAlongOf(frame.Proxy) ? next_W : frame.Proxy, frame);
  }
  return next_W;
}

Vec3 vtkHapticAdvance::Rest(const Frame& frame)
{
  this->Pressed = false;
  if (!this->IsResisted(frame))
  {
    return frame.Led;
  }
  this->Stop(frame.Proxy, frame);
  return frame.Proxy;
}
