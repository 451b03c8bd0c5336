// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/ink/InkRims.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace palpate
{
namespace
{

constexpr std::uint32_t noPoint = std::numeric_limits<std::uint32_t>::max();

using Pixel = std::array<std::int64_t, 2>;

/// The point of the lines nearest to each pixel with ink, as far as ink leads there; noPoint elsewhere. Found by a wave
/// that starts at the lines and passes a pixel again where it comes from a nearer point.
class NearestPoints
{
public:
  NearestPoints(const LooseLines& lines, const Bitmap& drawing, const Ruler& ruler, const Goes& goes)
    : lines_(lines), drawing_(drawing), ruler_(ruler), nearest_(drawing.ink.size(), noPoint)
  {
    for (const auto& [a, b] : lines.segments)
    {
      this->start(a);
      this->start(b);
    }
    const auto ink = static_cast<std::size_t>(std::count(drawing.ink.begin(), drawing.ink.end(), 1));
    Steps steps(goes);
    for (; !this->wave_.empty() && steps.go(this->reached_, ink); this->wave_.pop())
    {
      const auto [x, y] = this->wave_.front();
      const std::uint32_t point = this->nearest_[this->index(x, y)];
      for (const auto& [dx, dy] : pixelsRound)
      {
        this->reach(x + dx, y + dy, point);
      }
    }
  }

  [[nodiscard]] std::uint32_t of(std::size_t pixel) const { return this->nearest_[pixel]; }

private:
  [[nodiscard]] std::size_t index(std::int64_t x, std::int64_t y) const
  {
    return static_cast<std::size_t>(y * this->drawing_.width + x);
  }

  void start(std::uint32_t point)
  {
    const Vec3& p = this->lines_.points_W[point];
    this->reach(static_cast<std::int64_t>(p.x()), static_cast<std::int64_t>(p.y()), point);
  }

  void reach(std::int64_t x, std::int64_t y, std::uint32_t point)
  {
    if (!this->drawing_.at(x, y))
    {
      return;
    }
    std::uint32_t& known = this->nearest_[this->index(x, y)];
    const Vec3 here(static_cast<double>(x), static_cast<double>(y), 0.0);
    if (known == noPoint || this->ruler_.length_u(here, this->lines_.points_W[point]) <
                              this->ruler_.length_u(here, this->lines_.points_W[known]))
    {
      this->reached_ += known == noPoint ? 1 : 0;
      known = point;
      this->wave_.push({ x, y });
    }
  }

  const LooseLines& lines_;
  const Bitmap& drawing_;
  const Ruler& ruler_;
  std::vector<std::uint32_t> nearest_;
  std::queue<Pixel> wave_;
  std::size_t reached_ = 0;
};

} // namespace

std::vector<RimPixel> rimsOf(const LooseLines& lines, const Bitmap& drawing, const Ruler& ruler, const Goes& goes)
{
  const NearestPoints nearest(lines, drawing, ruler, goes);
  std::vector<RimPixel> rims;
  for (std::size_t pixel = 0; pixel < drawing.ink.size(); ++pixel)
  {
    if (nearest.of(pixel) == noPoint)
    {
      continue;
    }
    const auto x = static_cast<std::int64_t>(pixel % drawing.width);
    const auto y = static_cast<std::int64_t>(pixel / drawing.width);
    if (!drawing.at(x - 1, y) || !drawing.at(x + 1, y) || !drawing.at(x, y - 1) || !drawing.at(x, y + 1))
    {
      rims.push_back({ Vec3(static_cast<double>(x), static_cast<double>(y), 0.0), nearest.of(pixel) });
    }
  }
  return rims;
}

} // namespace palpate
