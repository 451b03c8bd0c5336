// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "haptics/compliance/servo/SoftSurfaceRef.h"

namespace palpate
{

/// The dents of a ball below the patches of its contacts (SubgridSpring).
///
/// Where several planes of nearly one place hold a ball, it makes one dent, not one each: on a vertex whose faces are
/// almost flat it is as deep as on the flat. With k(c, e) = sharedBy(), 1 for one place and 0 for far ones, what
/// presses at e is the vector F_e = sum_c k(c, e) f_c n_c, and all dents store sum_e w_e U_e(|F_e|), w_e = 1 / sum_c
/// k(c, e), U_e being the energy of the spring at e. So contacts that coincide have one dent under their whole force,
/// far ones have one each, and nothing steps between. How deep the ball is at c is the derivative by f_c n_c, and its
/// slopes are symmetric and positive semidefinite.
///
/// Along the surface a dent gives as a contact as wide does (Mindlin 1949): `across` times the spring's slope under its
/// normal force, under what all contacts pull at it across their normals. Real-time safe.
class SharedDents
{
public:
  /// The contacts must outlive it, at the same places.
  explicit SharedDents(std::span<const SoftContact> contacts) noexcept;

  /// How the slopes are taken: through nothing and the present force, or along the springs there.
  enum class Line : std::uint8_t
  {
    Secant,
    Tangent,
  };
  /// Takes the contacts' forces as they are now. A dent under less than `least_N_per_u` of its patch has the secant of
  /// that force. True if all dents are pressed as the last time, but for rounding.
  bool press(Line line = Line::Secant, double least_N_per_u = 0.0) noexcept;

  /// How much deeper the ball is at a contact [u], in W against its normal.
  [[nodiscard]] Vec3 depthAt(int c) const noexcept;
  /// How far the contact goes along the surface under the contacts' forces across their normals [u], in W with them.
  [[nodiscard]] Vec3 asideAt(int c) const noexcept;
  /// By how much it goes aside under such a force of d, each across its own normal [u/N].
  [[nodiscard]] double acrossBetween(int c, int d) const noexcept;
  /// By how much the depth along c's normal grows with the normal force of d [u/N].
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
  std::array<std::array<Vec3, most>, most> bends_; ///< of dent e, with its weight, by the normal force of d
};

} // namespace palpate
