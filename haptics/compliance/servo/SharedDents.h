// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "haptics/compliance/servo/SoftSurfaceRef.h"

namespace palpate
{

/// The dents of a ball below the patches of its contacts (SubgridSpring).
///
/// Where several planes at nearly one point hold a ball, there is one dent, not one each: on a vertex whose faces are
/// almost flat it is as deep as on the flat. With k(c, e) = sharedBy(), 1 for one point and 0 for distant ones, the
/// force on the dent at e is F_e = sum_c k(c, e) f_c n_c, and all dents store sum_e w_e U_e(|F_e|), w_e = 1 / sum_c
/// k(c, e), U_e being the energy of the spring at e. So contacts that coincide have one dent under their whole force,
/// distant ones have one each, without a step in between. The depth of the ball at c is the derivative by f_c n_c, and
/// its slopes are symmetric and positive semidefinite.
///
/// Along the surface a dent has the compliance of a contact of its width (Mindlin 1949): `across` times the spring's
/// slope under its normal force, for the tangential forces of all contacts. Real-time safe.
class SharedDents
{
public:
  /// The contacts must outlive it, at the same points.
  explicit SharedDents(std::span<const SoftContact> contacts) noexcept;

  /// The slopes: secants from zero to the present force, or tangents there.
  enum class Line : std::uint8_t
  {
    Secant,
    Tangent,
  };
  /// Takes the present forces of the contacts. A dent under less than `least_N_per_u` of its patch has the secant of
  /// that force. True if all dents have the forces of the last call, but for rounding.
  bool press(Line line = Line::Secant, double least_N_per_u = 0.0) noexcept;

  /// Further depth of the ball at a contact [u], in W against its normal.
  [[nodiscard]] Vec3 depthAt(int c) const noexcept;
  /// Tangential displacement of the contact under the contacts' tangential forces [u], in W with them.
  [[nodiscard]] Vec3 asideAt(int c) const noexcept;
  /// Tangential displacement of c under such a force of d, each across its own normal [u/N].
  [[nodiscard]] double acrossBetween(int c, int d) const noexcept;
  /// Derivative of the depth along c's normal by the normal force of d [u/N].
  [[nodiscard]] double slopeBetween(int c, int d) const noexcept;
  [[nodiscard]] double energy() const noexcept; ///< [N u]

private:
  static constexpr std::size_t most = GodObjectState::maxFeatures;
  [[nodiscard]] int count() const noexcept { return static_cast<int>(this->contacts_.size()); }
  [[nodiscard]] Vec3 forceOn(int e) const noexcept;

  std::span<const SoftContact> contacts_;
  std::array<std::array<double, most>, most> share_{};
  std::array<double, most> weight_{};              ///< of a dent; 0: there is none
  std::array<Vec3, most> force_N_;                 ///< F_e
  std::array<Vec3, most> depth_u_;                 ///< of a dent, times its weight
  std::array<double, most> across_{};              ///< compliance of a dent along the surface, times its weight
  std::array<std::array<Vec3, most>, most> bends_; ///< derivative of dent e, with its weight, by the normal force of d
};

} // namespace palpate
