// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "haptics/compliance/wire/Wire.h"

namespace palpate
{

/// The numbers of a node: a displacement [u] and a turn [rad] about the world's axes, or a force [N] and a moment [N
/// u].
using NodeVector = Eigen::Matrix<double, 6, 1>;
using NodeBlock = Eigen::Matrix<double, 6, 6>;

/// One for each node.
using WireVector = std::array<NodeVector, Wire::mostNodes>;

/// A symmetric matrix whose blocks couple each node with its neighbours alone.
struct WireMatrix
{
  int nodes = 0;
  std::array<NodeBlock, Wire::mostNodes> own;   ///< of a node with itself
  std::array<NodeBlock, Wire::mostBeams> after; ///< row of a node, column of the one after it
};

} // namespace palpate
