// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

/// Position of a contact point on its surface: barycentric coordinates between three vertices.
struct SurfacePoint
{
  std::array<std::uint32_t, 3> vertices{};
  Vec3 weights = Vec3::Zero(); ///< >= 0, add up to 1
  Vec3 x_W = Vec3::Zero();     ///< in the snapshot's free surface
};

/// Members in the order of a recording.
template<class Visit, class Point>
void membersOf(const Visit& visit, Point& at) requires std::is_same_v<std::remove_const_t<Point>, SurfacePoint>
{
  visit(at.vertices);
  visit(at.weights);
  visit(at.x_W);
}

/// Further depth of a ball in a surface beyond that of its patch, in series with it: a function of t, with t^3 the
/// normal force, that rises from 0 with slope 0. Between knots, which are the same for all places of a snapshot, it is
/// a cubic in t, beyond the last one it is linear in the force. Without knots (step 0), as in snapshots of old
/// recordings, it is hertz t^2 - patch t^3 while that rises.
struct SubgridSpring
{
  static constexpr std::size_t knots = 13; ///< the first one at t = 0

  double hertz = 0.0;                  ///< (9 / (16 E*^2 r))^(1/3) [u N^(-2/3)]; 0: no ball, no spring
  double patch = 0.0;                  ///< .6587 / (E* a) [u/N]
  double across = 0.0;                 ///< slope of the tangential compliance of the contact (Mindlin 1949); 0: none
  double step = 0.0;                   ///< of t between knots [N^(1/3)]
  std::array<double, knots> depth_u{}; ///< at the knots
  std::array<double, knots> rise{};    ///< derivative of that by t
};

/// The servo's snapshot of a soft body: its surface without the tool, and the compliance of the vertices near
/// the tool for each other. Immutable; made by a worker (SnapshotMaker), read by the servo.
struct ComplianceSnapshot
{
  static constexpr std::size_t mostVertices = 192; ///< 2.7 MB of compliance

  std::uint32_t version = 0;
  std::uint64_t builtFromTick = 0;    ///< tick of the hand and the forces at which it was linearised
  std::vector<Vec3> free_W;           ///< every vertex of the surface without the tool [u]
  std::vector<std::uint32_t> near;    ///< vertices with compliance: pressed ones that are far, then by distance
  std::vector<std::uint32_t> placeOf; ///< of every vertex: its place in `near`, or that of the nearest one
  Eigen::MatrixXd compliance;         ///< three rows per place [u/N]: symmetric, positive semidefinite
  std::vector<SubgridSpring> springs; ///< of each place, with the same knots
  std::vector<double> patchRadius_u;  ///< of each place
  std::vector<SurfacePoint> forceAt;  ///< points of the forces at which it was linearised
  std::vector<Vec3> force_N;          ///< and those forces
  double energy_Nu = 0.0;             ///< elastic energy, less that of those forces by this compliance
  double residual_N = 0.0;            ///< residual after its Newton steps
  bool struck = false;                ///< the hand is faster than the body can follow: its inertia is not modelled
  /// Largest |F - 1|: from .1 small strain is a few per cent off, from .5 far off. 0 for a body that was not brought to
  /// equilibrium (SnapshotMaker::answerBy).
  double mostGradient = 0.0;

  [[nodiscard]] Mat3 between(std::uint32_t a, std::uint32_t b) const noexcept
  {
    return this->compliance.block<3, 3>(3 * this->placeOf[a], 3 * this->placeOf[b]);
  }
};

} // namespace palpate
