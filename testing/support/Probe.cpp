// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Probe.h"

#include <stdexcept>

#include "haptics/contact/carry/HandOver.h"

namespace palpate::test
{

Probe::Probe(std::shared_ptr<const Scene> scene, double radius_u, const Vec3& start_W, PathChecker* checker)
  : scene_(std::move(scene)), checker_(checker)
{
  this->plan_.radius_u = radius_u;
  if (moveGodObject(*this->scene_, this->plan_, start_W, this->state_).seatFailed)
  {
    throw std::runtime_error("the start of a probe must have a free place within its radius");
  }
  this->p_W_ = start_W;
}

ContactResult Probe::to(const Vec3& p_W)
{
  const Vec3 from_W = this->state_.x_W;
  this->p_W_ = p_W;
  const ContactResult result = moveGodObject(*this->scene_, this->plan_, p_W, this->state_, this->checker_);
  if (this->checker_ != nullptr)
  {
    const std::string found = this->checker_->finding(from_W);
    if (this->finding_.empty())
    {
      this->finding_ = found;
    }
  }
  return result;
}

ContactResult Probe::along(const Vec3& p_W, int steps)
{
  const Vec3 from_W = this->p_W_;
  for (int i = 1; i < steps; ++i)
  {
    this->to(from_W + (p_W - from_W) * (static_cast<double>(i) / steps));
  }
  return this->to(p_W);
}

void Probe::changeScene(std::shared_ptr<const Scene> scene)
{
  static_cast<void>(handOver(*this->scene_, *scene, this->plan_, this->p_W_, this->state_));
  this->scene_ = std::move(scene);
}

} // namespace palpate::test
