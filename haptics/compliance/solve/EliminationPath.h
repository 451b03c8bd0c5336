// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/solve/SparseColumns.h"
#include "haptics/compliance/solve/Supernodes.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// The supernodes from some rows of a matrix to the root of its elimination tree: those that a solve has to visit for
/// right-hand sides on these rows, and for solutions on them.
class EliminationPath
{
public:
  /// `values`: of the factor; they and the pattern are kept by reference.
  EliminationPath(const SupernodalView& pattern, const double* values, const std::vector<std::int32_t>& rows);
  /// All supernodes.
  EliminationPath(const SupernodalView& pattern, const double* values);

  /// Right-hand sides, the columns of E: a row for each, and a column for each place of the path.
  [[nodiscard]] Eigen::MatrixXd rightSides(const SparseColumns& e) const;
  /// Y <- Y L^-T: each row is a right-hand side b before and L^-1 b after.
  void forward(Eigen::MatrixXd& y) const;
  /// Y <- Y L^-1: after forward() the solution on the path.
  void backward(Eigen::MatrixXd& y) const;
  /// E^T times a solution: a row for each column of E, a column for each row of the solution.
  [[nodiscard]] Eigen::MatrixXd readOff(const SparseColumns& e, const Eigen::MatrixXd& answer) const;

private:
  void numberReached(const std::vector<bool>& reached);

  const SupernodalView& pattern_;
  const double* values_;
  std::vector<int> placeOfRow_;
  std::vector<int> supernodes_; ///< ascending: each before its parent
  std::vector<int> place_;      ///< on the path, for each place of the factor, or -1
  int size_ = 0;
  int mostBelow_ = 0; ///< most rows below any of its supernodes
};

} // namespace palpate
