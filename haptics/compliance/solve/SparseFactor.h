// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "haptics/compliance/solve/SparseColumns.h"
#include "haptics/compliance/solve/StiffnessPattern.h"

namespace palpate
{

class SingleFactor;

/// L L^T of a symmetric positive definite matrix by supernodes, in METIS' order of elimination, which CHOLMOD finds
/// once for a pattern, one pattern at a time in a process. Not for the servo thread.
class SparseFactor
{
public:
  explicit SparseFactor(const SparseLower& pattern);
  ~SparseFactor();
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;

  /// Size of the factor [B]: known before it is computed.
  [[nodiscard]] std::size_t bytes() const;
  /// False if the matrix is not positive definite: there is no factor then. Throws std::bad_alloc.
  [[nodiscard]] bool factor(const SparseLower& matrix);
  [[nodiscard]] bool ready() const;
  /// Keeps the factor in single precision too, until the next factorisation.
  void keepSingle();
  [[nodiscard]] const SingleFactor& single() const;
  /// The solution of K x = b.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  /// E^T K^-1 E, symmetric and positive semidefinite by construction: Y^T Y with Y = L^-1 E, computed only on the
  /// supernodes from the rows of E to the root of the elimination tree. No backward solve.
  [[nodiscard]] Eigen::MatrixXd sharedCompliance(const SparseColumns& e) const;
  /// The diagonal of that matrix.
  [[nodiscard]] Eigen::VectorXd ownCompliance(const SparseColumns& e) const;
  /// E^T K^-1 N on those supernodes, for a few columns N and all those of E: twice the cost of a column of
  /// sharedCompliance(), and only for N. The rows of N are among those of E.
  [[nodiscard]] Eigen::MatrixXd sharedCompliance(const SparseColumns& e, const SparseColumns& n) const;

private:
  struct Hidden;
  std::unique_ptr<Hidden> hidden_;
};

} // namespace palpate
