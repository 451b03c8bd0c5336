// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "haptics/geometry/TriangleMesh.h"

namespace palpate
{

struct SurfaceData;

/// A cleaned mesh with everything the tick needs beside it: tree, adjacency, normals. Immutable.
/// Built eagerly on a worker; no query builds anything lazily.
class SurfaceTree
{
public:
  /// Takes the output of cleanMesh(); throws std::invalid_argument for an empty mesh.
  explicit SurfaceTree(TriangleMesh clean);
  ~SurfaceTree();
  SurfaceTree(const SurfaceTree&) = delete;
  SurfaceTree& operator=(const SurfaceTree&) = delete;

  [[nodiscard]] const TriangleMesh& mesh() const noexcept;
  /// Bytes kept beside the mesh (tree, adjacency, normals).
  [[nodiscard]] std::size_t bytes() const noexcept;
  /// Hash of vertices and triangles.
  [[nodiscard]] std::uint64_t contentHash() const noexcept;
  /// What contact computes from; internal to haptics/.
  [[nodiscard]] const SurfaceData& data() const noexcept { return *this->data_; }

private:
  std::unique_ptr<const SurfaceData> data_;
};

} // namespace palpate
