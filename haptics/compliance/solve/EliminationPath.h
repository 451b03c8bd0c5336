// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/solve/SparseColumns.h"
#include "haptics/compliance/solve/Supernodes.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// The supernodes from some rows of a matrix to the root of its elimination tree: all that a solve has to visit for
/// right sides on these rows, and for answers on them.
class EliminationPath
{
public:
  /// `values`: of the factor; they and the pattern are kept by reference.
  EliminationPath(const SupernodalView& pattern, const double* values, const std::vector<std::int32_t>& rows);
  /// All of them.
  EliminationPath(const SupernodalView& pattern, const double* values);

  /// Right sides as columns of E, one below the other: a row each, and a column for each place of the path.
  [[nodiscard]] Eigen::MatrixXd rightSides(const SparseColumns& e) const;
  /// Y <- Y L^-T: each row is a right side b before and L^-1 b after.
  void forward(Eigen::MatrixXd& y) const;
  /// Y <- Y L^-1: after forward() the answer on the path.
  void backward(Eigen::MatrixXd& y) const;
  /// E^T times an answer: a row for each column of E, a column for each row of the answer.
  [[nodiscard]] Eigen::MatrixXd readOff(const SparseColumns& e, const Eigen::MatrixXd& answer) const;

private:
  void numberReached(const std::vector<bool>& reached);

  const SupernodalView& pattern_;
  const double* values_;
  std::vector<int> placeOfRow_;
  std::vector<int> supernodes_; ///< ascending: each before its parent
  std::vector<int> place_;      ///< on the path, of each place of the factor, or -1
  int size_ = 0;
  int mostBelow_ = 0; ///< rows below any of its supernodes
};

} // namespace palpate
