// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/curves/CurveChains.h"

#include <algorithm>

namespace palpate
{
namespace
{

using Segment = std::array<std::uint32_t, 2>;

std::vector<Segment> withoutDoubles(std::span<const Segment> segments)
{
  std::vector<Segment> unique;
  unique.reserve(segments.size());
  for (const auto& [a, b] : segments)
  {
    if (a != b)
    {
      unique.push_back({ std::min(a, b), std::max(a, b) });
    }
  }
  std::sort(unique.begin(), unique.end());
  unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
  return unique;
}

/// The segments round each point, walked and marked one by one.
class Links
{
public:
  Links(const std::vector<Segment>& segments, std::size_t pointCount)
    : first_(pointCount + 1, 0), others_(2 * segments.size()), used_(2 * segments.size(), 0)
  {
    for (const auto& [a, b] : segments)
    {
      ++this->first_[a + 1];
      ++this->first_[b + 1];
    }
    for (std::size_t i = 0; i < pointCount; ++i)
    {
      this->first_[i + 1] += this->first_[i];
    }
    std::vector<std::size_t> next(this->first_.begin(), this->first_.end() - 1);
    for (const auto& [a, b] : segments)
    {
      this->others_[next[a]++] = b;
      this->others_[next[b]++] = a;
    }
  }

  [[nodiscard]] bool passes(std::uint32_t p) const { return this->first_[p + 1] - this->first_[p] == 2; }

  /// The chain that leaves p by its next segment not yet used, to the next point that is no mere passage or back to p;
  /// empty when there is none.
  [[nodiscard]] CurveChain follow(std::uint32_t p)
  {
    CurveChain chain;
    std::uint32_t here = p;
    for (std::uint32_t to = 0; this->leave(here, to);)
    {
      if (chain.points.empty())
      {
        chain.points.push_back(p);
      }
      chain.points.push_back(to);
      here = to;
      if (!this->passes(here) || here == p)
      {
        break;
      }
    }
    return chain;
  }

private:
  bool leave(std::uint32_t from, std::uint32_t& to)
  {
    for (std::size_t i = this->first_[from]; i < this->first_[from + 1]; ++i)
    {
      if (!this->used_[i])
      {
        to = this->others_[i];
        this->used_[i] = 1;
        this->arrive(to, from);
        return true;
      }
    }
    return false;
  }

  void arrive(std::uint32_t at, std::uint32_t from)
  {
    const auto begin = this->others_.begin() + static_cast<std::ptrdiff_t>(this->first_[at]);
    const auto end = this->others_.begin() + static_cast<std::ptrdiff_t>(this->first_[at + 1]);
    this->used_[static_cast<std::size_t>(std::lower_bound(begin, end, from) - this->others_.begin())] = 1;
  }

  std::vector<std::size_t> first_;    ///< where the segments of a point begin
  std::vector<std::uint32_t> others_; ///< their other ends, ascending at each point
  std::vector<char> used_;
};

} // namespace

std::vector<CurveChain> joinSegments(std::span<const Segment> segments, std::size_t pointCount)
{
  Links links(withoutDoubles(segments), pointCount);
  std::vector<CurveChain> chains;
  // Chains with ends first; the rest are rings.
  for (const bool rings : { false, true })
  {
    for (std::uint32_t p = 0; p < pointCount; ++p)
    {
      if (links.passes(p) != rings)
      {
        continue;
      }
      for (CurveChain chain = links.follow(p); !chain.points.empty(); chain = links.follow(p))
      {
        chains.push_back(std::move(chain));
      }
    }
  }
  return chains;
}

} // namespace palpate
