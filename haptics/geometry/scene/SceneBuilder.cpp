// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/scene/SceneBuilder.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <optional>
#include <thread>
#include <utility>

#include "haptics/geometry/mesh/PolyLines.h"
#include "haptics/geometry/mesh/PolygonCut.h"

namespace palpate
{
namespace
{

std::string refuseRadius(double radius_u, const TriangleMesh& lines)
{
  double largest_u = 0.0;
  for (const Vec3& v_W : lines.vertices_W)
  {
    largest_u = std::max(largest_u, v_W.cwiseAbs().maxCoeff());
  }
  return refuseLineRadius(radius_u, largest_u);
}

/// From wherever the surface of that name is felt to where the input has it, if they are the same triangles in one
/// frame.
std::optional<VertexWay> wayFrom(const Scene& felt, const SurfaceInput& input, const SurfaceTree& tree)
{
  const auto was = std::find_if(felt.surfaces().begin(), felt.surfaces().end(),
    [&](const Surface& s) { return s.name == input.name && s.tree->topologyHash() == tree.topologyHash(); });
  if (was == felt.surfaces().end() || !inOneFrame(*was, input.frame, { input.pose_WS, input.pose_WS }))
  {
    return std::nullopt;
  }
  VertexWay way{ wayNameOf(*was), { &was->tree->mesh().vertices_W } };
  if (was->from)
  {
    way.also.push_back(&was->from->vertices_W);
  }
  return way;
}

std::size_t trianglesOf(const SurfaceInput& input)
{
  return input.mesh ? input.mesh->triangles.size() : 0;
}

} // namespace

std::string SurfaceReport::summary() const
{
  return this->clean.summary() + (this->holeEdges.empty() ? "" : "; " + describeHoles(this->holeEdges));
}

SceneBuilder::SceneBuilder(unsigned workers) : workers_(std::max(1u, workers)) {}

bool SceneBuilder::knows(const std::vector<SurfaceInput>& inputs) const
{
  const auto known = [this](const SurfaceInput& input)
  {
    return std::any_of(this->kept_.begin(), this->kept_.end(),
      [&](const Kept& kept)
      {
        return kept.mesh == input.mesh && kept.lineRadius_u == input.lineRadius_u && kept.rawFields == input.fields &&
               kept.material == input.material;
      });
  };
  return std::all_of(inputs.begin(), inputs.end(), known);
}

/// The part of the previous build for each input: the same mesh, else the surface of that name.
std::vector<SceneBuilder::Kept> SceneBuilder::takeKnown(const std::vector<SurfaceInput>& inputs)
{
  std::vector<Kept> known(inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    const auto same = [&](const Kept& kept)
    { return kept.mesh == inputs[i].mesh && kept.lineRadius_u == inputs[i].lineRadius_u; };
    const auto found = std::find_if(this->kept_.begin(), this->kept_.end(), same);
    known[i] = found != this->kept_.end() ? *found : Kept{};
  }
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    const auto named = [&](const Kept& kept) { return kept.tree && kept.report.name == inputs[i].name; };
    const auto found = std::find_if(this->kept_.begin(), this->kept_.end(), named);
    if (!known[i].mesh && found != this->kept_.end())
    {
      known[i] = std::exchange(*found, {});
    }
  }
  this->kept_.clear(); // the last holder of a retired tree is the one that gives its memory away
  return known;
}

void SceneBuilder::bringUpToDate(
  const SurfaceInput& input, const Scene* felt, unsigned threads, Kept& kept, BuildWatch& watch)
{
  if (watch.cancelled())
  {
    return;
  }
  const bool known = kept.mesh && kept.mesh == input.mesh && kept.lineRadius_u == input.lineRadius_u;
  if (known)
  {
    kept.report.name = input.name;
    kept.report.refitted = false;
  }
  if (known || refit(input, felt, kept))
  {
    watch.advance(trianglesOf(input)); // it is clean
  }
  else
  {
    kept = buildAnew(input, threads, watch);
  }
  kept.report.holeEdges = input.holeEdges;
  if (kept.tree)
  {
    fitMaterial(input, kept);
  }
}

/// A surface whose material cannot be used is refused, not touched with another one.
void SceneBuilder::fitMaterial(const SurfaceInput& input, Kept& kept)
{
  const bool fitted = kept.fields && kept.rawFields == input.fields && kept.material == input.material;
  if (fitted && !kept.report.refitted && kept.report.refusal.empty())
  {
    return;
  }
  kept.rawFields = input.fields;
  kept.material = input.material;
  kept.fields.reset();
  kept.report.materialReplaced = 0;
  kept.report.refusal = input.material.validate();
  if (!kept.report.refusal.empty() || !input.fields || input.fields->empty())
  {
    return;
  }
  FittedFields fit = fitFields(*input.fields, input.material, kept.sourceVertex, input.mesh->vertices_W.size());
  kept.report.refusal = fit.refusal;
  kept.report.materialReplaced = fit.replaced;
  if (input.lineRadius_u)
  {
    fit.fields.height_u.clear(); // a texture is measured over areas
  }
  if (!fit.fields.height_u.empty())
  {
    fit.fields.texture = measureTexture(kept.tree->mesh(), fit.fields.height_u);
  }
  if (!fit.fields.empty())
  {
    kept.fields = std::make_shared<const MaterialFields>(std::move(fit.fields));
  }
}

bool SceneBuilder::refit(const SurfaceInput& input, const Scene* felt, Kept& kept)
{
  if (!kept.tree || !input.mesh || kept.lineRadius_u != input.lineRadius_u || input.ordered)
  {
    return false;
  }
  if (!kept.vertices) // asked for only by surfaces that move
  {
    const CleanReport& clean = kept.report.clean;
    kept.vertices = std::make_shared<const CleanedVertices>(
      kept.mesh, kept.tree->mesh().vertices_W, kept.sourceVertex, clean.nonFinite + clean.collinear > 0);
  }
  std::optional<std::vector<Vec3>> vertices_W = kept.vertices->follow(*input.mesh);
  if (!vertices_W)
  {
    return false;
  }
  const std::optional<VertexWay> way = felt != nullptr ? wayFrom(*felt, input, *kept.tree) : std::nullopt;
  RefitResult fitted = kept.tree->refitted(std::move(*vertices_W), std::move(kept.retired), way ? &*way : nullptr);
  if (!fitted.tree)
  {
    return false;
  }
  kept.retired = std::exchange(kept.tree, std::move(fitted.tree));
  kept.mesh = input.mesh;
  kept.report.refitted = true;
  return true;
}

CleanResult SceneBuilder::cleanInput(const SurfaceInput& input, unsigned threads)
{
  if (!input.mesh || !input.lineRadius_u)
  {
    return input.mesh ? cleanMesh(*input.mesh, threads) : CleanResult{ {}, {}, "it has no mesh", {} };
  }
  CleanResult clean = cleanSegments(*input.mesh, threads);
  if (clean.ok())
  {
    clean.refusal = refuseRadius(*input.lineRadius_u, clean.mesh);
  }
  return clean;
}

SceneBuilder::Kept SceneBuilder::buildInOrder(const SurfaceInput& input, unsigned threads)
{
  Kept built;
  built.mesh = input.mesh;
  built.lineRadius_u = input.lineRadius_u;
  built.report.name = input.name;
  built.report.refusal = refuseUnclean(*input.mesh, input.lineRadius_u.has_value());
  if (built.report.refusal.empty() && input.lineRadius_u)
  {
    built.report.refusal = refuseRadius(*input.lineRadius_u, *input.mesh);
  }
  built.sourceVertex.resize(input.mesh->vertices_W.size());
  std::iota(built.sourceVertex.begin(), built.sourceVertex.end(), 0u);
  if (built.report.refusal.empty())
  {
    built.tree = SurfaceTree::inOrder(*input.mesh, input.lineRadius_u.value_or(0.0), threads);
  }
  return built;
}

SceneBuilder::Kept SceneBuilder::buildAnew(const SurfaceInput& input, unsigned threads, BuildWatch& watch)
{
  if (input.ordered && input.mesh)
  {
    watch.advance(trianglesOf(input)); // it is clean
    return buildInOrder(input, threads);
  }
  Kept built;
  built.mesh = input.mesh;
  built.lineRadius_u = input.lineRadius_u;
  CleanResult clean = cleanInput(input, threads);
  watch.advance(trianglesOf(input));
  if (watch.cancelled())
  {
    return {};
  }
  built.report = { input.name, clean.report, clean.refusal };
  built.sourceVertex = std::move(clean.sourceVertex);
  if (clean.ok())
  {
    built.tree = std::make_shared<const SurfaceTree>(std::move(clean.mesh), input.lineRadius_u.value_or(0.0), threads);
  }
  return built;
}

/// The others would wait for a surface with half of all triangles or more.
unsigned SceneBuilder::threadsFor(const SurfaceInput& input, std::size_t allTriangles) const
{
  return 2 * trianglesOf(input) >= allTriangles ? std::min(this->workers_, std::thread::hardware_concurrency()) : 1;
}

SceneBuildResult SceneBuilder::build(const std::vector<SurfaceInput>& inputs, const Scene* felt, BuildWatch* watch)
{
  BuildWatch nobody;
  BuildWatch& told = watch != nullptr ? *watch : nobody;
  std::size_t triangles = 0;
  for (const SurfaceInput& input : inputs)
  {
    triangles += trianglesOf(input);
  }
  told.expect(2 * triangles); // cleaned, then made a tree
  std::vector<Kept> built = this->takeKnown(inputs);
  std::atomic<std::size_t> next = 0;
  const auto work = [&]
  {
    for (std::size_t i = next.fetch_add(1); i < inputs.size(); i = next.fetch_add(1))
    {
      bringUpToDate(inputs[i], felt, felt == nullptr ? this->threadsFor(inputs[i], triangles) : 1, built[i], told);
      told.advance(trianglesOf(inputs[i]));
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (unsigned w = 1; w < std::min<std::size_t>(this->workers_, inputs.size()); ++w)
    {
      helpers.emplace_back(work);
    }
    work();
  }
  this->kept_ = std::move(built);
  return told.cancelled() ? SceneBuildResult{} : this->assemble(inputs);
}

SceneBuildResult SceneBuilder::assemble(const std::vector<SurfaceInput>& inputs)
{
  SceneBuildResult result;
  std::vector<Surface> surfaces;
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    const Kept& kept = this->kept_[i];
    const Pose& pose_WS = inputs[i].pose_WS;
    SurfaceReport& report = result.reports.emplace_back(kept.report);
    if (report.refusal.empty() && !RigidMotion{ pose_WS, pose_WS }.isRigid())
    {
      report.refusal = "its pose is not rigid: the position must be finite and the rotation a unit quaternion";
    }
    if (kept.tree && report.refusal.empty())
    {
      surfaces.push_back({ inputs[i].name, kept.tree, inputs[i].material, { pose_WS, pose_WS }, kept.fields, {},
        inputs[i].standsFor, inputs[i].frame });
    }
  }
  if (!surfaces.empty())
  {
    result.scene = std::make_shared<const Scene>(this->takeRevision(), std::move(surfaces));
  }
  return result;
}

} // namespace palpate
