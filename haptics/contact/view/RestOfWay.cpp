// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/view/RestOfWay.h"

namespace palpate
{

std::array<std::array<Vec3, 3>, 2> RestOfWay::cornersOf(std::uint32_t triangle) const noexcept
{
  return { this->now_.cornersOf(triangle), this->data().cornersOf(triangle) };
}

TreeNode RestNodes::operator[](std::uint32_t index) const noexcept
{
  using Bounds = Eigen::Map<Eigen::Array<double, 6, 1>>;
  using EndBounds = Eigen::Map<const Eigen::Array<double, 6, 1>>;
  TreeNode node = this->now_[index];
  const TreeNode& end = this->end_[index];
  Bounds low(node.low_W[0].data()), high(node.high_W[0].data());
  low = low.min(EndBounds(end.low_W[0].data()));
  high = high.max(EndBounds(end.high_W[0].data()));
  return node;
}

DiscQuad discsOf(const RestOfWay& rest, std::size_t quad) noexcept
{
  using Lanes = Eigen::Map<Eigen::Array4f>;
  using EndLanes = Eigen::Map<const Eigen::Array4f>;
  DiscQuad balls = discsOf(rest.now(), quad);
  const DiscQuad& end = rest.data().discs[quad];
  Lanes x(balls.cx.data()), y(balls.cy.data()), z(balls.cz.data()), radius(balls.radius.data());
  const Eigen::Array4f dx = 0.5F * (EndLanes(end.cx.data()) - x), dy = 0.5F * (EndLanes(end.cy.data()) - y),
                       dz = 0.5F * (EndLanes(end.cz.data()) - z);
  x += dx;
  y += dy;
  z += dz;
  // The filter of discs allows for the rounding in single precision here.
  radius = radius.max(EndLanes(end.radius.data())) + (dx * dx + dy * dy + dz * dz).sqrt();
  return balls;
}

} // namespace palpate
