// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "haptics/tool/move/StepProof.h"
#include "haptics/tool/move/TouchFeature.h"
#include "haptics/tool/solve/NearestMotion.h"

namespace palpate
{

/// A feature that touches, linear in the step to be made: its gap is offset_u + n . (v + w x arm).
struct TouchRow
{
  TouchFeature feature;
  TouchPlane plane;      ///< at the pose where the feature was found, with its gap there
  double offset_u = 0.0; ///< gap for a step of zero, extrapolated from the pose where the feature was found

  [[nodiscard]] double linear_u(const ScrewStep& step) const noexcept
  {
    return this->offset_u + this->plane.n_W.dot(step.v_W + step.w_W.cross(this->plane.arm_W));
  }
};

class RowCells;

/// Finds rows. Rows of the same plane and point are taken once.
class TouchRows
{
public:
  TouchRows(const BoxedMesh& tool_B, const BoxedMesh& scene_W, double restGap_u);
  ~TouchRows();
  TouchRows(TouchRows&& other) noexcept;

  /// All features that touch at the pose of the tool.
  void findTouching(NearPairs& near, const Pose& pose_W, double way_u);
  /// Features that block a step after the share that was proven. False if none of them is new.
  bool addBlocking(const NearPairs& near, const ScrewStep& step, const StepVerdict& verdict);
  /// Number of pairs of triangles that were searched for features.
  [[nodiscard]] std::uint64_t asked() const noexcept { return this->asked_; }
  [[nodiscard]] const std::vector<TouchRow>& rows() const noexcept { return this->rows_; }

private:
  /// The pose at which features are searched, and the step to it, which a row leaves out.
  struct Place
  {
    Mat3 turn;
    Vec3 centre_W;
    ScrewStep made; ///< the part of the step that leads there
  };
  /// Number of added rows, and a lower bound of the distance of the two triangles.
  struct Added
  {
    std::size_t count = 0;
    double apart_u = 0.0;
  };
  Added addPair(const NearPairs& near, const Place& place, std::uint32_t tool, std::uint32_t scene, double within_u);
  std::size_t addLeaves(const NearPairs& near, const Place& place, const LeafPair& pair, double within_u);
  std::size_t addDoubtful(const NearPairs& near, const Place& place, const DoubtfulPair& doubt);
  bool add(const TouchFeature& feature, const Place& place);

  const BoxedMesh& tool_B_;
  const BoxedMesh& scene_W_;
  double restGap_u_;
  std::vector<TouchRow> rows_;
  std::unique_ptr<RowCells> cells_; ///< of rows_
  std::uint64_t asked_ = 0;
  std::vector<TouchFeature> found_; ///< kept for its memory
};

} // namespace palpate
