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
  this->Along = 0.0;
}

void vtkHapticAdvance::FollowAxis(const Frame& frame)
{
  if ((frame.Axis - this->Axis).norm() > sameDirection)
  {
    this->Place(this->IsResisted(frame) ? frame.Proxy : frame.Led, frame.Axis);
  }
}

bool vtkHapticAdvance::IsResisted(const Frame& frame) const
{
  return (frame.Hand - frame.Proxy).norm() > resistedShare * frame.Depth;
}

/// Pressing goes on, slower against a resistance, which grows the force at a rate that a person can stop. A hand that
/// stops pressing rests where its proxy is.
void vtkHapticAdvance::Press(const Frame& frame)
{
  if (frame.Pressing)
  {
    this->Along += this->IsResisted(frame) ? frame.PressOn : frame.Press;
  }
  else if (this->Pressed && this->IsResisted(frame))
  {
    this->Along = this->GetAlongOf(frame.Proxy);
  }
  this->Pressed = frame.Pressing;
}

Vec3 vtkHapticAdvance::Next(const Vec3& aimed_W, const Frame& frame)
{
  this->Press(frame);
  const Vec3 across = aimed_W - this->Anchor - this->GetAlongOf(aimed_W) * this->Axis;
  const Vec3 wanted_W = this->Anchor + across + this->Along * this->Axis;
  Vec3 next_W = frame.Led + Within(wanted_W - frame.Led, frame.Pace);
  const double gap = frame.Pressing ? std::max(frame.Firm, frame.Depth) : frame.Depth;
  if (this->IsResisted(frame) && (next_W - frame.Proxy).norm() > gap)
  {
    next_W = frame.Proxy + Within(next_W - frame.Proxy, gap);
    this->Along = std::min(this->Along, std::max(this->GetAlongOf(next_W), this->GetAlongOf(frame.Proxy)));
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
  this->Along = this->GetAlongOf(frame.Proxy);
  return frame.Proxy;
}
