// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "haptics/mechanism/sided/StandingMeshes.h"
#include "haptics/tool/certify/TrianglePair.h"
#include "haptics/tool/motion/ScrewStep.h"
#include "haptics/tool/motion/WorkBudget.h"

namespace palpate
{

/// Where a motion meets a mesh that stands.
struct MetPlace
{
  int mesh = 0;       ///< of those that stand
  double share = 1.0; ///< of the motion: so far this place is proven to stay free
  double seen = 1.0;  ///< the share at which the place is seen, a little further on
  NearestPair at;     ///< where, at that share
};

/// How far a motion of the mesh in the hand is free, and where that ends.
struct FreeWay
{
  static constexpr int most = 4;

  double share = 1.0; ///< of the motion, proven
  bool spent = false; ///< the work was used up before that was known
  int count = 0;
  std::array<MetPlace, most> met{}; ///< the first ones: all that are met at much the same time
};

/// Proves in a tick that the mesh in the hand goes through no mesh that stands: each pair of triangles that may meet in
/// the motion is kept apart by a plane all along (PairProof), as those of a rigid tool are. Pairs that meet where the
/// motion begins, and triangles behind others, are left out, so that bodies that begin in one another come apart.
/// Real-time safe.
class StandingGuard
{
public:
  static constexpr double gap = 5e-6; ///< of the size of the mesh in the hand: so far triangles stay apart
  /// Likewise of the contacts of both meshes. A corner of a mesh that turns about another one goes along an arc, and is
  /// nearer in the middle of a tick than at its ends: by an eighth of its arm times the square of the turn.
  static constexpr double rest = 2e-5;
  static constexpr double mostTurn_rad = 0.01; ///< in a tick, so that this is no more than the difference of both
  static constexpr double sameNormal = 0.9999; ///< cosine between the normals of places that are one contact

  /// Null: nothing is guarded.
  explicit StandingGuard(const StandingMeshes* meshes) noexcept;

  [[nodiscard]] bool guards() const noexcept { return this->meshes_ != nullptr; }
  [[nodiscard]] double rest_u() const noexcept { return rest * this->size_u_; }
  /// Places that are nearer, and whose normals agree, are one contact.
  [[nodiscard]] double samePlace_u() const noexcept { return 1e-3 * this->size_u_; }
  [[nodiscard]] double friction(int mesh) const noexcept { return this->meshes_->friction(mesh); }
  /// How far the mesh may go.
  [[nodiscard]] FreeWay look(const ScrewStep& way, WorkBudget& budget) const noexcept;

private:
  const StandingMeshes* meshes_;
  double size_u_ = 0.0, reach_u_ = 0.0;
};

/// The motion from one pose to another: the centre on a straight line, turning evenly.
[[nodiscard]] ScrewStep wayOf(const Pose& from_W, const Pose& to_W) noexcept;

} // namespace palpate
