// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "testing/lab/methods/ContactMethod.h"

namespace palpate::lab
{

/// The gap textbook methods keep between proxy and surface so that rounding does not decide the side: a constant in
/// scene units, which is right for scenes of about one unit and for no other.
inline constexpr double gap_u = 1e-6;

/// The force of the face nearest to the device, along its normal by the device's depth. Remembers nothing.
[[nodiscard]] std::unique_ptr<ContactMethod> makePenalty(const World& world);
/// A god-object against the planes of all faces within reach, each taken for a wall without end.
[[nodiscard]] std::unique_ptr<ContactMethod> makeHalfSpaces(const World& world);
/// A god-object that meets at most one new plane a tick and stops there.
[[nodiscard]] std::unique_ptr<ContactMethod> makeOneConstraint(const World& world);
/// A god-object whose goal is found by projecting on the plane that is met, then the next one, at most 16 times.
[[nodiscard]] std::unique_ptr<ContactMethod> makeAlternating(const World& world);
/// A point that goes to the plane between it and the device: the path along that plane is not looked at.
[[nodiscard]] std::unique_ptr<ContactMethod> makePointWithoutSide(const World& world);
/// The loop of Ruspini, Kolarov & Khatib 1997 in its printed form: planes are carried over from tick to tick.
[[nodiscard]] std::unique_ptr<ContactMethod> makeTextbookLoop(const World& world);
/// The same loop over the segments of Embree. Only where embreeRays() is not null.
[[nodiscard]] std::unique_ptr<ContactMethod> makeTextbookLoopOnEmbree(const World& world);

} // namespace palpate::lab
