// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "haptics/force/WorkspaceMap.h"

namespace palpate
{

/// Where a hand is: in its device [m], and in the scene [u] as the last tick had it.
struct HandPlace
{
  Vec3 p_D = Vec3::Zero();
  Vec3 p_W = Vec3::Zero();
};

/// The rotation from a device to the scene in which the device's x, y and z (right, up and towards the person) are
/// right, up and towards the camera of a view. `right_W` and `up_W`: of the camera; none if they span no plane.
[[nodiscard]] std::optional<Quat> viewRotation(const Vec3& right_W, const Vec3& up_W);

/// The map with the same scale and rotation that has the hand where it is.
[[nodiscard]] WorkspaceMap keepingHand(WorkspaceMap map, const HandPlace& hand);

/// The corners of the box around the ball that a device reaches, in the order of the bits x, y, z [u].
[[nodiscard]] std::array<Vec3, 8> workspaceCorners(const WorkspaceMap& map, double radius_m);

/// The controls that a person holds, and the rotation of the view.
struct HandWishes
{
  bool clutch = false;      ///< the device is moved and the hand is not
  bool precise = false;     ///< the same displacement of the device moves the hand less,
  double precision = 5.0;   ///< by this factor, at least 1
  std::optional<Quat> q_WD; ///< the rotation that is wanted; none: as it is
};

/// How the workspace of a device lies in the scene from now on.
struct HandMapChange
{
  WorkspaceMap map;
  bool clutch = false; ///< the hand stays where it is, whatever the device does
};

/// Applies the controls that the person holds to the map. No change moves the hand: scale and rotation are about the
/// place of the hand, and a device that was moved while the clutch was held goes on from where it is then.
class HandMap
{
public:
  /// The change that is due now; none: nothing. `now`: the map, with the precision that was asked for before.
  [[nodiscard]] std::optional<HandMapChange> follow(
    const HandWishes& wishes, const WorkspaceMap& now, const HandPlace& hand);
  /// The map is set anew, with no precision in it and no clutch.
  void reset() noexcept { *this = HandMap(); }
  /// By which the scale of the map is smaller than without precision.
  [[nodiscard]] double factor() const noexcept { return this->factor_; }

private:
  bool clutched_ = false;
  double factor_ = 1.0;
};

} // namespace palpate
