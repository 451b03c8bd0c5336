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
/// A tick does at most a few sweeps a pass, of which most take far less than that; see restsPerPass.
struct RadiusLimit
{
  double largest_u = 0.0; ///< [u]; infinity where no ball is too large, 0 where every one is
  double asked_u = 0.0;   ///< the plan's [u]

  /// Work of a pass, in sweeps of a ball at rest where they are dearest, on average over a tick with all the passes it
  /// may have. A pass makes two or three sweeps, but those after the first look at a list of the faces around and at a
  /// short way. The number is measured, not proven: random hands over rough spheres with the largest ball made up to
  /// 137 sweeps in a tick, and their dearest tick took as much as 43 sweeps at rest.
  static constexpr double restsPerPass = 0.8;

  [[nodiscard]] bool kept() const noexcept { return this->asked_u <= this->largest_u; }
  /// "balls up to 3.2 scene units fit ...": for a person.
  [[nodiscard]] std::string sentence() const;
};

/// Off the servo thread; a few hundred walks of the trees. Beyond the limit a tick stays safe and may be short: it
/// moves only as far as is proven free. Of surfaces that move it looks at the end of their way.
[[nodiscard]] RadiusLimit radiusLimit(const Scene& scene, const ContactPlan& plan);

} // namespace palpate
