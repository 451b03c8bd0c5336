// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// The largest ball with which a tick finishes its work in the plan's budget, beside the ball that was asked for.
///
/// A ball at rest on a sheet of triangles with edges h reaches into the boxes of a disc of area 2 pi r (0.02 r + h), so
/// a sweep visits about c (r / h)^2 + c' r / h nodes, in a hollow that fits it all of c'' (r / h)^2. That is counted,
/// not estimated: for balls that rest on up to 256 triangles of each surface, on both sides, in the trees themselves.
/// A tick does at most a few sweeps a pass; see sweepsPerPass.
struct RadiusLimit
{
  double largest_u = 0.0; ///< [u]; infinity where no ball is too large, 0 where every one is
  double asked_u = 0.0;   ///< the plan's [u]

  /// Sweeps of a pass, on average over a tick with all the passes it may have. A slide looks at the first part of its
  /// way and then at all of it, a roll at two ways, and few passes do both twice. The number is measured, not proven:
  /// random hands over rough spheres made up to 197 sweeps in 64 passes, three a pass; one more is slack.
  static constexpr int sweepsPerPass = 4;

  [[nodiscard]] bool kept() const noexcept { return this->asked_u <= this->largest_u; }
  /// "balls up to 3.2 scene units fit ...": for a person.
  [[nodiscard]] std::string sentence() const;
};

/// Off the servo thread; a few hundred walks of the trees. Beyond the limit a tick stays safe and may be short: it
/// moves only as far as is proven free. Of surfaces that move it looks at the end of their way.
[[nodiscard]] RadiusLimit radiusLimit(const Scene& scene, const ContactPlan& plan);

} // namespace palpate
