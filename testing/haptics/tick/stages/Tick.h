// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palpate::test
{

inline constexpr double dt_s = 1e-3; // a tick of these tests

} // namespace palpate::test
