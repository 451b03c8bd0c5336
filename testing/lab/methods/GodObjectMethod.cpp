// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/methods/GodObjectMethod.h"

#include <stdexcept>

namespace palpate::lab
{
namespace
{

class Held final : public ContactMethod
{
public:
  explicit Held(const World& world) : inner_(world, 0.0) {}

  void start(const Vec3& p_W) override
  {
    this->inner_.start(p_W);
    this->held_ = { p_W, Vec3::Zero() };
    this->age_ = 0;
  }

  MethodTick tick(const Vec3& p_W) override
  {
    constexpr int period = 16; // ticks of 1 ms in a frame of 60 Hz
    if (++this->age_ == period)
    {
      this->held_ = this->inner_.tick(p_W);
      this->age_ = 0;
    }
    return this->held_;
  }

private:
  GodObjectMethod inner_;
  MethodTick held_;
  int age_ = 0;
};

} // namespace

GodObjectMethod::GodObjectMethod(const World& world, double radius_m, const FrictionPlan& friction)
  : scene_(world.scene)
{
  this->plan_.friction = friction;
  this->plan_.radius_u = radius_m * world.metre_u;
}

void GodObjectMethod::start(const Vec3& p_W)
{
  this->state_ = {};
  if (moveGodObject(*this->scene_, this->plan_, p_W, this->state_).seatFailed)
  {
    throw std::runtime_error("a path must begin where the ball fits");
  }
}

MethodTick GodObjectMethod::tick(const Vec3& p_W)
{
  const ContactResult result = moveGodObject(*this->scene_, this->plan_, p_W, this->state_);
  return { result.proxy_W, result.proxy_W - p_W };
}

std::unique_ptr<ContactMethod> makeHeld(const World& world)
{
  return std::make_unique<Held>(world);
}

} // namespace palpate::lab
