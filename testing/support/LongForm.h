// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <vector>

namespace palpate::test
{

/// Whether this run is the long form, `./dev test --full`.
[[nodiscard]] inline bool isLongForm()
{
  return std::getenv("PALPATE_TEST_FULL") != nullptr;
}

/// The cases of a test: all in the long form, else those that show the most.
template<class Case>
[[nodiscard]] std::vector<Case> casesOf(const std::vector<Case>& all, const std::vector<Case>& most)
{
  return isLongForm() ? all : most;
}

} // namespace palpate::test
