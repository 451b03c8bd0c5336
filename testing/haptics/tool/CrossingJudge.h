// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/tool/move/ToolMove.h"

namespace palpate::test
{

/// Counts in exact arithmetic which triangles of a tool meet which of a scene: CGAL's predicates on the rounded corners
/// of the posed tool. Nothing of the code under test but the tool's body and the steps that it made.
class CrossingJudge : public StepSink
{
public:
  /// `inside`: poses judged within each step, beside its end.
  CrossingJudge(const BoxedMesh& tool_B, const BoxedMesh& scene_W, int inside);

  void step(const ScrewStep& step, double share) override;
  /// Pairs that meet at a pose.
  [[nodiscard]] std::size_t crossings(const Vec3& centre_W, const Mat3& turn) const;
  [[nodiscard]] std::size_t found() const noexcept { return this->found_; }
  [[nodiscard]] std::size_t judged() const noexcept { return this->judged_; }
  /// Only every so many steps is looked at.
  void sparse(std::size_t every) noexcept { this->every_ = every; }

private:
  [[nodiscard]] std::vector<std::uint32_t> near(const Eigen::AlignedBox3d& bounds) const;

  TriangleMesh tool_B_, scene_W_;
  std::vector<Eigen::AlignedBox3d> sceneBoxes_;
  int inside_;
  std::size_t every_ = 1, steps_ = 0, found_ = 0, judged_ = 0;
};

} // namespace palpate::test
