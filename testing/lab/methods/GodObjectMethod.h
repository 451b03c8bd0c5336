// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/GodObject.h"
#include "testing/lab/methods/ContactMethod.h"

namespace palpate::lab
{

/// The product's god-object.
class GodObjectMethod final : public ContactMethod
{
public:
  GodObjectMethod(const World& world, double radius_m, const FrictionPlan& friction = {});

  void start(const Vec3& p_W) override;
  [[nodiscard]] MethodTick tick(const Vec3& p_W) override;

private:
  std::shared_ptr<const Scene> scene_;
  ContactPlan plan_;
  GodObjectState state_;
};

/// The same at the rate of a screen: the force of every 16th tick is held until the next one.
[[nodiscard]] std::unique_ptr<ContactMethod> makeHeld(const World& world);

} // namespace palpate::lab
