// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/field/FieldBlock.h"

namespace palpate
{

/// Places where the trilinear vectors of a block are 0 and change along every direction, in W: sources, sinks, saddles,
/// middles of vortices. Not at walls, along which nothing flows: there they are 0 everywhere. A cell is looked into in
/// ever smaller parts as long as each component has both signs at the corners of a part; two such places in one part of
/// a sixteenth of a cell are found as one. Those nearest to the middle of the block come first, `most` of them.
[[nodiscard]] std::vector<Vec3> findCriticalPoints(const FieldBlock& brick, std::size_t most);

} // namespace palpate
