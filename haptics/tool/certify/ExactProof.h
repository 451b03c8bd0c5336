// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tool/certify/SpanProof.h"

namespace palpate
{

/// Whether the proof also holds in rational numbers: the plane leaves this gap free all over the span, but for the
/// rounding of the posed corners. The two gaps at the ends, the bound of the second derivative and the dip are computed
/// anew, without an error, from the same step, corners and normals. The check takes some thousand times as long: debug
/// builds make it for each pair of triangles that is proven, tests for some.
[[nodiscard]] bool holdsExactly(const SpanProof& proof, const ProvenPlane& plane, double gap_u);

} // namespace palpate
