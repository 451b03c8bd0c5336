// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palpate::test
{

/// Tension where a limp wire is pulled off a drum over that at its other end, when it has slid half a turn round it,
/// over so many equal corners (at most 20), by the wire's own compliance and the solver of contacts.
[[nodiscard]] double capstanRatio(double friction, int bends);

} // namespace palpate::test
