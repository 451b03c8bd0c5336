// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "haptics/contact/planes/ContactSet.h"

namespace palpate
{

/// A move of a ball round the edges and vertices that hold it: along the old tangent planes, then along the new.
struct RollPlan
{
  bool worthwhile = false;
  Vec3 first = Vec3::Zero();  ///< displacement from x to the corner of old and new tangent planes
  Vec3 second = Vec3::Zero(); ///< displacement from x to the new place
  double turn = 0.0;          ///< tangent of the largest angle any normal was allowed to turn
  int sets = 0;               ///< of planes that were tried on the way to it
  double tolerance_u2 = 0.0;  ///< by how much the squared distance to p may grow and still be progress
};

/// A round contact on its way to a new normal.
struct RollPivot
{
  int row = 0;              ///< index of the touched feature
  FeaturePlane plane;       ///< at x
  Vec3 axis = Vec3::Zero(); ///< unit along an edge, zero for a vertex
  Vec3 w = Vec3::Zero();    ///< unit tangential direction in which the ball wants to go
  double limit = 0.0;       ///< tangent of the largest angle before it comes to lie on an incident face
  double turn = 0.0;        ///< tangent of the largest angle of this roll
  double radius = 0.0;      ///< of the ball and the coat of its feature [u]
};

/// A side of a face, where the ball stops being held by it.
struct RollBorder
{
  Vec3 outward = Vec3::Zero(); ///< unit, in the plane of the face
  Vec3 point_W = Vec3::Zero();
};

/// Plans a roll towards p: tangent planes alone converge like depth / r and diverge for
/// depth > r; the pair of tangents converges quadratically and keeps the way outside of the round obstacle.
/// `solution` is the projection of p - x onto the touched planes, with multipliers l. A normal turns by at
/// most the angle whose tangent is `mostTurn`. One plan per object.
template<SceneView AnyScene>
class RollPlanner
{
public:
  RollPlanner(const ContactSet<AnyScene>& contacts, const Vec3& x_W, const Vec3& p_W, double radius_u,
    const ProjectionResult& solution, double mostTurn) noexcept;
  [[nodiscard]] RollPlan plan() noexcept;

private:
  [[nodiscard]] double heldFraction(const ActiveFeature& f, const Vec3& aim) const noexcept;
  void cutToFace(const ActiveFeature& f, Vec3& aim) noexcept;
  [[nodiscard]] bool landOnBorder(const Vec3& y, Vec3& aim) const noexcept;
  [[nodiscard]] Vec3 creviceAim() noexcept;
  [[nodiscard]] Vec3 arcAim() const noexcept;
  [[nodiscard]] Vec3 pressed(const Vec3& aim) const noexcept;
  [[nodiscard]] Vec3 axisOf(const ActiveFeature& f) const noexcept;
  void chooseTargets(Vec3& aim) noexcept;
  [[nodiscard]] bool correct(const Vec3& y) noexcept;
  [[nodiscard]] ProjectionResult nearest(std::span<const PlaneRow> rows, const Vec3& target) noexcept;

  const ContactSet<AnyScene>& contacts_;
  Vec3 x_W_;
  Vec3 q_;
  double radius_u_;
  const ProjectionResult& solution_;
  double mostTurn_;
  double slack_;
  std::array<PlaneRow, GodObjectState::maxFeatures> rows_;     ///< touched planes, those of the pivots as they will be
  std::array<PlaneRow, GodObjectState::maxFeatures + 3> both_; ///< as they are, and behind them as they will be
  std::array<RollPivot, 3> pivots_;
  int pivotCount_ = 0;
  RollBorder border_;
  bool hasBorder_ = false;
  int sets_ = 0;
};

} // namespace palpate
