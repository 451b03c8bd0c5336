// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/core/Types.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/tick/HapticParameters.h"

namespace palpate
{

/// A surface that has come around a hand, or between a hand and the eye that saw it.
struct CameAround
{
  std::string surface;
  Vec3 from_W = Vec3::Zero(); ///< a place outside the surface; the segment from there to the hand meets the surface [u]
  Vec3 ball_W = Vec3::Zero(); ///< where that segment ends
};

/// Whether a surface of `after` has swallowed the ball at x_W, which was outside of the surfaces `before` (null: none).
///
/// Only new surfaces are asked: those that move, bend or are replaced by simpler ones take the ball along in the tick.
/// With an eye (of the view, eye_W) that saw the ball, a surface that now hides it has. Otherwise the ball was where it
/// was felt: it went straight, in any of 26 directions, as far as the surfaces before let it. A surface that bars the
/// way back from all those ends that are outside of its box is around the ball, unless one of its name was before; the
/// nearest way out is taken. Milliseconds at most; not for the tick.
[[nodiscard]] std::optional<CameAround> cameAround(
  const Scene* before, const Scene& after, const ContactPlan& plan, const Vec3& x_W, const std::optional<Vec3>& eye_W);

/// Whether a surface is around the place x_W where a hand is put, and was not around the ball where it was felt. The
/// nearest way out is taken, as cameAround() does. Milliseconds at most; not for the tick.
[[nodiscard]] std::optional<CameAround> movedInto(
  const Scene& scene, const ContactPlan& plan, const Vec3& felt_W, const Vec3& x_W);

/// Names of the closed surfaces of a scene at rest that the place x_W is in. Milliseconds at most; not for the tick.
[[nodiscard]] std::vector<std::string> surfacesAround(const Scene& scene, const ContactPlan& plan, const Vec3& x_W);

/// Whether a surface of a scene at rest is around the ball at x_W that was not, by name, before surfaces moved and left
/// the ball no space. The nearest way out leads to a place that is in those of `before` and in no others. Milliseconds
/// at most; not for the tick.
[[nodiscard]] std::optional<CameAround> squeezedInto(
  const Scene& scene, const ContactPlan& plan, const std::vector<std::string>& before, const Vec3& x_W);

/// Who holds the hand that something has come around.
enum class HandHolder
{
  Mouse,   ///< of a view, which puts the hand elsewhere
  Program, ///< or a device without force
  Device,  ///< one that pushes a person
};

/// The action for that hand.
struct StayOutside
{
  bool letGo = false;   ///< the force ends until the hand has moved out: it would be larger than the largest allowed
  std::string sentence; ///< for the person
};

/// `device_W`: where the hand is [u].
[[nodiscard]] StayOutside stayOutside(
  const CameAround& around, HandHolder holder, const Vec3& device_W, const HapticParameters& parameters);

} // namespace palpate
