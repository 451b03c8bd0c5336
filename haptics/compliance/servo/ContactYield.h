// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "haptics/compliance/servo/SoftSurfaceRef.h"

namespace palpate
{

/// Compliance of the surface at `a` to a force at `b` [u/N]; 0 for walls.
[[nodiscard]] Mat3 complianceOf(const SoftContact& a, const SoftContact& b) noexcept;

[[nodiscard]] std::span<const SoftContact> contactsOf(const SoftState& state) noexcept;

/// True if any touched surface is soft.
[[nodiscard]] bool givesWay(const SoftState& state) noexcept;

/// The smallest soft patch under the ball.
[[nodiscard]] double patchUnder(const SoftState& state) noexcept;

/// The solution for the contact forces.
struct Yield
{
  Vec3 force_N = Vec3::Zero();
  Vec3 across_N = Vec3::Zero();  ///< the part that is friction
  Vec3 yielded_W = Vec3::Zero(); ///< mean displacement of the surfaces under the ball, weighted by their forces
};

/// Sets the displacement of each contact's surface, too.
[[nodiscard]] Yield yieldUnder(SoftState& state) noexcept;

/// Moves the pressing contacts before the others, which have no displacement then. Returns the number of pressing ones.
int pressingFirst(SoftState& state) noexcept;

/// The origin of slip: the core is where the ball would be if all surfaces had yielded alike, and each contact has the
/// ball elsewhere. Kept over the iterations of a tick, in which contacts come and go.
class SlipStart
{
public:
  explicit SlipStart(const SoftState& state) noexcept;
  /// Assigns the origin to the present contacts, by their normals.
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

/// The displacement u for the core: of all those that move every pressing plane as far as it has moved itself,
/// the one nearest to the planes' mean. Walls that yield unequally have no displacement in common, but the ball y
/// touches them all at their present place, so y - u touches them all at their old place: there the core is at rest
/// under the same force. An open plane that it would penetrate is touched, too. More planes than three may conflict,
/// and share the error.
class CommonYield
{
public:
  CommonYield(const SoftState& state, const Vec3& mean_W) noexcept;

  /// For a ball at y_W among the displaced surfaces.
  void stayOut(const Vec3& y_W, double radius_u) noexcept;

  [[nodiscard]] const Vec3& u_W() const noexcept { return this->u_W_; }

private:
  /// Largest displacement of the surfaces along its normal that plane c allows.
  [[nodiscard]] double mostAlong(int c, const Vec3& y_W, double radius_u) const noexcept;
  /// The open plane that the core would penetrate deepest; -1: none.
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
