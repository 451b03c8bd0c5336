// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/methods/IterateUntilFixed.h"

#include <algorithm>
#include <limits>

namespace palpate::lab
{
namespace
{

using Vec2 = Eigen::Vector2d;

double cross(const Vec2& a, const Vec2& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Whether the displacement from x to p passes the segment strictly: one that begins on the line does not.
bool crosses(const Vec2& x, const Vec2& p, const Vec2& a, const Vec2& b)
{
  return cross(b - a, x - a) * cross(b - a, p - a) < 0.0 && cross(p - x, a - x) * cross(p - x, b - x) <= 0.0;
}

} // namespace

Vec2 IterateUntilFixed::placeOn(std::size_t segment, const Vec2& wish_W) const
{
  const auto& [i, j] = this->curves_.segments[segment];
  const Vec2 a = this->curves_.points_W[i], along = this->curves_.points_W[j] - a;
  const double share = std::clamp((wish_W - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  const Vec2 beside = this->size_u_ * Vec2(-along.y(), along.x()).normalized();
  const Vec2 left = a + share * along + beside, right = a + share * along - beside;
  return (left - this->x_W_).norm() <= (right - this->x_W_).norm() ? left : right;
}

bool IterateUntilFixed::moveWish(Vec2& wish_W) const
{
  double least_u = std::numeric_limits<double>::infinity();
  Vec2 best = wish_W;
  for (std::size_t k = 0; k < this->curves_.segments.size(); ++k)
  {
    const auto& [i, j] = this->curves_.segments[k];
    const Vec2& a = this->curves_.points_W[i];
    const Vec2& b = this->curves_.points_W[j];
    const double distance_u = std::abs(cross((b - a).normalized(), this->x_W_ - a));
    if (distance_u < least_u && crosses(this->x_W_, wish_W, a, b))
    {
      least_u = distance_u;
      best = this->placeOn(k, wish_W);
    }
  }
  const bool moved = best != wish_W;
  wish_W = best;
  return moved;
}

void IterateUntilFixed::tick(const Vec2& p_W, int mostSteps)
{
  Vec2 wish_W = p_W;
  this->wishes_W_.clear();
  for (int step = 0; step < mostSteps && this->moveWish(wish_W); ++step)
  {
    this->wishes_W_.push_back(wish_W);
  }
  this->x_W_ = wish_W;
}

} // namespace palpate::lab
