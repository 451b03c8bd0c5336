// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "haptics/contact/ContactPlan.h"
#include "haptics/geometry/SceneSimplifier.h"

namespace palpate
{

/// "all 320 triangles are felt (...), by a point without friction, through a tree of boxes": what was chosen and why,
/// for a person. `plan` as planFor() makes it.
[[nodiscard]] std::string planSentence(const std::vector<SurfaceChoice>& choices, const ContactPlan& plan);

/// "9000 of 79600 triangles are felt, ...": of one surface.
[[nodiscard]] std::string planSentence(const SurfaceChoice& choice);

} // namespace palpate
