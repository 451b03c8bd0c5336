// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/mesh/EarCut.h"

#include <algorithm>
#include <limits>

#include "haptics/geometry/mesh/ExactPredicates.h"

namespace palpate
{
namespace
{

using Point = PlanarPolygon::Point;

class Ears
{
public:
  explicit Ears(const PlanarPolygon& polygon) : polygon_(polygon)
  {
    for (std::uint32_t i = 0; i < polygon.points.size(); ++i)
    {
      this->left_.push_back(i);
    }
  }

  void cut(const TakeTriangle& take)
  {
    std::size_t at = 0;
    while (this->left_.size() > 2)
    {
      at = this->next(at % this->left_.size());
      if (!this->isSpike(at))
      {
        take(this->corner(at, -1), this->corner(at, 0), this->corner(at, 1));
      }
      this->left_.erase(this->left_.begin() + static_cast<std::ptrdiff_t>(at));
    }
  }

private:
  static constexpr std::size_t mostLooks = 300'000'000;

  [[nodiscard]] std::uint32_t corner(std::size_t at, int step) const
  {
    const auto count = static_cast<std::ptrdiff_t>(this->left_.size());
    return this->left_[static_cast<std::size_t>((static_cast<std::ptrdiff_t>(at) + step + count) % count)];
  }
  [[nodiscard]] const Point& point(std::size_t at, int step) const
  {
    return this->polygon_.points[this->corner(at, step)];
  }
  [[nodiscard]] std::uint32_t place(std::size_t at, int step) const
  {
    return this->polygon_.place[this->corner(at, step)];
  }

  /// Two of its three corners are one: cutting it off takes an edge that is passed twice, or none.
  [[nodiscard]] bool isSpike(std::size_t at) const
  {
    return this->place(at, -1) == this->place(at, 1) || this->place(at, 0) == this->place(at, 1) ||
           this->place(at, 0) == this->place(at, -1);
  }

  /// The corner to cut off next, from `at` on.
  [[nodiscard]] std::size_t next(std::size_t at)
  {
    const std::size_t count = this->left_.size();
    std::size_t shortest = at;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < count && this->looks_ < mostLooks; ++k)
    {
      const std::size_t i = (at + k) % count;
      if (this->isSpike(i) || this->isEar(i))
      {
        return i;
      }
      if (const double length = this->behind(i); length < least)
      {
        shortest = i;
        least = length;
      }
    }
    return shortest;
  }

  /// Square of the edge that is left where a corner is cut off.
  [[nodiscard]] double behind(std::size_t at) const
  {
    const Point &a = this->point(at, -1), &b = this->point(at, 1);
    return (b.u - a.u) * (b.u - a.u) + (b.v - a.v) * (b.v - a.v) + (b.w - a.w) * (b.w - a.w);
  }

  [[nodiscard]] int side(const Point& a, const Point& b, const Point& c) const
  {
    const int side = orientation2(a.u, a.v, b.u, b.v, c.u, c.v);
    return this->polygon_.mirrored ? -side : side;
  }

  [[nodiscard]] bool isEar(std::size_t at)
  {
    const Point &a = this->point(at, -1), &b = this->point(at, 0), &c = this->point(at, 1);
    ++this->looks_;
    if (this->side(a, b, c) <= 0)
    {
      return false;
    }
    const auto holds = [&](std::uint32_t other)
    {
      const std::uint32_t place = this->polygon_.place[other];
      ++this->looks_;
      const Point& p = this->polygon_.points[other];
      return place != this->place(at, -1) && place != this->place(at, 0) && place != this->place(at, 1) &&
             this->side(a, b, p) >= 0 && this->side(b, c, p) >= 0 && this->side(c, a, p) >= 0;
    };
    return std::none_of(this->left_.begin(), this->left_.end(), holds);
  }

  const PlanarPolygon& polygon_;
  std::vector<std::uint32_t> left_;
  std::size_t looks_ = 0;
};

} // namespace

void cutEars(const PlanarPolygon& polygon, const TakeTriangle& take)
{
  Ears(polygon).cut(take);
}

} // namespace palpate
