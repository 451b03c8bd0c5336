// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/geometry/mesh/CleanedVertices.h"
#include "haptics/geometry/mesh/Material.h"
#include "haptics/geometry/mesh/TriangleMesh.h"
#include "haptics/geometry/scene/BuildWatch.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// One surface as a view or a file gives it: scale and shear baked into the vertices, which are in W but for `pose_WS`.
struct SurfaceInput
{
  std::string name;
  std::shared_ptr<const TriangleMesh> mesh;
  Material material;
  std::shared_ptr<const MaterialFields> fields = {}; ///< of the mesh's vertices, or null
  Pose pose_WS = {};                                 ///< where the mesh stands in W [u]
  std::optional<double>
    lineRadius_u = {};  ///< given: the mesh holds curves (segmentsOf()) of this radius [u], felt without texture
  bool ordered = false; ///< the mesh is a tree's own: vertices and triangles keep their numbers, nothing is cleaned
  StandIn standsFor = {};
  std::uint64_t frame = 0;                 ///< names the frame S of the mesh: a deformation in S holds under any pose
  std::vector<std::size_t> holeEdges = {}; ///< edges round polygons that the mesh has no triangles of: reported
};

/// Result for one input.
struct SurfaceReport
{
  std::string name;
  CleanReport clean;
  std::string refusal;              ///< empty when the surface is in the scene
  std::size_t materialReplaced = 0; ///< values of its arrays that could not be used: the surface's own took their place
  bool refitted = false;            ///< the vertices of a known mesh have moved: its tree was refitted, not built
  std::vector<std::size_t> holeEdges = {}; ///< as the input had them

  /// Kept, dropped and open parts, in one line for a person.
  [[nodiscard]] std::string summary() const;
};

/// A new scene (null when nothing is touchable) and the reports, one per input, in the order of the inputs.
struct SceneBuildResult
{
  std::shared_ptr<const Scene> scene;
  std::vector<SurfaceReport> reports;
};

/// Cleans, plans and builds all trees eagerly. Off the servo thread; call from one thread at a time.
/// The scene is the same, bit for bit, for any number of workers. While nothing is felt, two share the largest surface.
/// A surface whose mesh object was in the
/// previous build is reused, not built again. A surface that has the triangles of the previous surface of its name,
/// with vertices elsewhere, keeps the shape of that surface's tree and is refitted.
class SceneBuilder
{
public:
  explicit SceneBuilder(unsigned workers = 1);
  /// `felt`: the present scene, if surfaces are to move from there (movingFrom): refitted trees have bounds of that
  /// motion. `watch`: is told how far it is. A cancelled build gives no scene, and the next build reuses the finished
  /// parts.
  [[nodiscard]] SceneBuildResult build(
    const std::vector<SurfaceInput>& inputs, const Scene* felt = nullptr, BuildWatch* watch = nullptr);
  /// True if meshes and fields of all inputs were in the previous build: then build() takes no time worth a worker.
  [[nodiscard]] bool knows(const std::vector<SurfaceInput>& inputs) const;
  /// For a scene that is made from one of the builder's: no other has it. Any thread, at any time.
  [[nodiscard]] std::uint64_t takeRevision() { return ++this->revision_; }

private:
  struct Kept
  {
    std::shared_ptr<const TriangleMesh> mesh;
    std::optional<double> lineRadius_u;
    std::shared_ptr<const SurfaceTree> tree;
    std::shared_ptr<const SurfaceTree> retired; ///< the tree before, for its memory
    std::shared_ptr<const CleanedVertices> vertices;
    std::vector<std::uint32_t> sourceVertex;
    std::shared_ptr<const MaterialFields> rawFields; ///< source of `fields`
    Material material;                               ///< and with
    std::shared_ptr<const MaterialFields> fields;
    SurfaceReport report;
  };
  [[nodiscard]] std::vector<Kept> takeKnown(const std::vector<SurfaceInput>& inputs);
  [[nodiscard]] unsigned threadsFor(const SurfaceInput& input, std::size_t allTriangles) const;
  static void bringUpToDate(
    const SurfaceInput& input, const Scene* felt, unsigned threads, Kept& kept, BuildWatch& watch);
  [[nodiscard]] SceneBuildResult assemble(const std::vector<SurfaceInput>& inputs);
  [[nodiscard]] static bool refit(const SurfaceInput& input, const Scene* felt, Kept& kept);
  [[nodiscard]] static CleanResult cleanInput(const SurfaceInput& input, unsigned threads);
  [[nodiscard]] static Kept buildAnew(const SurfaceInput& input, unsigned threads, BuildWatch& watch);
  [[nodiscard]] static Kept buildInOrder(const SurfaceInput& input, unsigned threads);
  static void fitMaterial(const SurfaceInput& input, Kept& kept);

  unsigned workers_;
  std::atomic<std::uint64_t> revision_ = 0;
  std::vector<Kept> kept_;
};

} // namespace palpate
