// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/RandomHand.h"

#include <cmath>
#include <numbers>

namespace palpate::test
{

RandomHand::RandomHand(const TriangleMesh& mesh, double depth_u, std::uint64_t seed)
  : mesh_(mesh), depth_u_(depth_u), random_(seed)
{
  this->p_W_ = this->goal_W_ = this->goalAtSurface();
}

void RandomHand::moveTo(const Vec3& p_W)
{
  this->p_W_ = p_W;
  this->ticksLeft_ = 0;
}

Vec3 RandomHand::goalAtSurface()
{
  const auto count = static_cast<std::uint32_t>(this->mesh_.triangles.size());
  const auto [a, b, c] = this->mesh_.triangles[this->random_.below(count)];
  const Vec3 &va = this->mesh_.vertices_W[a], &vb = this->mesh_.vertices_W[b], &vc = this->mesh_.vertices_W[c];
  const double u = this->random_.uniform(), v = (1 - u) * this->random_.uniform();
  const Vec3 normal = (vb - va).cross(vc - va).normalized();
  return va + u * (vb - va) + v * (vc - va) + this->random_.uniform(-1, 1) * this->depth_u_ * normal;
}

void RandomHand::beginStroke()
{
  this->stroke_ = static_cast<Stroke>(this->random_.below(4));
  this->from_W_ = this->p_W_;
  const bool far = this->random_.below(3) == 0;
  this->goal_W_ = far ? this->goalAtSurface() : Vec3(this->goal_W_ + this->random_.inCube(2 * this->depth_u_));
  const Vec3 across = this->random_.direction();
  this->right_ = across.unitOrthogonal() * this->random_.uniform(0.1, 2.0) * this->depth_u_;
  this->up_ = across.cross(this->right_);
  const std::uint32_t shortest = this->stroke_ == Stroke::Dash ? 1 : 20;
  this->ticks_ = this->ticksLeft_ =
    static_cast<int>(shortest + this->random_.below(this->stroke_ == Stroke::Dash ? 4 : 200));
}

Vec3 RandomHand::next()
{
  if (this->ticksLeft_ == 0)
  {
    this->beginStroke();
  }
  --this->ticksLeft_;
  const double done = 1.0 - static_cast<double>(this->ticksLeft_) / this->ticks_;
  switch (this->stroke_)
  {
    case Stroke::Rub:
    {
      const double angle = 4 * std::numbers::pi * done;
      this->p_W_ = this->from_W_ + std::sin(angle) * this->right_ + (1 - std::cos(angle)) * this->up_;
      break;
    }
    case Stroke::Tremble:
    {
      const double step_u = this->depth_u_ * 1e-2;
      const Vec3 steps = this->random_.inCube(1.9);
      this->p_W_ = this->from_W_ + step_u * steps.array().round().matrix();
      break;
    }
    default:
      this->p_W_ = this->from_W_ + done * (this->goal_W_ - this->from_W_);
  }
  return this->p_W_;
}

} // namespace palpate::test
