// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/plan/AskedParameters.h"

#include "haptics/contact/view/PlanFor.h"

namespace palpate
{

HapticParameters AskedParameters::told(HapticParameters asked, const BuiltScene& scene) const
{
  asked.contact.radius_u = chosenRadius_u(asked.contact.radius_u, scene.largestRadius_u, this->limitRadius);
  asked.known = scene.known;
  return asked;
}

void AskedParameters::taken(const HapticParameters& asked, const HapticParameters& told) noexcept
{
  this->asked_ = asked;
  this->ballTaken(told);
}

std::optional<HapticParameters> AskedParameters::otherBall(const BuiltScene& scene) const
{
  const HapticParameters told = this->told(this->asked_, scene);
  return told.contact.radius_u != this->ball_u_ ? std::optional(told) : std::nullopt;
}

std::optional<HapticParameters> AskedParameters::otherPlane(const BuiltScene& scene, const DeviceInfo& device)
{
  const HapticParameters wanted = inPlane(this->asked_, scene.plane_WP, this->plane, device);
  if (wanted.walls == this->asked_.walls && wanted.guide == this->asked_.guide)
  {
    return std::nullopt;
  }
  HapticParameters told = this->asked_ = wanted;
  told.contact.radius_u = this->ball_u_;
  told.known = scene.known;
  return told;
}

TouchChoice AskedParameters::touch(const BuiltScene& scene) const
{
  TouchChoice touch;
  touch.plan = this->asked_.contact;
  touch.plan.radius_u = this->ball_u_;
  touch.asked_u = this->asked_.contact.radius_u;
  touch.largest_u = scene.largestRadius_u;
  if (scene.scene)
  {
    touch.plan = planFor(*scene.scene, touch.plan);
    touch.frictionFromData = hasOwnFriction(*scene.scene);
  }
  return touch;
}

} // namespace palpate
