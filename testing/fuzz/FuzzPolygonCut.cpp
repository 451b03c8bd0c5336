// SPDX-License-Identifier: GPL-3.0-or-later
// Raw numbers as the corners of a polygon: whatever they are, cutting it ends, names only its corners, and is as large
// as the polygon.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>

#include "haptics/geometry/mesh/PolygonCut.h"
#include "testing/fuzz/Require.h"

namespace
{

/// Doubles where the first byte is even; else small whole numbers, of which many are in one place or on a line.
std::vector<palpate::Vec3> cornersFrom(const std::uint8_t* data, std::size_t size)
{
  std::vector<palpate::Vec3> corners;
  const bool raw = size > 0 && data[0] % 2 == 0;
  const std::size_t step = raw ? 3 * sizeof(double) : 3;
  for (std::size_t at = 1; at + step <= size; at += step)
  {
    double xyz[3] = { static_cast<std::int8_t>(data[at]) * 1.0, static_cast<std::int8_t>(data[at + 1]) * 1.0,
      static_cast<std::int8_t>(data[at + 2]) * 0x1p-60 };
    if (raw)
    {
      std::memcpy(xyz, data + at, sizeof(xyz));
    }
    corners.emplace_back(xyz[0], xyz[1], xyz[2]);
  }
  return corners;
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::vector<palpate::Vec3> corners = cornersFrom(data, size);
  std::vector<std::uint32_t> numbers(corners.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const palpate::PolygonCut cut = palpate::cutPolygon(corners, numbers, triangles);
  require(cut.holeEdges == 0 || (cut.holeEdges == corners.size() && triangles.empty()));
  require(triangles.size() <= 3 * corners.size());
  for (const auto& t : triangles)
  {
    require(std::max({ t[0], t[1], t[2] }) < corners.size());
  }
  return 0;
}
