// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/oracles/sparse/SymmetricSolve.h"

#include <stdexcept>

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCholesky>

namespace palpate::oracle
{
namespace
{

using Sparse = Eigen::SparseMatrix<double>;

/// Of a matrix that is not positive definite too, as a body's is on its way to rest.
Eigen::VectorXd solveIndefinite(const Sparse& lower, const Eigen::VectorXd& right)
{
  const Eigen::SimplicialLDLT<Sparse, Eigen::Lower> factor(lower);
  if (factor.info() != Eigen::Success)
  {
    throw std::runtime_error("the system is singular");
  }
  return factor.solve(right);
}

} // namespace

Eigen::VectorXd solveSymmetric(const Sparse& lower, const Eigen::VectorXd& right)
{
  Eigen::CholmodSupernodalLLT<Sparse, Eigen::Lower> factor;
  factor.cholmod().print = 0;
  factor.compute(lower);
  const Eigen::VectorXd x =
    factor.info() == Eigen::Success ? Eigen::VectorXd(factor.solve(right)) : solveIndefinite(lower, right);
  const Eigen::VectorXd missed = lower.selfadjointView<Eigen::Lower>() * x - right;
  if (!(missed.norm() <= 1e-9 * right.norm()))
  {
    throw std::runtime_error("the system was not solved");
  }
  return x;
}

} // namespace palpate::oracle
