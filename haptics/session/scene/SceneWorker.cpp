// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/scene/SceneWorker.h"

#include <chrono>
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

SceneWorker::~SceneWorker()
{
  this->cancel();
  this->wait();
}

void SceneWorker::commit(
  std::vector<SceneSurface> surfaces, std::string refusals, double stamp_s, const ScenePart& part)
{
  Commit commit{ std::move(surfaces), std::move(refusals), stamp_s, part };
  if (this->running_.valid())
  {
    this->next_ = std::move(commit);
    return;
  }
  this->launch(std::move(commit));
}

void SceneWorker::follow(std::shared_ptr<const Scene> felt)
{
  this->felt_ = std::move(felt);
  this->resume();
}

void SceneWorker::resume()
{
  if (this->next_ && !this->running_.valid())
  {
    this->launch(*std::exchange(this->next_, std::nullopt));
  }
}

void SceneWorker::launch(Commit commit)
{
  this->next_.reset();
  // What only moves waits for nobody: a pose is felt with the next snapshot, and balls stay as large as they may be.
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
  this->running_ = std::async(known ? std::launch::deferred : std::launch::async, std::move(build));
  if (known)
  {
    this->running_.wait();
  }
}

void SceneWorker::cancel()
{
  this->next_.reset();
  if (this->running_.valid())
  {
    this->watch_->cancel();
  }
}

std::optional<BuiltScene> SceneWorker::poll()
{
  if (!this->running_.valid() || this->running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
  {
    return std::nullopt;
  }
  BuiltScene built = this->running_.get();
  if (this->watch_->cancelled()) // also where that came too late to end the build
  {
    this->resume();
    return std::nullopt;
  }
  this->largestRadius_u_ = built.largestRadius_u;
  return built;
}

std::optional<BuiltScene> SceneWorker::wait()
{
  std::optional<BuiltScene> newest;
  while (this->running_.valid())
  {
    this->running_.wait();
    newest = this->poll();
    this->resume();
  }
  return newest;
}

} // namespace palpate
