// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/field/FieldBlock.h"

namespace palpate
{

/// The root of the mean square of the scalar's gradient over the cells of a block that have one [1/u], looked at in the
/// middle of some thousand of them; 0 where none has. The reference for the strength of a detent.
[[nodiscard]] double usualGradient(const FieldBlock& brick);

} // namespace palpate
