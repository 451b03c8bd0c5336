// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "haptics/contact/GodObject.h"
#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/support/NearestPoints.h"
#include "testing/support/PathChecker.h"
#include "testing/support/RandomHand.h"
#include "testing/support/SoupMaker.h"
#include "testing/support/TickJudge.h"

namespace palpate::test
{

/// The sums of many ticks under a random hand: faults of single ticks, and four more that must be 0.
struct RunFigures : TickFigures
{
  std::uint64_t fallen = 0;    ///< ticks whose path met the clean closed shape, or sank deeper than its gaps allow
  std::uint64_t stuck = 0;     ///< the segment to the hand was free and the ball did not come in many ticks
  std::uint64_t restless = 0;  ///< the hand kept still and the ball still moved
  std::uint64_t notAtRest = 0; ///< where the ball stood it could have gone on towards the hand
  std::uint64_t touching = 0;
  std::uint64_t pulls = 0; ///< times the hand pulled away on a free path
  std::uint64_t rests = 0; ///< times it kept still with something touched
  std::uint64_t infeasible = 0;
  std::uint64_t work = 0;
  std::uint64_t mostWork = 0; ///< of one tick
  double spent = 0.0;         ///< energy of the hand into the spring, [depth^2], stiffness 1
  double created = 0.0;       ///< energy that the ball's own motion added to it: must be rounding

  [[nodiscard]] bool clean() const noexcept;
  RunFigures& operator+=(const RunFigures& more);
  [[nodiscard]] std::string text() const;
};

/// A mesh with its judges of paths.
struct JudgedMesh
{
  explicit JudgedMesh(TriangleMesh clean);

  TriangleMesh mesh;
  NearestPoints nearest;
  PathChecker path;
};

/// A surface to be touched for a long time and how it is judged.
struct RunTask
{
  std::shared_ptr<const Scene> scene;
  const JudgedMesh* touched = nullptr; ///< the scene's one mesh, cleaned
  const JudgedMesh* shape = nullptr;   ///< the shape that must not be passed although `touched` has gaps, or null
  double gap_u = 0.0;                  ///< of `touched` against `shape`
  double size_u = 1.0;                 ///< largest extent
  ContactPlan plan;
  bool inside = false; ///< which side the ball begins on: that the normals point away from
  std::uint64_t seed = 0;
};

/// A bad mesh to be touched, judged against itself and its clean shape; the meshes must outlive the task.
[[nodiscard]] RunTask taskOn(const BadMesh& made, const JudgedMesh& touched, const JudgedMesh& shape);

/// A random hand leads a ball over a surface; every tick is judged by itself (TickJudge.h), now and then the hand keeps
/// still or pulls freely away and an oracle says where the ball had to be.
class LongRun final : private PathSink
{
public:
  /// The meshes must outlive it. Under friction nothing is said about where the ball rests.
  explicit LongRun(const RunTask& task);

  /// False where a ball of this radius does not fit on that side: nothing can be run.
  [[nodiscard]] bool placed() const noexcept { return this->placed_; }
  void run(std::uint64_t ticks);
  [[nodiscard]] RunFigures figures() const;

private:
  void segment(const Vec3& from_W, const Vec3& to_W) noexcept override;
  [[nodiscard]] bool place();
  ContactResult tick(const Vec3& p_W);
  void judgeEnergy(const Vec3& before_W, const Vec3& p_W);
  void judgeShape(const Vec3& before_W);
  void keepStill();
  void pullAway();
  void judgeRest(const ContactResult& result);
  [[nodiscard]] bool pointCouldGoOn();
  [[nodiscard]] bool ballCouldGoOn() const;
  [[nodiscard]] bool freeWay(const Vec3& to_W);
  void note(std::uint64_t& count, const std::string& what);

  RunTask task_;
  TickJudge judge_;
  PathChecker wayChecker_; ///< for segments that are only asked for
  std::optional<PathChecker> shapeChecker_;
  Random random_;
  double depth_u_;
  RandomHand hand_;
  GodObjectState state_;
  Vec3 p_W_ = Vec3::Zero();
  bool placed_ = false;
  RunFigures figures_; ///< without those of judge_
};

} // namespace palpate::test
