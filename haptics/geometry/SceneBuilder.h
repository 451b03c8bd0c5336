// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "haptics/geometry/Material.h"
#include "haptics/geometry/Scene.h"
#include "haptics/geometry/TriangleMesh.h"

namespace palpate
{

/// One surface as a view or a file gives it, already in W (pose, scale and shear baked into the vertices).
struct SurfaceInput
{
  std::string name;
  std::shared_ptr<const TriangleMesh> mesh;
  Material material;
  std::shared_ptr<const MaterialFields> fields = {}; ///< of the mesh's vertices, or null
};

/// What became of one input.
struct SurfaceReport
{
  std::string name;
  CleanReport clean;
  std::string refusal; ///< empty when the surface is in the scene
  std::size_t materialReplaced = 0; ///< values of its arrays that could not be used: the surface's own took their place
};

/// A new scene (null when nothing is touchable) and the reports, one per input, in the order of the inputs.
struct SceneBuildResult
{
  std::shared_ptr<const Scene> scene;
  std::vector<SurfaceReport> reports;
};

/// Cleans, plans and builds all trees eagerly. Off the servo thread; call from one thread at a time.
/// The scene is the same, bit for bit, for any number of workers. A surface whose mesh object was in the
/// previous build is reused, not built again.
class SceneBuilder
{
public:
  explicit SceneBuilder(unsigned workers = 1);
  [[nodiscard]] SceneBuildResult build(const std::vector<SurfaceInput>& inputs);

private:
  struct Kept
  {
    std::shared_ptr<const TriangleMesh> mesh;
    std::shared_ptr<const SurfaceTree> tree;
    std::vector<std::uint32_t> sourceVertex;
    SurfaceReport report;
  };
  [[nodiscard]] Kept buildOne(const SurfaceInput& input) const;

  unsigned workers_;
  std::uint64_t revision_ = 0;
  std::vector<Kept> kept_;
};

} // namespace palpate
