// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tool/certify/SpanProof.h"

namespace palpate
{

/// Whether the proof says in rational numbers what it says in rounded ones: that the plane leaves this gap free all
/// over the span, but for so much as posing the corners rounds. The two gaps at the ends, the bound of the second
/// derivative and the dip are computed anew, without an error, from the same step, corners and normals. It takes some
/// thousand times as long: debug builds ask it of each pair of triangles that is proven, tests of some.
[[nodiscard]] bool holdsExactly(const SpanProof& proof, const ProvenPlane& plane, double gap_u);

} // namespace palpate
