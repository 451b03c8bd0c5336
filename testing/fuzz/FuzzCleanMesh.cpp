// SPDX-License-Identifier: GPL-3.0-or-later
// Raw arrays through the cleaner: whatever the numbers are, it ends, its result can be built into a tree, and neither
// the order of the input nor a second cleaning changes it.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/fuzz/Require.h"

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

bool same(const palpate::TriangleMesh& a, const palpate::TriangleMesh& b)
{
  return a.vertices_W == b.vertices_W && a.triangles == b.triangles;
}

/// The same mesh told backwards: vertices, triangles and the corners of each.
palpate::TriangleMesh reversed(palpate::TriangleMesh mesh)
{
  std::reverse(mesh.vertices_W.begin(), mesh.vertices_W.end());
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  for (auto& t : mesh.triangles)
  {
    std::reverse(t.begin(), t.end());
    for (std::uint32_t& corner : t)
    {
      // an index out of range stays out of range
      corner =
        corner < mesh.vertices_W.size() ? static_cast<std::uint32_t>(mesh.vertices_W.size()) - 1 - corner : corner;
    }
  }
  return mesh;
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming) the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const palpate::TriangleMesh raw = meshFrom(data, size);
  const palpate::CleanResult clean = palpate::cleanMesh(raw);
  const palpate::CleanReport& report = clean.report;
  const palpate::CleanResult backwards = palpate::cleanMesh(reversed(raw));
  require(backwards.ok() == clean.ok());
  require(!clean.ok() || same(backwards.mesh, clean.mesh));
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
  require(same(palpate::cleanMesh(clean.mesh).mesh, clean.mesh)); // clean is clean
  return 0;
}
