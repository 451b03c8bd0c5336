// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/ink/InkLines.h"

#include <algorithm>

namespace palpate
{
namespace
{

std::array<bool, 8> neighbours(const Bitmap& drawing, std::size_t pixel)
{
  const auto x = static_cast<std::int64_t>(pixel % drawing.width), y = static_cast<std::int64_t>(pixel / drawing.width);
  std::array<bool, 8> ink{};
  for (std::size_t i = 0; i < 8; ++i)
  {
    ink[i] = drawing.at(x + pixelsRound[i][0], y + pixelsRound[i][1]);
  }
  return ink;
}

/// Guo & Hall's conditions: one run of ink round the pixel, two or three neighbours when pairs are counted once, and
/// the side whose turn it is blank.
bool mayGo(const std::array<bool, 8>& p, bool secondTurn)
{
  int runs = 0, pairs = 0, shifted = 0;
  for (std::size_t i = 0; i < 8; i += 2)
  {
    runs += !p[i] && (p[i + 1] || p[(i + 2) % 8]) ? 1 : 0;
    pairs += p[(i + 7) % 8] || p[i] ? 1 : 0;
    shifted += p[i] || p[i + 1] ? 1 : 0;
  }
  const int count = std::min(pairs, shifted);
  const bool sideBlank = secondTurn ? !((p[4] || p[5] || !p[7]) && p[6]) : !((p[0] || p[1] || !p[3]) && p[2]);
  return runs == 1 && count >= 2 && count <= 3 && sideBlank;
}

/// Both turns of Guo & Hall over and over, but asking only pixels round which something has changed since their last
/// turn: the others would answer as before. So the work follows the ink that goes, not the passes times all of it.
class Thinning
{
public:
  Thinning(Bitmap& drawing, const Goes& goes) : drawing_(drawing), goes_(goes), waits_(drawing.ink.size(), 0)
  {
    Steps steps(this->askingAll_);
    for (std::size_t pixel = 0; pixel < this->drawing_.ink.size() && steps.go(pixel, this->drawing_.ink.size());
         ++pixel)
    {
      if (!this->drawing_.ink[pixel])
      {
        continue;
      }
      ++this->ink_;
      const std::array<bool, 8> p = neighbours(this->drawing_, pixel);
      if (std::find(p.begin(), p.end(), false) != p.end()) // ink all round holds a pixel
      {
        this->ask(pixel);
      }
    }
  }

  void run()
  {
    Steps steps(this->takingInk_);
    while (!this->asked_[0].empty() || !this->asked_[1].empty())
    {
      if (!this->turn(0, steps) || !this->turn(1, steps))
      {
        return;
      }
    }
  }

private:
  void ask(std::size_t pixel)
  {
    for (const std::size_t turn : { 0, 1 })
    {
      const auto bit = static_cast<std::uint8_t>(1U << turn);
      if (this->drawing_.ink[pixel] && !(this->waits_[pixel] & bit))
      {
        this->waits_[pixel] |= bit;
        this->asked_[turn].push_back(pixel);
      }
    }
  }

  bool turn(std::size_t which, Steps& steps)
  {
    this->going_.clear();
    for (const std::size_t pixel : this->asked_[which])
    {
      if (!steps.go(this->gone_, this->ink_))
      {
        return false;
      }
      this->waits_[pixel] &= static_cast<std::uint8_t>(~(1U << which));
      if (this->drawing_.ink[pixel] && mayGo(neighbours(this->drawing_, pixel), which == 1))
      {
        this->going_.push_back(pixel);
      }
    }
    this->asked_[which].clear();
    for (const std::size_t pixel : this->going_)
    {
      this->drawing_.ink[pixel] = 0;
    }
    for (const std::size_t pixel : this->going_)
    {
      this->askRound(pixel);
    }
    this->gone_ += this->going_.size();
    return true;
  }

  void askRound(std::size_t pixel)
  {
    const auto x = static_cast<std::int64_t>(pixel % this->drawing_.width);
    const auto y = static_cast<std::int64_t>(pixel / this->drawing_.width);
    for (const auto& [dx, dy] : pixelsRound)
    {
      if (this->drawing_.at(x + dx, y + dy))
      {
        this->ask(static_cast<std::size_t>((y + dy) * this->drawing_.width + x + dx));
      }
    }
  }

  Bitmap& drawing_;
  const Goes& goes_;
  const Goes askingAll_ = partOf(goes_, 0.0, 0.3), takingInk_ = partOf(goes_, 0.3, 1.0);
  std::size_t ink_ = 0, gone_ = 0;
  std::array<std::vector<std::size_t>, 2> asked_; // pixels that wait for a turn
  std::vector<std::uint8_t> waits_;               // a bit for each turn that a pixel waits for
  std::vector<std::size_t> going_;
};

} // namespace

void thin(Bitmap& drawing, const Goes& goes)
{
  Thinning(drawing, goes).run();
}

LooseLines linesOf(const Bitmap& thinned)
{
  LooseLines lines;
  std::vector<std::uint32_t> index(thinned.ink.size());
  for (std::size_t pixel = 0; pixel < thinned.ink.size(); ++pixel)
  {
    if (!thinned.ink[pixel])
    {
      continue;
    }
    const auto x = static_cast<std::int64_t>(pixel % thinned.width);
    const auto y = static_cast<std::int64_t>(pixel / thinned.width);
    index[pixel] = static_cast<std::uint32_t>(lines.points_W.size());
    lines.points_W.emplace_back(x, y, 0.0);
    const auto join = [&](int dx, int dy) {
      lines.segments.push_back({ index[static_cast<std::size_t>((y + dy) * thinned.width + x + dx)], index[pixel] });
    };
    const bool west = thinned.at(x - 1, y), north = thinned.at(x, y - 1), east = thinned.at(x + 1, y);
    if (west)
    {
      join(-1, 0);
    }
    if (north)
    {
      join(0, -1);
    }
    if (thinned.at(x - 1, y - 1) && !west && !north)
    {
      join(-1, -1);
    }
    if (thinned.at(x + 1, y - 1) && !north && !east)
    {
      join(1, -1);
    }
  }
  return lines;
}

} // namespace palpate
