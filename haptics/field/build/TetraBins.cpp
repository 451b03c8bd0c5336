// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/build/TetraBins.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace palpate
{
namespace
{

constexpr double tetrahedraPerBin = 16.0;
constexpr int mostBinsAlongAxis = 1024;

struct Box
{
  Vec3 low, high;
};

Box boxOf(std::span<const Vec3> points_W, const Tetrahedron& t)
{
  const Vec3 &a = points_W[t[0]], &b = points_W[t[1]], &c = points_W[t[2]], &d = points_W[t[3]];
  return { a.cwiseMin(b).cwiseMin(c.cwiseMin(d)), a.cwiseMax(b).cwiseMax(c.cwiseMax(d)) };
}

} // namespace

TetraBins::Octave TetraBins::octaveOf(
  std::span<const Vec3> points_W, std::span<const Tetrahedron> tetrahedra, const std::vector<std::uint32_t>& members)
{
  Octave octave;
  PointGrid& grid = octave.bins;
  grid.low = Vec3::Constant(INFINITY);
  Vec3 high = Vec3::Constant(-INFINITY);
  for (const std::uint32_t t : members)
  {
    const Box box = boxOf(points_W, tetrahedra[t]);
    grid.low = grid.low.cwiseMin(box.low);
    high = high.cwiseMax(box.low);
    octave.widest = octave.widest.cwiseMax(box.high - box.low);
  }
  const double bins = std::max(1.0, static_cast<double>(members.size()) / tetrahedraPerBin);
  const Vec3 extent = (high - grid.low).cwiseMax(1e-300);
  const double edge = std::cbrt(extent.prod() / bins);
  for (int k = 0; k < 3; ++k)
  {
    const double along = edge > 0.0 ? std::ceil(extent[k] / edge) : std::ceil(std::cbrt(bins));
    grid.size[k] = static_cast<int>(std::clamp(along, 1.0, static_cast<double>(mostBinsAlongAxis)));
    grid.edge[k] = extent[k] / grid.size[k];
  }
  const auto numberOf = [&](std::uint32_t t) { return grid.indexOf(grid.cellOf(boxOf(points_W, tetrahedra[t]).low)); };
  octave.start.assign(grid.count() + 1, 0);
  for (const std::uint32_t t : members)
  {
    ++octave.start[numberOf(t) + 1];
  }
  for (std::size_t i = 1; i < octave.start.size(); ++i)
  {
    octave.start[i] += octave.start[i - 1];
  }
  std::vector<std::uint32_t> next = octave.start;
  octave.tetrahedra.resize(members.size());
  for (const std::uint32_t t : members)
  {
    octave.tetrahedra[next[numberOf(t)]++] = t;
  }
  return octave;
}

TetraBins::TetraBins(std::span<const Vec3> points_W, std::span<const Tetrahedron> tetrahedra)
{
  std::map<int, std::vector<std::uint32_t>> octaves;
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
  {
    const Box box = boxOf(points_W, tetrahedra[t]);
    const double extent = (box.high - box.low).maxCoeff();
    if (extent > 0.0 && std::isfinite(extent)) // a tetrahedron without extent, or without a finite position, holds no
                                               // point
    {
      octaves[std::ilogb(extent)].push_back(t);
    }
  }
  for (const auto& [octave, members] : octaves)
  {
    this->octaves_.push_back(octaveOf(points_W, tetrahedra, members));
  }
}

std::size_t TetraBins::bytes() const noexcept
{
  std::size_t bytes = 0;
  for (const Octave& octave : this->octaves_)
  {
    bytes += (octave.start.size() + octave.tetrahedra.size()) * sizeof(std::uint32_t);
  }
  return bytes;
}

} // namespace palpate
