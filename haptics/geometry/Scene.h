// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "haptics/geometry/BoxTree.h"
#include "haptics/geometry/Material.h"
#include "haptics/geometry/RigidMotion.h"
#include "haptics/geometry/SurfaceTree.h"

namespace palpate
{

/// One touchable surface: its tree in W and what it is made of. Immutable and shared between revisions of a scene.
struct Surface
{
  std::string name;
  std::shared_ptr<const SurfaceTree> tree;
  Material material;
  RigidMotion motion = {};
};

/// Everything that can be felt at one moment. Immutable once built: the servo reads it, a worker frees it.
class Scene
{
public:
  Scene() = default;
  Scene(std::uint64_t revision, std::vector<Surface> surfaces);

  [[nodiscard]] std::uint64_t revision() const noexcept { return this->revision_; }
  [[nodiscard]] const std::vector<Surface>& surfaces() const noexcept { return this->surfaces_; }
  /// True if any surface is posed or moves: then its vertices alone do not say where it is.
  [[nodiscard]] bool moves() const noexcept { return this->moves_; }
  /// One leaf a surface, around all of its way: what a query walks before it walks a surface.
  [[nodiscard]] const BoxTree& surfaceTree() const noexcept { return this->surfaceTree_; }
  [[nodiscard]] bool empty() const noexcept { return this->surfaces_.empty(); }
  /// Hash of all vertices, triangles and materials, in order: names a scene in a recording.
  [[nodiscard]] std::uint64_t contentHash() const noexcept { return this->contentHash_; }

private:
  std::uint64_t revision_ = 0;
  std::uint64_t contentHash_ = 0;
  std::vector<Surface> surfaces_;
  BoxTree surfaceTree_;
  bool moves_ = false;
};

} // namespace palpate
