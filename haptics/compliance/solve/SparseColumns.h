// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{

/// Columns with few entries each.
struct SparseColumns
{
  std::vector<std::size_t> start{ 0 }; ///< of each column in rows and values, and the end
  std::vector<std::int32_t> rows;
  std::vector<double> values;

  [[nodiscard]] std::size_t count() const { return this->start.size() - 1; }
};

} // namespace palpate
