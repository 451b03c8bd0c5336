// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/solve/SparseColumns.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// A factor L as CHOLMOD stores it: columns of like pattern stand together as one dense block, a supernode.
struct SupernodalView
{
  int order = 0;
  int count = 0;                   ///< of supernodes
  const int* column = nullptr;     ///< first of each supernode, and the end
  const int* rowStart = nullptr;   ///< of each in `rows`, and the end
  const int* valueStart = nullptr; ///< of each in `values`
  const int* rows = nullptr;       ///< ascending; the first are its own columns
  const double* values = nullptr;  ///< column by column, as many a column as it has rows
  const int* matrixRow = nullptr;  ///< row of the matrix at each place of the factor
};

/// E^T (L L^T)^-1 E on the way from the rows of E to the root alone.
[[nodiscard]] Eigen::MatrixXd complianceOnPath(const SupernodalView& factor, const SparseColumns& e);

} // namespace palpate
