// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/tool/motion/WorkBudget.h"
#include "haptics/tool/pairs/BoxGap.h"

namespace palpate
{

/// Two boxes, and how far the tool can go before they may touch.
struct BoxPair
{
  std::uint32_t tool = 0, scene = 0; ///< nodes of the two trees
  double key_u = 0.0;                ///< gap, plus the way of the tool when it was proven: less the way since, a bound
};

/// Which leaves of tool and scene may come near. Every pair of triangles lies below exactly one pair of boxes: of the
/// front, with a bound that outlasts all motion, or of the list of near leaves. What is outside of the list is further
/// away than the room that is left, so that only the list is looked at while the tool moves within it.
class PairFront
{
public:
  PairFront(const BoxedMesh& tool_B, const BoxedMesh& scene_W, double restGap_u);

  /// Finds all leaves within a margin of the tool where it stands, or goes on with that. False: the budget was spent on
  /// the way; until it goes on there is no room, and the tool must stay where it is.
  bool gather(const Pose& pose_W, double margin_u, WorkBudget& budget);
  /// How far the tool may move before it gathers again [u].
  [[nodiscard]] double room_u() const noexcept;
  /// Sum of all motion.
  [[nodiscard]] double way_u() const noexcept { return this->way_u_; }
  [[nodiscard]] double margin_u() const noexcept { return this->margin_u_; }
  /// The tool moved, no point of it by more, and turned.
  void moved(double way_u, double turn_rad) noexcept
  {
    this->way_u_ += way_u;
    this->turned_rad_ += turn_rad;
  }
  [[nodiscard]] const std::vector<BoxPair>& near() const noexcept { return this->near_; }

private:
  /// Pairs of boxes beyond the list. The keys are looked at first, and lie together.
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
  double way_u_ = 0.0;      ///< of all motion
  double turned_rad_ = 0.0; ///< likewise
  double gathered_u_ = 0.0; ///< that sum when the list was made
  double margin_u_ = 0.0;
  Beyond front_;
  std::vector<BoxPair> near_, pending_;
  std::size_t touching_ = 0;   ///< of the list
  std::size_t freshFront_ = 0; ///< size of the front after it was last built from the roots
};

} // namespace palpate
