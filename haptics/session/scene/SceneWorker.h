// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/geometry/scene/BuildWatch.h"
#include "haptics/session/background/LatestTask.h"
#include "haptics/session/scene/BuiltScene.h"

namespace palpate
{

/// Builds scenes off the caller's thread, one at a time, the newest that was committed next. One thread calls every
/// method.
class SceneWorker
{
public:
  SceneWorker() = default;
  /// Waits for the thread.
  ~SceneWorker() { this->cancel(); }
  SceneWorker(const SceneWorker&) = delete;
  SceneWorker& operator=(const SceneWorker&) = delete;

  /// `refusals`: lines about refused inputs, at the head of the report. While a build is running the
  /// newest commit waits for it; one that only moves surfaces is done at once. `stamp_s`: when it was so, on the
  /// caller's clock. `part`: the whole that they are a part of.
  void commit(std::vector<SceneSurface> surfaces, std::string refusals, double stamp_s, const ScenePart& part = {});
  /// The present scene, from where vertices of the next builds come; null: from nowhere. The commit that waits begins:
  /// commits may come faster than builds for as long as they like, and each build is felt and followed by the next.
  void follow(std::shared_ptr<const Scene> felt);
  /// Nothing comes from elsewhere any more: the next trees have no memory for motions.
  void forget() { this->felt_.reset(); }
  [[nodiscard]] bool building() const { return this->task_.running(); }
  /// Built share of the commit, 0 to 1; 1 without a build.
  [[nodiscard]] double share() const { return this->building() ? this->watch_->share() : 1.0; }
  /// Cancels the commit: the build ends before its next step, without a result.
  void cancel();

  /// The newest scene that is done, once. A commit that waits begins with follow().
  std::optional<BuiltScene> poll() { return this->noted(this->task_.poll()); }
  /// The scene of the newest commit, waiting for it. Nothing if no commit is open.
  std::optional<BuiltScene> wait() { return this->noted(this->task_.wait()); }
  /// For a scene that is made from one of the worker's.
  std::uint64_t takeRevision() { return this->builder_.takeRevision(); }

private:
  struct Commit
  {
    std::vector<SceneSurface> surfaces;
    std::string refusals;
    double stamp_s = 0.0;
    ScenePart part;
  };

  [[nodiscard]] LatestTask<BuiltScene>::Work begin(Commit commit);
  std::optional<BuiltScene> noted(std::optional<BuiltScene> built);

  SceneBuilder builder_{ 2 }; ///< the running build's while there is one
  std::shared_ptr<const Scene> felt_;
  std::shared_ptr<BuildWatch> watch_;                                ///< over the running build
  double largestRadius_u_ = std::numeric_limits<double>::infinity(); ///< of the last scene that was not only moved
  LatestTask<BuiltScene> task_;                                      ///< last: it ends before the members it uses
};

} // namespace palpate
