// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/certify/SpanProof.h"

#include <cmath>

namespace palpate
{

SpanProof::SpanProof(const ScrewStep& step, const Span& span, const MovingPair& pair) noexcept
  : step_(step), span_(span), pair_(pair), length_(span.to - span.from), speed_rad_(step.w_W.norm())
{
  const Vec3 centreFrom = step.centre_W(span.from), centreTo = step.centre_W(span.to);
  for (int i = 0; i < 3; ++i)
  {
    const Vec3 arm = span.turnFrom * pair.arms_W[i];
    this->from_[i] = centreFrom + arm;
    this->to_[i] = centreTo + span.turnTo * pair.arms_W[i];
    this->inward_[i] = step.w_W.cross(step.w_W.cross(arm));
    this->reach_[i] = arm.norm();
  }
}

SpanGap SpanProof::withDip(double gapFrom, double gapTo, double bend) const noexcept
{
  return { gapFrom, gapTo, 0.125 * this->length_ * this->length_ * std::max(0.0, bend) };
}

SpanGap SpanProof::inScene(const Vec3& n_W) const noexcept
{
  const double w3 = this->speed_rad_ * this->speed_rad_ * this->speed_rad_;
  double bend = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    bend = std::max(bend, n_W.dot(this->inward_[i]) + w3 * this->reach_[i] * this->length_);
  }
  return this->withDip(
    gapAlong(n_W, this->from_, this->pair_.scene_W), gapAlong(n_W, this->to_, this->pair_.scene_W), bend);
}

SpanGap SpanProof::inTool(const Vec3& n_W) const noexcept
{
  // In the tool's frame the scene's corners move: y = R^T (b - x), y'' = R^T (w x (w x (b - x)) + 2 w x v).
  const Vec3 &w = this->step_.w_W, &v = this->step_.v_W;
  const Vec3 centre = this->step_.centre_W(this->span_.from);
  const double w2 = this->speed_rad_ * this->speed_rad_;
  double bend = 0.0;
  for (const Vec3& b : this->pair_.scene_W)
  {
    const Vec3 arm = b - centre;
    const double third = w2 * (this->speed_rad_ * arm.norm() + 3.0 * v.norm());
    bend = std::max(bend, -n_W.dot(w.cross(w.cross(arm) + 2.0 * v)) + third * this->length_);
  }
  const Vec3 turned = this->span_.turnTo * (this->span_.turnFrom.transpose() * n_W);
  return this->withDip(
    gapAlong(n_W, this->from_, this->pair_.scene_W), gapAlong(turned, this->to_, this->pair_.scene_W), bend);
}

SpanGap SpanProof::between(const Vec3& nFrom_W, const Vec3& nTo_W) const noexcept
{
  const Vec3 change = nTo_W - nFrom_W;
  const double w2 = this->speed_rad_ * this->speed_rad_;
  double bend = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double turning = 2.0 * change.dot(this->to_[i] - this->from_[i]) / (this->length_ * this->length_) +
                           2.0 * change.norm() * w2 * this->reach_[i];
    const double inward = std::max(nFrom_W.dot(this->inward_[i]), nTo_W.dot(this->inward_[i]));
    bend = std::max(bend, turning + inward + w2 * this->speed_rad_ * this->reach_[i] * this->length_);
  }
  return this->withDip(
    gapAlong(nFrom_W, this->from_, this->pair_.scene_W), gapAlong(nTo_W, this->to_, this->pair_.scene_W), bend);
}

SpanGap SpanProof::gapOf(const ProvenPlane& plane) const noexcept
{
  switch (plane.way)
  {
    case PlaneWay::InScene:
      return this->inScene(plane.first_W);
    case PlaneWay::InTool:
      return this->inTool(plane.first_W);
    case PlaneWay::Between:
      break;
  }
  return this->between(plane.first_W, plane.last_W);
}

} // namespace palpate
