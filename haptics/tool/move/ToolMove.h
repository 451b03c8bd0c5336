// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "haptics/tool/mesh/ToolMesh.h"
#include "haptics/tool/move/StepPlan.h"
#include "haptics/tool/servo/ToolContacts.h"

namespace palpate
{

/// What an update did.
struct ToolUpdate
{
  bool converged = false; ///< the pose is the nearest one to the device's that can be reached
  bool spent = false;     ///< it ended because the work was used up; the next update goes on
  bool blocked = false;   ///< no step could be proven, although the nearest pose may be elsewhere
  bool refused = false;   ///< the device's pose is none: nothing was done
  bool leadCut = false;   ///< the device is turned further ahead than the tool is led
  int steps = 0;
  std::uint64_t work = 0;
};

/// Told each step that the tool really makes: for tests that judge it.
class StepSink
{
public:
  virtual ~StepSink() = default;
  virtual void step(const ScrewStep& step, double share) = 0;
};

/// The pose of a rigid tool among triangles that stand still: it goes to the pose nearest to the device's, in the
/// metric |way|^2 + lever^2 |turn|^2, that it can reach without meeting anything. Each pose that it takes and each way
/// between two is proven, by planes, to be free; what is not proven is not done. So nothing is ever passed, from no
/// side of sheets and soups either, and an update may end anywhere.
///
/// Constraint-based motion as Ortega, Redon & Coquillart (2007) have it; the proofs are bounds of interpolation instead
/// of roots of polynomials. Not real-time safe: an update belongs on a thread of its own.
class ToolMove
{
public:
  /// `scene_W` as makeToolScene has it for this tool. `characteristic_u`: what a turn of 1 rad weighs as a way.
  ToolMove(const ToolMesh& tool, std::shared_ptr<const BoxedMesh> scene_W, double characteristic_u);

  /// Puts the tool at a pose. Refused in words where it would touch or meet the scene there; then nothing has changed.
  [[nodiscard]] std::string place(const Pose& pose_W);
  [[nodiscard]] bool placed() const noexcept { return this->front_.has_value(); }
  /// Moves towards the device with so much work (WorkBudget); after an update that this was not enough for to prove any
  /// step, with twice as much, and with half of that again after one that moved: so it never stays where it is for want
  /// of work. A step that was begun is ended: the next updates have as much less as it took more. Only after place().
  ToolUpdate update(const Pose& device_W, std::uint64_t work);

  [[nodiscard]] const Pose& pose_W() const noexcept { return this->pose_W_; }
  /// What touches at the pose, found by the last update that was not out of work.
  [[nodiscard]] const std::vector<TouchRow>& rows() const noexcept { return this->rows_.rows(); }
  [[nodiscard]] const ToolMesh& tool() const noexcept { return this->tool_; }
  /// For the servo: the newest pose and what touches there.
  [[nodiscard]] ToolContacts contacts() const;
  /// It stands elsewhere among the triangles: they were moved, and it was proven that nothing met on the way.
  void stand(const Pose& pose_W);
  /// Of each contact from now on (see settledTarget); 0: none.
  void rub(double friction) noexcept { this->friction_ = friction; }
  /// Null: nobody.
  void watch(StepSink* sink) noexcept { this->sink_ = sink; }

private:
  enum class Advance : std::uint8_t
  {
    Moved,
    Rests,
    Blocked,
    Spent,
  };
  void expect(const Pose& device_W);
  void learnNeed(const ToolUpdate& done, bool stands);
  struct Lead
  {
    Pose device_W;
    Vec6 wish; ///< to it, whitened
  };
  [[nodiscard]] Lead lead(const Pose& device_W, WorkBudget& budget);
  [[nodiscard]] bool makeScratch(WorkBudget& budget);
  struct ProvenStep
  {
    PlannedStep planned;
    StepVerdict verdict;
    bool rests = false; ///< the rows leave nothing of the wish
  };
  [[nodiscard]] ProvenStep planProven(const Vec6& wish, WorkBudget& budget);
  [[nodiscard]] Advance advance(const Pose& device_W, WorkBudget& budget);
  [[nodiscard]] double usefulShare(const PlannedStep& planned, const ScrewStep& step, const Pose& device_W);
  void commit(const ScrewStep& step, double share);

  ToolMesh tool_;
  std::shared_ptr<const BoxedMesh> scene_W_;
  double characteristic_u_;
  double restGap_u_;
  double friction_ = 0.0;
  Pose pose_W_;
  std::optional<PairFront> front_;
  NearPairs near_;
  TouchRows rows_;
  Pose device_W_;           ///< of the last update
  double usualWay_u_ = 0.0; ///< of the hand in an update
  double margin_u_ = 0.0;   ///< for the next gathering
  int idle_ = 0;            ///< steps on end that brought nothing
  int starved_ = 0;         ///< doublings of the work of the next update
  std::uint64_t owed_ = 0;  ///< work that was done and not granted: the next updates begin by paying for it
  bool gathering_ = false;
  bool behind_ = false; ///< the last update did not come to rest
  bool leadCut_ = false;
  StepSink* sink_ = nullptr;
};

} // namespace palpate
