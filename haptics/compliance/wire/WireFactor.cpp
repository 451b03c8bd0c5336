// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/wire/WireFactor.h"

#include <Eigen/Cholesky>

namespace palpate
{
namespace
{

/// Of a diagonal element: where less of it is left, elimination has lost the softest motions to rounding.
constexpr double leastLeft = 1e-5;

/// By sweeps (Goodnight 1979): each is a symmetric product of a column, which a compiler makes of vectors. False where
/// the matrix is not positive definite or too badly conditioned for that.
bool sweepInverse(const NodeBlock& matrix, NodeBlock& inverse) noexcept
{
  NodeBlock swept = matrix;
  for (int k = 0; k < 6; ++k)
  {
    const double pivot = swept(k, k);
    if (!(pivot > leastLeft * matrix(k, k)))
    {
      return false;
    }
    const NodeVector column = swept.col(k), share = column / pivot;
    for (int j = 0; j < 6; ++j)
    {
      swept.col(j) -= share[j] * column;
    }
    swept.col(k) = share;
    swept.row(k) = share.transpose();
    swept(k, k) = -1.0 / pivot;
  }
  inverse = -swept;
  return true;
}

/// False where the matrix is not positive definite.
bool choleskyInverse(const NodeBlock& matrix, NodeBlock& inverse) noexcept
{
  const Eigen::LLT<NodeBlock> cholesky(matrix);
  inverse = cholesky.solve(NodeBlock::Identity());
  return cholesky.info() == Eigen::Success;
}

} // namespace

/// A limp wire, such as a thread, is stiff along itself alone: all of it needs the slower way.
bool WireFactor::factor(const WireMatrix& matrix) noexcept
{
  return this->factorBy(sweepInverse, matrix) || this->factorBy(choleskyInverse, matrix);
}

bool WireFactor::factorBy(Inverse inverse, const WireMatrix& matrix) noexcept
{
  this->nodes_ = matrix.nodes;
  NodeBlock left = matrix.own[0];
  for (int i = 0; i < this->nodes_; ++i)
  {
    if (!inverse(left, this->pivot_[i]))
    {
      return false;
    }
    if (i + 1 < this->nodes_)
    {
      this->transfer_[i].noalias() = this->pivot_[i].lazyProduct(matrix.after[i]);
      left = matrix.own[i + 1];
      left.noalias() -= matrix.after[i].transpose().lazyProduct(this->transfer_[i]);
    }
  }
  return true;
}

void WireFactor::solve(WireVector& b) const noexcept
{
  for (int i = 1; i < this->nodes_; ++i)
  {
    b[i] -= this->transfer_[i - 1].transpose() * b[i - 1];
  }
  for (int i = this->nodes_ - 1; i >= 0; --i)
  {
    b[i] = this->pivot_[i] * b[i];
    if (i + 1 < this->nodes_)
    {
      b[i] -= this->transfer_[i] * b[i + 1];
    }
  }
}

void WireFactor::invert() noexcept
{
  const int last = this->nodes_ - 1;
  this->inverse_[last] = this->pivot_[last];
  for (int i = last - 1; i >= 0; --i)
  {
    const NodeBlock moved = this->transfer_[i].lazyProduct(this->inverse_[i + 1]);
    this->inverse_[i] = this->pivot_[i];
    this->inverse_[i].noalias() += moved.lazyProduct(this->transfer_[i].transpose());
  }
}

} // namespace palpate
