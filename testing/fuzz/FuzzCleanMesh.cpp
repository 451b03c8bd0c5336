// SPDX-License-Identifier: GPL-3.0-or-later
// Raw arrays through the cleaner: whatever the numbers are, it ends, and what it keeps can be built into a tree's input.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "haptics/geometry/TriangleMesh.h"

namespace
{

/// First byte: how many vertices; then their coordinates, then corners of one byte each (out of range ones included).
palpate::TriangleMesh meshFrom(const std::uint8_t* data, std::size_t size)
{
  palpate::TriangleMesh mesh;
  if (size == 0)
  {
    return mesh;
  }
  const std::size_t vertices = data[0] % 64;
  std::size_t at = 1;
  for (std::size_t v = 0; v < vertices && at + 3 * sizeof(double) <= size; ++v, at += 3 * sizeof(double))
  {
    double xyz[3];
    std::memcpy(xyz, data + at, sizeof(xyz));
    mesh.vertices_W.emplace_back(xyz[0], xyz[1], xyz[2]);
  }
  for (; at + 3 <= size; at += 3)
  {
    mesh.triangles.push_back({ data[at], data[at + 1], data[at + 2] });
  }
  return mesh;
}

void require(bool holds)
{
  if (!holds)
  {
    std::abort();
  }
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const palpate::CleanResult clean = palpate::cleanMesh(meshFrom(data, size));
  const palpate::CleanReport& report = clean.report;
  if (!clean.ok())
  {
    return 0;
  }
  require(!clean.mesh.triangles.empty());
  require(report.trianglesIn == report.trianglesOut + report.nonFinite + report.collinear + report.duplicate);
  for (const auto& t : clean.mesh.triangles)
  {
    require(t[0] < t[1] && t[1] < t[2] && t[2] < clean.mesh.vertices_W.size());
  }
  for (const palpate::Vec3& v : clean.mesh.vertices_W)
  {
    require(std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z()));
  }
  return 0;
}
