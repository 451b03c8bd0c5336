// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "haptics/compliance/servo/SoftSurfaceRef.h"

namespace palpate
{

/// How the surface at `a` answers to a force at `b` [u/N]; walls do not.
[[nodiscard]] Mat3 complianceOf(const SoftContact& a, const SoftContact& b) noexcept;

[[nodiscard]] std::span<const SoftContact> contactsOf(const SoftState& state) noexcept;

/// Whether anything touched gives way.
[[nodiscard]] bool givesWay(const SoftState& state) noexcept;

/// The smallest soft patch under the ball.
[[nodiscard]] double patchUnder(const SoftState& state) noexcept;

/// The solution for the contact forces.
struct Yield
{
  Vec3 force_N = Vec3::Zero();
  Vec3 across_N = Vec3::Zero();  ///< the part that is friction
  Vec3 yielded_W = Vec3::Zero(); ///< of the surfaces under the ball, the more the harder they are pressed
};

/// Sets how far each contact's surface has gone, too.
[[nodiscard]] Yield yieldUnder(SoftState& state) noexcept;

/// Brings those that press before the others, which have not yielded then. Returns how many press.
int pressingFirst(SoftState& state) noexcept;

/// From where slip counts: the core is where the ball would be if all had yielded alike, and each contact has the ball
/// elsewhere. Kept over the turns of a tick, in which contacts come and go.
class SlipStart
{
public:
  explicit SlipStart(const SoftState& state) noexcept;
  /// Gives it to the contacts that are there now, by their normals.
  void tell(SoftState& state) const noexcept;

private:
  struct Place
  {
    std::uint32_t surface = 0;
    Vec3 n = Vec3::Zero();
    Vec3 aside_W = Vec3::Zero();
  };
  std::array<Place, GodObjectState::maxFeatures> places_;
  int count_ = 0;
};

/// The yield u that the core is told: of all those that take every plane which presses as far as it has gone itself,
/// the one nearest to the planes' mean. Walls that yield unequally have no yield in common, but the ball y touches them
/// all where they have gone to, so y - u touches them all where they were: there the core is at rest under the same
/// force. An open plane that it would be in is touched, too. More planes than three may contradict each other, and
/// share the rest.
class CommonYield
{
public:
  CommonYield(const SoftState& state, const Vec3& mean_W) noexcept;

  /// For a ball at y_W among the surfaces where they have gone to.
  void stayOut(const Vec3& y_W, double radius_u) noexcept;

  [[nodiscard]] const Vec3& u_W() const noexcept { return this->u_W_; }

private:
  /// How far plane c lets the surfaces have gone along its normal.
  [[nodiscard]] double mostAlong(int c, const Vec3& y_W, double radius_u) const noexcept;
  /// The open plane that the core would be deepest in; -1: none.
  [[nodiscard]] int deepest(const Vec3& y_W, double radius_u) const noexcept;
  void touches(int c, double along_u) noexcept;
  [[nodiscard]] Vec3 solved_W() const noexcept;

  const SoftState& state_;
  Vec3 mean_W_;
  Mat3 planes_ = Mat3::Zero();
  int count_ = 0; ///< of planes that it touches
  Vec3 missed_W_ = Vec3::Zero();
  std::array<bool, GodObjectState::maxFeatures> touched_{};
  Vec3 u_W_;
};

} // namespace palpate
