// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/SceneBuilder.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace palpate
{
namespace
{

/// With its material; a surface whose material cannot be used is refused, not touched with another one.
void addSurface(const SurfaceInput& input, const std::shared_ptr<const SurfaceTree>& tree,
  const std::vector<std::uint32_t>& sourceVertex, std::vector<Surface>& surfaces, SurfaceReport& report)
{
  report.refusal = input.material.validate();
  Surface surface{ input.name, tree, input.material };
  if (report.refusal.empty() && input.fields && !input.fields->empty())
  {
    FittedFields fitted = fitFields(*input.fields, input.material, sourceVertex, input.mesh->vertices_W.size());
    report.refusal = fitted.refusal;
    report.materialReplaced = fitted.replaced;
    if (!fitted.fields.height_u.empty())
    {
      fitted.fields.texture = measureTexture(tree->mesh(), fitted.fields.height_u);
    }
    surface.fields = std::make_shared<const MaterialFields>(std::move(fitted.fields));
  }
  if (report.refusal.empty())
  {
    surfaces.push_back(std::move(surface));
  }
}

} // namespace

SceneBuilder::SceneBuilder(unsigned workers)
  : workers_(std::max(1u, workers))
{
}

SceneBuilder::Kept SceneBuilder::buildOne(const SurfaceInput& input) const
{
  const auto known = std::find_if(this->kept_.begin(), this->kept_.end(),
    [&input](const Kept& kept) { return kept.mesh == input.mesh; });
  if (known != this->kept_.end())
  {
    Kept reused = *known;
    reused.report.name = input.name;
    return reused;
  }
  Kept built;
  built.mesh = input.mesh;
  CleanResult clean = input.mesh ? cleanMesh(*input.mesh) : CleanResult{ {}, {}, "it has no mesh", {} };
  built.report = { input.name, clean.report, clean.refusal };
  built.sourceVertex = std::move(clean.sourceVertex);
  if (clean.ok())
  {
    built.tree = std::make_shared<const SurfaceTree>(std::move(clean.mesh));
  }
  return built;
}

SceneBuildResult SceneBuilder::build(const std::vector<SurfaceInput>& inputs)
{
  std::vector<Kept> built(inputs.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&]
  {
    for (std::size_t i = next.fetch_add(1); i < inputs.size(); i = next.fetch_add(1))
    {
      built[i] = this->buildOne(inputs[i]);
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
  SceneBuildResult result;
  std::vector<Surface> surfaces;
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    const Kept& kept = this->kept_[i];
    result.reports.push_back(kept.report);
    if (kept.tree)
    {
      addSurface(inputs[i], kept.tree, kept.sourceVertex, surfaces, result.reports.back());
    }
  }
  if (!surfaces.empty())
  {
    result.scene = std::make_shared<const Scene>(++this->revision_, std::move(surfaces));
  }
  return result;
}

} // namespace palpate
