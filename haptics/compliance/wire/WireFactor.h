// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/wire/WireBlocks.h"

namespace palpate
{

/// Factor of a block-tridiagonal positive definite matrix, from its first node to its last. Some 75 kB: not for the
/// stack. Real-time safe; costs grow with the number of nodes.
class WireFactor
{
public:
  /// False where the matrix is not positive definite: the factor is then of no use.
  [[nodiscard]] bool factor(const WireMatrix& matrix) noexcept;
  /// Replaces b by the solution for it.
  void solve(WireVector& b) const noexcept;

  /// The inverse's own blocks, backwards from the last node; to be called before inverse().
  void invert() noexcept;
  [[nodiscard]] const NodeBlock& inverse(int node) const noexcept { return this->inverse_[node]; }
  /// Of the inverse, a node's block of any later node's column is minus this times that of the next node.
  [[nodiscard]] const NodeBlock& transfer(int node) const noexcept { return this->transfer_[node]; }

private:
  using Inverse = bool (*)(const NodeBlock& matrix, NodeBlock& inverse) noexcept;
  [[nodiscard]] bool factorBy(Inverse inverse, const WireMatrix& matrix) noexcept;

  int nodes_ = 0;
  std::array<NodeBlock, Wire::mostNodes> pivot_; ///< inverse of the block that elimination of the nodes before leaves
  std::array<NodeBlock, Wire::mostBeams> transfer_;
  std::array<NodeBlock, Wire::mostNodes> inverse_;
};

} // namespace palpate
