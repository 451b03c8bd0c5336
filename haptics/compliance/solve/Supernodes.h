// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/compliance/solve/StiffnessPattern.h"

namespace palpate
{

/// The layout of a factor L: columns of the same pattern are stored together as one dense block, a supernode.
/// A view of CHOLMOD's symbolic analysis.
struct SupernodalView
{
  int order = 0;
  int count = 0;                   ///< of supernodes
  const int* column = nullptr;     ///< first of each supernode, and the end
  const int* rowStart = nullptr;   ///< of each supernode in `rows`, and the end
  const int* valueStart = nullptr; ///< of each supernode among the values
  const int* rows = nullptr;       ///< ascending; the first are its own columns
  const int* matrixRow = nullptr;  ///< row of the matrix at each place of the factor

  [[nodiscard]] int own(int s) const { return this->column[s + 1] - this->column[s]; }
  /// Numbers per column of the block.
  [[nodiscard]] int all(int s) const { return this->rowStart[s + 1] - this->rowStart[s]; }
  [[nodiscard]] const int* rowsBelow(int s) const { return this->rows + this->rowStart[s] + this->own(s); }
};

/// Place in the factor of each row of the matrix.
[[nodiscard]] std::vector<int> placesOfRows(const SupernodalView& pattern);
/// The supernode of each place.
[[nodiscard]] std::vector<int> supernodesOfPlaces(const SupernodalView& pattern);
/// The slot of each number of a matrix among the factor's values.
[[nodiscard]] std::vector<int> slotsOf(const SupernodalView& pattern, const SparseLower& matrix);

/// Replaces the matrix, its numbers at their slots among `values` and zeros elsewhere, by its factor L. False if it is
/// not positive definite. The bits do not depend on the number of threads: there is one, from left to right.
[[nodiscard]] bool factorSupernodes(const SupernodalView& pattern, double* values);

} // namespace palpate
