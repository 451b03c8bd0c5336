// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/tool/motion/WorkBudget.h"
#include "haptics/tool/pairs/BoxGap.h"

namespace palpate
{

/// Two boxes, and the path length of the tool up to which they cannot touch.
struct BoxPair
{
  std::uint32_t tool = 0, scene = 0; ///< nodes of the two trees
  double key_u = 0.0;                ///< proven gap plus path length then; less the path length now: a lower bound
};

/// The leaves of tool and scene that may come near. Every pair of triangles lies below exactly one pair of boxes: of
/// the front, whose bounds stay valid under motion, or of the list of near leaves. Pairs outside of the list are
/// further away than the motion that is left, so that only the list is examined while the tool moves within that.
class PairFront
{
public:
  PairFront(const BoxedMesh& tool_B, const BoxedMesh& scene_W, double restGap_u);

  /// Finds all leaves within a margin of the tool at its pose, or continues an unfinished search. False: the budget was
  /// used up; until the search has ended no motion is left, and the tool must stay where it is.
  bool gather(const Pose& pose_W, double margin_u, WorkBudget& budget);
  /// Motion that is left to the tool before it gathers again [u].
  [[nodiscard]] double room_u() const noexcept;
  /// Sum of all motion [u].
  [[nodiscard]] double way_u() const noexcept { return this->way_u_; }
  [[nodiscard]] double margin_u() const noexcept { return this->margin_u_; }
  /// The tool moved, no point of it by more than `way_u`, and rotated.
  void moved(double way_u, double turn_rad) noexcept
  {
    this->way_u_ += way_u;
    this->turned_rad_ += turn_rad;
  }
  [[nodiscard]] const std::vector<BoxPair>& near() const noexcept { return this->near_; }

private:
  /// Pairs of boxes outside of the list. The keys are read first, and lie together.
  struct Beyond
  {
    std::vector<double> keys_u;
    std::vector<BoxPair> pairs;
    std::vector<BoxPlane> planes;

    [[nodiscard]] std::size_t size() const noexcept { return this->keys_u.size(); }
    void clear();
    void add(const BoxPair& pair, const BoxPlane& plane);
    void remove(std::size_t at);
  };
  void begin(const BoxPose& pose, double margin_u, WorkBudget& budget);
  void prefetch() const noexcept;
  void visit(const BoxPair& pair, const BoxPose& pose);
  void split(const BoxPair& pair, bool tool);
  void shrink();

  const BoxedMesh& tool_B_;
  const BoxedMesh& scene_W_;
  double restGap_u_;
  double way_u_ = 0.0;      ///< sum of all motion
  double turned_rad_ = 0.0; ///< likewise
  double gathered_u_ = 0.0; ///< that sum when the list was made
  double margin_u_ = 0.0;
  Beyond front_;
  std::vector<BoxPair> near_, pending_;
  std::size_t touching_ = 0;   ///< of the list
  std::size_t freshFront_ = 0; ///< size of the front after it was last built from the roots
};

} // namespace palpate
