// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "haptics/contact/GodObject.h"
#include "testing/support/PathChecker.h"

namespace palpate::test
{

/// A god-object led by hand, one tick a call.
class Probe
{
public:
  /// Places the ball at `start_W` (a first tick). `checker`, if given, sees every later move.
  Probe(std::shared_ptr<const Scene> scene, double radius_u, const Vec3& start_W, PathChecker* checker = nullptr);

  /// One tick with the device at p_W.
  ContactResult to(const Vec3& p_W);
  /// `steps` ticks in equal steps from the last device point to p_W; returns the last result.
  ContactResult along(const Vec3& p_W, int steps);

  [[nodiscard]] const Vec3& x_W() const noexcept { return this->state_.x_W; }
  /// Stiffness (proxy - device): the force on the hand of an undamped coupling [N for u = m].
  [[nodiscard]] Vec3 force(double stiffness_N_per_u) const noexcept
  {
    return stiffness_N_per_u * (this->state_.x_W - this->p_W_);
  }
  /// The checker's first finding of all ticks so far; empty is good.
  [[nodiscard]] const std::string& finding() const noexcept { return this->finding_; }

  [[nodiscard]] ContactPlan& plan() noexcept { return this->plan_; }
  /// Goes on in another scene, as after a hand-over from the worker.
  void changeScene(std::shared_ptr<const Scene> scene);

private:
  std::shared_ptr<const Scene> scene_;
  ContactPlan plan_;
  GodObjectState state_;
  PathChecker* checker_;
  Vec3 p_W_ = Vec3::Zero();
  std::string finding_;
};

} // namespace palpate::test
