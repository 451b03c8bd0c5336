// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/arm/Arm.h"

namespace palpate
{

/// The links of an arm as polylines from the base to the tip [m], in D, for a picture; the line of a wrist is the last
/// one. Empty where it has no posture.
[[nodiscard]] std::vector<std::vector<Vec3>> skeletonOf(const Arm& arm, const JointVector& q);

} // namespace palpate
