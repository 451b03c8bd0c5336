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

/// The result of an update.
struct ToolUpdate
{
  bool converged = false; ///< the pose is the nearest one to the device's that can be reached
  bool spent = false;     ///< the work was used up; the next update goes on
  bool blocked = false;   ///< no step could be proven, although the nearest pose may be elsewhere
  bool refused = false;   ///< the pose of the device is invalid: nothing was done
  bool leadCut = false;   ///< the rotation to the device is larger than the largest lead
  int steps = 0;
  std::uint64_t work = 0;
};

/// Receives each step that the tool really makes: for tests that judge it.
class StepSink
{
public:
  virtual ~StepSink() = default;
  virtual void step(const ScrewStep& step, double share) = 0;
};

/// The pose of a rigid tool among fixed triangles: it goes to the pose nearest to the device's, in the
/// metric |displacement|^2 + lever^2 |rotation|^2, that it can reach without meeting a triangle. Each pose and each
/// path between two poses is proven to be free by separating planes; an unproven motion is not made. So the tool never
/// passes through a surface, from either side of sheets and soups, and an update may end anywhere.
///
/// Constraint-based motion after Ortega, Redon & Coquillart (2007); the proofs are bounds of interpolation instead
/// of roots of polynomials. Not real-time safe: an update belongs on a thread of its own.
class ToolMove
{
public:
  /// `scene_W`: of makeToolScene() for this tool. `characteristic_u`: lever arm between rotations and displacements.
  ToolMove(const ToolMesh& tool, std::shared_ptr<const BoxedMesh> scene_W, double characteristic_u);

  /// Puts the tool at a pose. Refused in words where it would touch or meet the scene there; then nothing has changed.
  [[nodiscard]] std::string place(const Pose& pose_W);
  [[nodiscard]] bool placed() const noexcept { return this->front_.has_value(); }
  /// Moves towards the device with at most `work` units (WorkBudget). An update whose work was not enough to prove any
  /// step doubles the work of the next one, and an update that moved halves it, so that a lack of work never stops the
  /// tool for good. A step that has begun is completed, and the next updates have so much less. Only after place().
  ToolUpdate update(const Pose& device_W, std::uint64_t work);

  [[nodiscard]] const Pose& pose_W() const noexcept { return this->pose_W_; }
  /// The features that touch at the pose, found by the last update that had enough work.
  [[nodiscard]] const std::vector<TouchRow>& rows() const noexcept { return this->rows_.rows(); }
  [[nodiscard]] const ToolMesh& tool() const noexcept { return this->tool_; }
  /// For the servo: the newest pose and its contacts.
  [[nodiscard]] ToolContacts contacts() const;
  /// Puts the tool at another pose relative to the triangles, which moved on a path that was proven to be free.
  void stand(const Pose& pose_W);
  /// Friction coefficient of each contact from now on (see settledTarget); 0: none.
  void rub(double friction) noexcept { this->friction_ = friction; }
  /// Null: no observer.
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
    Vec6 wish; ///< whitened motion to that pose
  };
  [[nodiscard]] Lead lead(const Pose& device_W, WorkBudget& budget);
  [[nodiscard]] bool makeScratch(WorkBudget& budget);
  struct ProvenStep
  {
    PlannedStep planned;
    StepVerdict verdict;
    bool rests = false; ///< the rows allow no motion
  };
  [[nodiscard]] ProvenStep planProven(const Vec6& wish, WorkBudget& budget);
  [[nodiscard]] Advance advance(const Pose& device_W, WorkBudget& budget);
  [[nodiscard]] double usefulShare(const PlannedStep& planned, const ScrewStep& step, const Pose& device_W);
  /// Makes a share of a step, which is the `proven` share of the one that was asked for last.
  void commit(const ScrewStep& step, double share, double proven);

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
  double usualWay_u_ = 0.0; ///< motion of the hand in an update
  double margin_u_ = 0.0;   ///< for the next gathering
  int idle_ = 0;            ///< consecutive steps without progress
  int starved_ = 0;         ///< doublings of the work of the next update
  std::uint64_t owed_ = 0;  ///< work that was done beyond the grant: the next updates begin by paying for it
  bool gathering_ = false;
  bool behind_ = false; ///< the last update did not come to rest
  bool leadCut_ = false;
  StepSink* sink_ = nullptr;
};

} // namespace palpate
