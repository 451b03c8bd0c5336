// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace palpate
{

/// A value, or in words why it cannot be used.
template<class T>
struct Outcome
{
  T value{};
  std::string problem; ///< one line; "": the value can be used

  [[nodiscard]] bool ok() const noexcept { return this->problem.empty(); }
};

} // namespace palpate
