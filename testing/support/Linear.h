// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

namespace palpate::test
{

// Decompositions that many tests ask for. They are compiled once, for their templates take seconds in each file.

/// x of a x = b; least squares where a has more rows than columns.
[[nodiscard]] Eigen::MatrixXd solved(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// x of a x = b; nothing where a is singular.
[[nodiscard]] std::optional<Eigen::VectorXd> solvedUniquely(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// x of a x = b for a large symmetric matrix a.
[[nodiscard]] Eigen::MatrixXd solvedSymmetric(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Eigenvalues of a symmetric matrix, the least first.
[[nodiscard]] Eigen::VectorXd eigenvaluesOf(const Eigen::MatrixXd& symmetric);

} // namespace palpate::test
