// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "haptics/session/scene/BuiltScene.h"
#include "haptics/session/scene/CameAround.h"
#include "haptics/session/scene/SceneWorker.h"
#include "haptics/session/scene/SimplerSearch.h"
#include "haptics/session/scene/SimplifyPlan.h"

namespace palpate
{

class HapticSession;

/// Decides which of the scenes that a worker builds a session feels: all triangles at first, simpler surfaces once they
/// are proven to feel the same, and the motion of surfaces from one scene to the next. One thread, the session's owner,
/// calls every method.
class FeltScene
{
public:
  /// `session` outlives it. `period_s`: of its ticks.
  FeltScene(HapticSession& session, double period_s) : session_(session), period_s_(period_s) {}

  /// Hands over a scene that is to be built.
  [[nodiscard]] SceneWorker& worker() noexcept { return this->worker_; }
  /// To be called before a commit: the changes of the commit start from the felt scene.
  void beforeCommit();
  /// From where the hand is seen in a view [u]; nothing: it is where it is felt.
  void seeFrom(const std::optional<Vec3>& eye_W) { this->eye_W_ = eye_W; }

  /// Has the session feel a scene that the worker has finished, or with `wait` the newest that was committed. True if
  /// there was one. `now_s`: on the clock of the commits.
  bool takeBuilt(const SimplifyPlan& plan, double now_s, bool wait = false);
  /// Has it feel the simpler surfaces that were found since, or with `wait` those that are looked for.
  void takeSimpler(bool wait = false);
  /// Another part of the whole that the scene is a part of is asked for; 0: no more. Too long without it, and the hand
  /// is let go.
  void ask(std::uint64_t request);

  /// Once surfaces that moved rest: whether they had left the ball no space and it is now in one that it was outside
  /// of. Then the ball comes from outside again, and cameAround() says so.
  bool takeOutSqueezed();
  /// Plans again, from all triangles on, after a change of the inputs of the choice.
  void follow(const SimplifyPlan& plan);

  /// Surfaces that the last scene, or its motion, moved over the hand; the hand stays outside of them.
  [[nodiscard]] const std::optional<CameAround>& cameAround() const noexcept { return this->around_; }

  /// As the session has it.
  [[nodiscard]] const BuiltScene& built() const noexcept { return this->built_; }
  [[nodiscard]] bool isSimpler() const noexcept { return this->built_.scene != this->full_.scene; }
  /// The part in use of each surface, and the reason.
  [[nodiscard]] const std::vector<SurfaceChoice>& choices() const noexcept { return this->choices_; }
  /// From the commit of that scene until the servo could have it [s].
  [[nodiscard]] double handOver_s() const noexcept { return this->handOver_s_; }
  /// Whether the session's last tick felt this scene, or nothing is felt: then the ball may change. In the tick of a
  /// swap a pressed hand changes over.
  [[nodiscard]] bool isTaken();
  /// Whether the moved surfaces have rested for a while: its poses may go into the vertices, which costs less to touch.
  [[nodiscard]] bool rests();

private:
  void plan(const SimplifyPlan& plan);
  void lookAround(const Scene* next);
  void tellKnown();
  [[nodiscard]] bool hasMoved() const;
  void swapIn(std::optional<FoundScene> found);

  HapticSession& session_;
  double period_s_;
  SceneWorker worker_;
  SimplerSearch search_;
  BuiltScene built_;  ///< its scene as the session has it, with motions
  BuiltScene full_;   ///< the same with all triangles of the data
  SimplifyPlan plan_; ///< that `choices_` were made by
  std::vector<SurfaceChoice> choices_;
  double handOver_s_ = 0.0;
  std::shared_ptr<const Scene> lastFelt_; ///< the newest that the servo is known to have taken
  std::optional<Vec3> eye_W_;
  std::optional<CameAround> around_;
  std::vector<std::string> within_; ///< closed surfaces that the ball was in when surfaces rested last
  std::uint64_t pinned_ = 0;        ///< ticks without space for the ball until then
};

} // namespace palpate
