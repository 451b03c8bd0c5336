// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Linear.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace palpate::test
{

Eigen::MatrixXd solved(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return a.colPivHouseholderQr().solve(b);
}

std::optional<Eigen::VectorXd> solvedUniquely(const Eigen::MatrixXd& a, const Eigen::VectorXd& b)
{
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(a);
  return lu.isInvertible() ? std::optional<Eigen::VectorXd>(lu.solve(b)) : std::nullopt;
}

Eigen::MatrixXd solvedSymmetric(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return a.ldlt().solve(b);
}

Eigen::VectorXd eigenvaluesOf(const Eigen::MatrixXd& symmetric)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

} // namespace palpate::test
