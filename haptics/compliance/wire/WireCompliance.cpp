// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/wire/WireCompliance.h"

#include "haptics/core/CrossMatrix.h"

namespace palpate
{
namespace
{

/// Motions of a node under forces along three axes.
using Columns = Eigen::Matrix<double, 6, 3>;

/// Forces along a touch's axes as forces and moments about the centre line.
Columns leverOf(const WireTouch& touch) noexcept
{
  Columns lever;
  lever << touch.axes_W, crossMatrix(touch.arm_W) * touch.axes_W;
  return lever;
}

/// Motions of both nodes of some beam under the forces of a touch.
struct Moved
{
  Columns first;
  Columns second;
};

/// The nodes of the touch's own beam.
Moved ownMotion(const WireFactor& factor, const WireTouch& touch, const Columns& lever) noexcept
{
  const NodeBlock& transfer = factor.transfer(touch.beam);
  const Columns atFirst = factor.inverse(touch.beam).lazyProduct((1.0 - touch.share) * lever);
  const Columns atSecond = factor.inverse(touch.beam + 1).lazyProduct(touch.share * lever);
  const Columns back = transfer.transpose().lazyProduct(lever);
  Moved moved;
  moved.first = atFirst - transfer.lazyProduct(atSecond);
  moved.second = atSecond - factor.inverse(touch.beam + 1).lazyProduct((1.0 - touch.share) * back);
  return moved;
}

/// Product of the transfers from the first node of a later beam to the second of an earlier one, with their signs.
NodeBlock transferBetween(const WireFactor& factor, int earlier, int later) noexcept
{
  NodeBlock product = NodeBlock::Identity();
  for (int i = earlier + 1; i < later; ++i)
  {
    product = -product.lazyProduct(factor.transfer(i)).eval();
  }
  return product;
}

} // namespace

Vec3 motionAt(const WireTouch& touch, const WireVector& motion) noexcept
{
  const NodeVector mean = (1.0 - touch.share) * motion[touch.beam] + touch.share * motion[touch.beam + 1];
  return touch.axes_W.transpose() * (mean.head<3>() + mean.tail<3>().cross(touch.arm_W));
}

void pressAt(const WireTouch& touch, const Vec3& force_N, WireVector& nodes) noexcept
{
  NodeVector force;
  force.head<3>() = touch.axes_W * force_N;
  force.tail<3>() = touch.arm_W.cross(force.head<3>());
  nodes[touch.beam] += (1.0 - touch.share) * force;
  nodes[touch.beam + 1] += touch.share * force;
}

void addWireCompliance(
  const WireFactor& factor, std::span<const WireTouch> touches, ContactProblem::Square& compliance) noexcept
{
  const int count = static_cast<int>(touches.size());
  std::array<Columns, WireTouch::most> levers;
  std::array<NodeBlock, WireTouch::most> transfers; // from a touch's beam to that of the one before
  for (int b = 0; b < count; ++b)
  {
    levers[b] = leverOf(touches[b]);
    if (b > 0 && touches[b].beam > touches[b - 1].beam)
    {
      transfers[b] = transferBetween(factor, touches[b - 1].beam, touches[b].beam);
    }
  }
  for (int b = 0; b < count; ++b)
  {
    Moved moved = ownMotion(factor, touches[b], levers[b]);
    for (int a = b; a >= 0; --a)
    {
      if (a < b && touches[a].beam < touches[a + 1].beam)
      {
        moved.second = transfers[a + 1].lazyProduct(moved.first).eval();
        moved.first = -factor.transfer(touches[a].beam).lazyProduct(moved.second);
      }
      const double share = touches[a].share;
      const Mat3 w = levers[a].transpose().lazyProduct((1.0 - share) * moved.first + share * moved.second);
      compliance.block<3, 3>(3 * a, 3 * b) += w;
      if (a < b)
      {
        compliance.block<3, 3>(3 * b, 3 * a) += w.transpose();
      }
    }
  }
}

} // namespace palpate
