// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/core/DeviceInfo.h"
#include "haptics/session/PlanText.h"
#include "haptics/session/plan/PlaneWorld.h"
#include "haptics/session/scene/BuiltScene.h"
#include "haptics/tick/HapticParameters.h"

namespace palpate
{

/// A person's settings, and the parameters for the servo: a ball no larger than the scene allows, and in a plane world
/// the walls and the guide that the device allows. told(), otherBall() and otherPlane() return the parameters to send
/// now; taken() and ballTaken() say that the servo has them.
class AskedParameters
{
public:
  bool limitRadius = true; ///< to the radius whose work fits into a tick
  PlaneWishes plane;

  explicit AskedParameters(const HapticParameters& first) : asked_(first), ball_u_(first.contact.radius_u) {}

  [[nodiscard]] const HapticParameters& asked() const noexcept { return this->asked_; }
  /// For the protection alone, which is the device's and no wish.
  void protect(const SafetyLimits& safety) noexcept { this->asked_.safety = safety; }

  /// These, with the ball that this scene allows and how much of a whole it has.
  [[nodiscard]] HapticParameters told(HapticParameters asked, const BuiltScene& scene) const;
  void taken(const HapticParameters& asked, const HapticParameters& told) noexcept;

  /// With the ball of this scene; none: the servo has it already.
  [[nodiscard]] std::optional<HapticParameters> otherBall(const BuiltScene& scene) const;
  void ballTaken(const HapticParameters& told) noexcept { this->ball_u_ = told.contact.radius_u; }

  /// With walls and guide of this scene's plane, and the ball that the servo has, for that follows the scene by itself;
  /// none: they are the same. Always usable, for they come from a plane and the defaults.
  [[nodiscard]] std::optional<HapticParameters> otherPlane(const BuiltScene& scene, const DeviceInfo& device);

  /// The contact plan for the scene.
  [[nodiscard]] TouchChoice touch(const BuiltScene& scene) const;

private:
  HapticParameters asked_;
  double ball_u_; ///< that the servo has
};

} // namespace palpate
