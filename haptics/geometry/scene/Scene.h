// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "haptics/geometry/mesh/Material.h"
#include "haptics/geometry/scene/RigidMotion.h"
#include "haptics/geometry/tree/BoxTree.h"
#include "haptics/geometry/tree/SurfaceTree.h"
#include "haptics/geometry/tree/VertexStart.h"

namespace palpate
{

/// The content that a simpler surface stands for, and how far the two may be from each other.
struct StandIn
{
  std::uint64_t full = 0; ///< hash of that content; 0: the surface stands for itself
  double bound_u = 0.0;   ///< proven: no point of either is further from the other [u]
};

/// One touchable surface: its tree in W and its material. Immutable and shared between revisions of a scene.
struct Surface
{
  std::string name;
  std::shared_ptr<const SurfaceTree> tree;
  Material material;
  RigidMotion motion = {};
  std::shared_ptr<const MaterialFields> fields = {}; ///< of the tree's vertices, or null
  std::shared_ptr<const VertexStart> from = {};      ///< given: its vertices come from there; the tree has its bounds
  StandIn standsFor = {};
  std::uint64_t frame = 0; ///< names the frame of the vertices, at any pose
};

/// Names the original of a surface, which is itself without a replacement.
[[nodiscard]] inline std::uint64_t fullContentOf(const Surface& surface) noexcept
{
  return surface.standsFor.full != 0 ? surface.standsFor.full : surface.tree->contentHash();
}

/// True if the vertices of `was` and of a surface in that frame, with that motion, can be compared: they are given in
/// one frame, or both lie in W as they are.
[[nodiscard]] bool inOneFrame(const Surface& was, std::uint64_t frame, const RigidMotion& motion) noexcept;

/// Names all the places where a surface may be in its motion.
[[nodiscard]] std::uint64_t wayNameOf(const Surface& surface) noexcept;

/// Everything that can be felt at one moment. Immutable once built: the servo reads it, a worker frees it.
class Scene
{
public:
  Scene() = default;
  /// `motion_s`: how long the surfaces take from their first poses and places to their last [s]; 0: they are there at
  /// once.
  Scene(std::uint64_t revision, std::vector<Surface> surfaces, double motion_s = 0.0);

  [[nodiscard]] std::uint64_t revision() const noexcept { return this->revision_; }
  [[nodiscard]] const std::vector<Surface>& surfaces() const noexcept { return this->surfaces_; }
  /// True if any surface is posed or moves: then its vertices alone do not say where it is.
  [[nodiscard]] bool moves() const noexcept { return this->moves_; }
  /// True if any surface goes from one pose to another.
  [[nodiscard]] bool changesPoses() const noexcept { return this->changesPoses_; }
  /// True if the vertices of any surface come from elsewhere.
  [[nodiscard]] bool bends() const noexcept { return this->bends_; }
  /// True if any surface is anything else than a plain wall.
  [[nodiscard]] bool hasMaterials() const noexcept { return this->hasMaterials_; }
  /// One leaf a surface, around all of its path: the first level of a query.
  [[nodiscard]] const BoxTree& surfaceTree() const noexcept { return this->surfaceTree_; }
  /// Radius of the thickest curves [u]; 0 where there are none.
  [[nodiscard]] double mostCoat_u() const noexcept { return this->mostCoat_u_; }
  /// Radius of the thinnest curves [u]; 0 where there are none.
  [[nodiscard]] double leastCoat_u() const noexcept { return this->leastCoat_u_; }
  [[nodiscard]] bool empty() const noexcept { return this->surfaces_.empty(); }
  /// Hash of all vertices, triangles, materials and originals of surfaces, in order, wherever the surfaces are.
  [[nodiscard]] std::uint64_t geometryHash() const noexcept { return this->geometryHash_; }
  /// The same of the surfaces that these come from: a scene of that hash goes over into this one without a step.
  [[nodiscard]] std::uint64_t continuesGeometry() const noexcept { return this->continuesGeometry_; }
  /// The same as geometryHash() and the motions: names a scene in a recording.
  [[nodiscard]] std::uint64_t contentHash() const noexcept { return this->contentHash_; }
  [[nodiscard]] double motion_s() const noexcept { return this->motion_s_; }
  /// How far the surfaces have come, 0..1, an age after the scene was taken [s].
  [[nodiscard]] double shareAt(double age_s) const noexcept
  {
    return age_s < this->motion_s_ ? age_s / this->motion_s_ : 1.0;
  }

private:
  std::uint64_t revision_ = 0;
  double motion_s_ = 0.0;
  std::uint64_t geometryHash_ = 0;
  std::uint64_t continuesGeometry_ = 0;
  std::uint64_t contentHash_ = 0;
  std::vector<Surface> surfaces_;
  BoxTree surfaceTree_;
  double mostCoat_u_ = 0.0;
  double leastCoat_u_ = 0.0;
  bool moves_ = false;
  bool changesPoses_ = false;
  bool bends_ = false;
  bool hasMaterials_ = false;
};

} // namespace palpate
