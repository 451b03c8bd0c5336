// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/wire/WireFactor.h"

#include <Eigen/Cholesky>

namespace palpate
{

bool WireFactor::factor(const WireMatrix& matrix) noexcept
{
  this->nodes_ = matrix.nodes;
  NodeBlock left = matrix.own[0];
  for (int i = 0; i < this->nodes_; ++i)
  {
    const Eigen::LLT<NodeBlock> cholesky(left);
    if (cholesky.info() != Eigen::Success)
    {
      return false;
    }
    this->pivot_[i] = cholesky.solve(NodeBlock::Identity());
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
