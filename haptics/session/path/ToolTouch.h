// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "haptics/tool/move/ToolMove.h"
#include "haptics/tool/servo/ToolForce.h"

namespace palpate
{

/// How a hand holds a tool.
struct ToolHold
{
  double stiffness_N_per_m = 1000.0; ///< of the spring from the hand to where the tool can be, > 0
  double scale_u_per_m = 1.0;        ///< > 0
  std::optional<double> lever_u;     ///< what a turn by 1 rad weighs as a way; none: that of the tool about its handle
  ToolCoupling coupling = ToolCoupling::Constraints;
  double friction = 0.0; ///< of each contact (settledWish()), 0 to largestToolFriction
};

/// Where a tool is while the hand is somewhere, and what the hand feels. Poses are those of the frame in which the
/// tool's mesh was given, whose origin is held.
struct ToolTouched
{
  Pose pose_W;
  Wrench wrench_W;      ///< on the hand, about the handle [N], [N m]
  int contacts = 0;     ///< that push
  bool settled = false; ///< the pose is the nearest one to the hand's that can be reached
  bool leadCut = false; ///< the hand is turned further than a tool is led
};

/// A rigid tool along a path of the hand that is known before, as far as it comes at each place in unlimited time,
/// without a device.
class ToolTouch
{
public:
  /// At the first pose of the path. Null with `refusal` in words: of the tool, of the hold, of a scene without
  /// triangles or too far away, of a pose where the tool would meet the scene.
  [[nodiscard]] static std::unique_ptr<ToolTouch> make(const TriangleMesh& tool, const TriangleMesh& scene_W,
    const ToolHold& hold, const Pose& first_W, std::string& refusal);

  /// The hand goes there. A pose that is none (ToolMesh.h) leaves the tool where it was, not settled.
  [[nodiscard]] ToolTouched next(const Pose& hand_W);
  /// See noWayOut().
  [[nodiscard]] const std::string& noWayOut() const noexcept { return this->noWayOut_; }

private:
  ToolTouch(const ToolMesh& tool, std::shared_ptr<const BoxedMesh> scene_W, const ToolHold& hold);

  ToolHold hold_;
  ToolMove move_;
  std::string noWayOut_;
};

} // namespace palpate
