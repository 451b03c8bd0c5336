// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

struct SurfaceData;
class SurfaceTree;

/// A surface whose vertices moved, or one sentence with the reason why the tree has to be built anew.
struct RefitResult
{
  std::shared_ptr<const SurfaceTree> tree; ///< null when refused
  std::string refusal;
};

/// Other positions of the vertices of a surface, from which it may move. The tree keeps boxes at all of these
/// positions; the boxes at a moment of the straight path between two positions are means of theirs (so do Gruenschloss
/// et al. 2011 for motion blur).
struct VertexWay
{
  std::uint64_t name = 0; ///< never 0; tells a later build from which positions the tree can move
  std::vector<const std::vector<Vec3>*>
    also; ///< at most two positions; each has a point for each vertex of the mesh, in its order [u]
};

/// A cleaned mesh with all data that the tick needs beside it: tree, adjacency, normals. Immutable.
/// Built eagerly on a worker; no query builds anything lazily.
class SurfaceTree
{
public:
  /// Takes the output of cleanMesh(), or of cleanSegments() with the radius of the curves as `coat_u` > 0; throws
  /// std::invalid_argument for an empty mesh. `threads`: from 2 on the work is shared by two, with the same result.
  explicit SurfaceTree(TriangleMesh clean, double coat_u = 0.0, unsigned threads = 1);
  /// The tree whose mesh() is `ordered`: triangles keep their order, and the shape of a tree follows from their number.
  /// refuseUnclean() must accept the mesh.
  [[nodiscard]] static std::shared_ptr<const SurfaceTree> inOrder(
    TriangleMesh ordered, double coat_u = 0.0, unsigned threads = 1);
  ~SurfaceTree();
  SurfaceTree(const SurfaceTree&) = delete;
  SurfaceTree& operator=(const SurfaceTree&) = delete;

  /// The same triangles with their vertices at other positions: numbers of triangles, edges and vertices and the shape
  /// of the tree stay, boxes and all other data of positions are new. Much cheaper than building; in a tree that has
  /// been bent far from its first shape a query visits more nodes, nothing else.
  /// `vertices_W` [u]: one for each vertex of mesh(), in its order. Refuses another count, a vertex that is not
  /// finite, a triangle that has become exactly collinear.
  /// `retired`: a tree of the same triangles whose memory the new one takes if there is no other owner. Two trees in
  /// turn, one felt and one refitted, allocate no memory, which is half of the cost.
  /// `way`: other positions whose bounds are kept too, for a surface that moves from there. The content is the same.
  [[nodiscard]] RefitResult refitted(std::vector<Vec3> vertices_W, std::shared_ptr<const SurfaceTree> retired = nullptr,
    const VertexWay* way = nullptr) const;

  [[nodiscard]] const TriangleMesh& mesh() const noexcept;
  /// Bytes kept beside the mesh (tree, adjacency, normals).
  [[nodiscard]] std::size_t bytes() const noexcept;
  /// Radius of the curves [u], 0 for triangles.
  [[nodiscard]] double coat_u() const noexcept;
  /// Hash of vertices, triangles and coat.
  [[nodiscard]] std::uint64_t contentHash() const noexcept;
  /// Name of the path for whose positions the tree has bounds; 0: none.
  [[nodiscard]] std::uint64_t wayName() const noexcept;
  /// Hash of the triangles as the tree has ordered them: where it is the same, features have the same numbers.
  [[nodiscard]] std::uint64_t topologyHash() const noexcept;
  /// Data for contact; internal to haptics/.
  [[nodiscard]] const SurfaceData& data() const noexcept { return *this->data_; }

private:
  /// All data but positions: of the retired tree if they can be taken, else copied.
  [[nodiscard]] std::unique_ptr<SurfaceData> roomForRefit(std::shared_ptr<const SurfaceTree> retired) const;
  explicit SurfaceTree(std::unique_ptr<SurfaceData> data);

  std::unique_ptr<SurfaceData> data_;
};

} // namespace palpate
