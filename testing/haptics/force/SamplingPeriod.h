// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palpate::test
{

/// At which the loops of these tests are sampled [s].
constexpr double T = 1e-3;

} // namespace palpate::test
