// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/mesh/Weld.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include "haptics/core/InTwo.h"
#include "haptics/core/LargePages.h"

namespace palpate
{
namespace
{

/// An integer that is smaller where the coordinate is. The library's own order of numbers with a sign overflows where
/// they lie far apart on both sides of zero.
std::uint64_t orderOf(double coordinate)
{
  constexpr std::uint64_t sign = std::uint64_t{ 1 } << 63U;
  const auto bits = std::bit_cast<std::uint64_t>(coordinate + 0.0); // + 0.0: one zero, not two
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

/// A vertex and its place along the axis that is being put in order.
struct Placed
{
  std::uint64_t at;
  std::uint32_t index;
};

void sortAlong(std::span<Placed> placed)
{
  boost::sort::spreadsort::integer_sort(
    placed.begin(), placed.end(), [](const Placed& p, unsigned offset) { return p.at >> offset; },
    [](const Placed& a, const Placed& b) { return a.at < b.at; });
}

/// Puts vertices in order that are equal on the axes before `axis`, whose coordinates they have.
void orderFrom(Eigen::Index axis, std::span<Placed> placed, const std::vector<Vec3>& raw_W)
{
  sortAlong(placed);
  for (auto run = placed.begin(); axis < 2 && run != placed.end();)
  {
    const auto end = std::find_if(run, placed.end(), [at = run->at](const Placed& p) { return p.at != at; });
    if (end - run > 1)
    {
      std::for_each(run, end, [&](Placed& p) { p.at = orderOf(raw_W[p.index][axis + 1]); });
      orderFrom(axis + 1, { run, end }, raw_W);
    }
    run = end;
  }
}

std::vector<Placed> finiteOf(const std::vector<Vec3>& raw_W)
{
  std::vector<Placed> finite;
  reserveLarge(finite, raw_W.size());
  for (std::uint32_t i = 0; i < raw_W.size(); ++i)
  {
    if (raw_W[i].allFinite())
    {
      finite.push_back({ orderOf(raw_W[i].x()), i });
    }
  }
  return finite;
}

/// About the median, of a few.
std::uint64_t middleOf(const std::vector<Placed>& placed)
{
  constexpr std::size_t samples = 63;
  std::vector<std::uint64_t> some;
  for (std::size_t i = 0; i < samples && !placed.empty(); ++i)
  {
    some.push_back(placed[i * placed.size() / samples].at);
  }
  const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
  std::nth_element(some.begin(), middle, some.end());
  return some.empty() ? 0 : *middle;
}

/// Vertices in order, those before a plane or behind it: equal ones are in one part.
class Part
{
public:
  Part(std::span<Placed> placed, const std::vector<Vec3>& raw_W) : placed_(placed), raw_W_(raw_W) {}

  void sort()
  {
    orderFrom(0, this->placed_, this->raw_W_);
    for (std::size_t i = 0; i < this->placed_.size(); ++i)
    {
      this->distinct_ += i == 0 || this->at(i) != this->at(i - 1) ? 1 : 0;
    }
  }
  [[nodiscard]] std::size_t distinct() const { return this->distinct_; }
  /// Writes the vertices to their places in the result, from `first` on.
  void write(std::size_t first, Weld& result) const
  {
    std::size_t next = first;
    for (std::size_t i = 0; i < this->placed_.size(); ++i)
    {
      const std::uint32_t raw = this->placed_[i].index;
      if (i == 0 || this->at(i) != this->at(i - 1))
      {
        result.vertices_W[next] = this->at(i);
        result.source[next++] = raw;
      }
      result.source[next - 1] = std::min(result.source[next - 1], raw);
      result.newIndex[raw] = static_cast<std::uint32_t>(next - 1);
    }
  }

private:
  [[nodiscard]] Vec3 at(std::size_t i) const { return this->raw_W_[this->placed_[i].index] + Vec3::Zero(); }

  std::span<Placed> placed_;
  const std::vector<Vec3>& raw_W_;
  std::size_t distinct_ = 0;
};

} // namespace

Weld weld(const std::vector<Vec3>& raw_W, unsigned threads)
{
  std::vector<Placed> finite = finiteOf(raw_W);
  const std::uint64_t middle = middleOf(finite);
  const auto behind = std::partition(finite.begin(), finite.end(), [=](const Placed& p) { return p.at < middle; });
  Part first({ finite.begin(), behind }, raw_W), second({ behind, finite.end() }, raw_W);
  inTwo(
    threads, [&] { first.sort(); }, [&] { second.sort(); });
  Weld result;
  reserveLarge(result.newIndex, raw_W.size());
  result.newIndex.assign(raw_W.size(), Weld::nowhere);
  resizeLarge(result.vertices_W, first.distinct() + second.distinct());
  resizeLarge(result.source, result.vertices_W.size());
  inTwo(
    threads, [&] { first.write(0, result); }, [&] { second.write(first.distinct(), result); });
  return result;
}

} // namespace palpate
