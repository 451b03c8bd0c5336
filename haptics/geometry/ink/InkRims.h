// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "haptics/geometry/ink/InkLines.h"

namespace palpate
{

/// Lengths in space of displacements given in pixels.
class Ruler
{
public:
  explicit Ruler(const Eigen::Vector2d& pixel_u) : pixel_u_(pixel_u) {}

  [[nodiscard]] double diagonal_u() const { return this->pixel_u_.norm(); }
  [[nodiscard]] Eigen::Vector2d inSpace_u(const Vec3& p) const { return p.head<2>().cwiseProduct(this->pixel_u_); }
  [[nodiscard]] double length_u(const Vec3& a, const Vec3& b) const { return this->inSpace_u(b - a).norm(); }

  /// Blank distance between two pixels of a stroke: their distance without the half pixel of ink at each of its ends.
  [[nodiscard]] double blank_u(const Vec3& a, const Vec3& b) const
  {
    const double steps = std::max((b - a).cwiseAbs().maxCoeff(), 1.0);
    return this->length_u(a, b) * (1.0 - 1.0 / steps);
  }

private:
  Eigen::Vector2d pixel_u_;
};

/// A pixel with ink at the edge of a stroke, and the point of the lines nearest to it.
struct RimPixel
{
  Vec3 place; ///< its column and row
  std::uint32_t point;
};

/// The rims of the strokes that lines in pixels are the middle of. Points without a segment have none. Not all of them
/// where goes says no. O(pixels).
[[nodiscard]] std::vector<RimPixel> rimsOf(
  const LooseLines& lines, const Bitmap& drawing, const Ruler& ruler, const Goes& goes);

/// A joint of an end with a point on the other side of a blank; better: across less blank, then shorter.
struct Joint
{
  double blank_u;
  double length_u;
  std::uint32_t point;

  auto operator<=>(const Joint&) const = default;
};

/// Pixels of rims by square cells no narrower than the gap.
class RimCells
{
public:
  RimCells(const std::vector<RimPixel>& rims, const Ruler& ruler, double gap_u)
    : ruler_(ruler), size_u_(gap_u + ruler.diagonal_u())
  {
    for (const RimPixel& pixel : rims)
    {
      this->cells_[this->key(pixel.place, 0, 0)].push_back(&pixel);
    }
  }

  /// Looks from a pixel at the tip of a stroke for a joint better than the best so far. length_u(point) is that of a
  /// joint with that point, infinite where they are not to be joined.
  template<class Length>
  void lookFrom(const Vec3& tip, Length length_u, Joint& best) const
  {
    for (int cell = 0; cell < 9; ++cell)
    {
      const auto here = this->cells_.find(this->key(tip, cell % 3 - 1, cell / 3 - 1));
      for (std::size_t i = 0; here != this->cells_.end() && i < here->second.size(); ++i)
      {
        const RimPixel& other = *here->second[i];
        const double blank_u = this->ruler_.blank_u(tip, other.place);
        if (blank_u > best.blank_u)
        {
          continue;
        }
        const Joint joint{ blank_u, length_u(other.point), other.point };
        best = std::isfinite(joint.length_u) ? std::min(best, joint) : best;
      }
    }
  }

private:
  [[nodiscard]] std::uint64_t key(const Vec3& place, int dx, int dy) const
  {
    const Eigen::Vector2d p_u = this->ruler_.inSpace_u(place);
    const auto x = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(p_u.x() / this->size_u_)) + dx);
    const auto y = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(p_u.y() / this->size_u_)) + dy);
    return static_cast<std::uint64_t>(y) << 32 | x;
  }

  const Ruler& ruler_;
  double size_u_;
  std::unordered_map<std::uint64_t, std::vector<const RimPixel*>> cells_;
};

} // namespace palpate
