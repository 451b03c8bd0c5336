// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/scene/SceneWorker.h"

#include <utility>

#include "haptics/contact/RadiusLimit.h"

namespace palpate
{
namespace
{

double largestRadius(const Scene* scene)
{
  return scene ? radiusLimit(*scene, {}).largest_u : std::numeric_limits<double>::infinity();
}

} // namespace

void SceneWorker::commit(
  std::vector<SceneSurface> surfaces, std::string refusals, double stamp_s, const ScenePart& part)
{
  this->task_.want([this, commit = Commit{ std::move(surfaces), std::move(refusals), stamp_s, part }](
                     const std::stop_token&) mutable { return this->begin(std::move(commit)); });
}

void SceneWorker::follow(std::shared_ptr<const Scene> felt)
{
  this->felt_ = std::move(felt);
  this->task_.resume();
}

LatestTask<BuiltScene>::Work SceneWorker::begin(Commit commit)
{
  // Surfaces that only move wait for nothing: a pose is felt with the next snapshot, and balls keep their largest
  // radius.
  const bool known = this->builder_.knows(inputsOf(commit.surfaces));
  this->watch_ = std::make_shared<BuildWatch>();
  this->watch_->expect(1); // the largest ball, found once all is built: until then something is left to do
  auto build = [this, known, commit = std::move(commit), felt = this->felt_, largest_u = this->largestRadius_u_,
                 watch = this->watch_]
  {
    BuiltScene built = buildScene(this->builder_, commit.surfaces, felt.get(), watch.get());
    if (watch->cancelled())
    {
      return built;
    }
    built.report = commit.refusals + built.report;
    built.stamp_s = commit.stamp_s;
    built.part = commit.part;
    built.bounds = commit.part.whole != 0 ? commit.part.bounds_W : built.bounds;
    built.plane_WP = commonPlane(commit.surfaces);
    built.largestRadius_u = known ? largest_u : largestRadius(built.scene.get());
    return built;
  };
  return { std::move(build), known };
}

void SceneWorker::cancel()
{
  this->task_.cancel();
  if (this->watch_)
  {
    this->watch_->cancel();
  }
}

std::optional<BuiltScene> SceneWorker::noted(std::optional<BuiltScene> built)
{
  this->largestRadius_u_ = built ? built->largestRadius_u : this->largestRadius_u_;
  return built;
}

} // namespace palpate
