// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace palpate
{

/// Work that may still be done, counted in pairs looked at: a budget in time would give other poses on every machine.
class WorkBudget
{
public:
  explicit WorkBudget(std::uint64_t units) noexcept : left_(units) {}

  /// False once nothing is left.
  [[nodiscard]] bool spend(std::uint64_t units = 1) noexcept
  {
    const bool enough = this->left_ >= units;
    this->left_ = enough ? this->left_ - units : 0;
    return enough;
  }
  [[nodiscard]] std::uint64_t left() const noexcept { return this->left_; }

private:
  std::uint64_t left_;
};

} // namespace palpate
