// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>

#include "haptics/field/iso/FieldSweep.h"
#include "haptics/field/iso/IsoProxy.h"

namespace palpate
{

/// The polynomial of one cell, seen from the proxy: its plane there and how it bends. Lengths [u] in the space's axes.
struct IsoRow
{
  GridIndex cell{};
  Vec3 t = Vec3::Zero(); ///< the proxy's local place in the cell, which may be outside of it
  Vec3 n = Vec3::UnitX();
  double gap_u = 0.0;    ///< to the patch's plane, along n
  double margin_u = 0.0; ///< that a landing keeps
  double cell_u = 0.0;   ///< least width of the cell
  bool straight = true;  ///< the cell is a box: `mixed` are the only second derivatives, and displacements in it are
                         ///< straight
  Vec3 mixed = Vec3::Zero(); ///< over |gradient|: by y and z, z and x, x and y [1/u]
  Mat3 bend;                 ///< of a cell that is no box all of them over |gradient| [1/u]
  Mat3 strays;               ///< and how lines that are straight in its own coordinates bend along n [1/u]

  [[nodiscard]] double bending(const Vec3& a, const Vec3& b) const noexcept
  {
    const Vec3& m = this->mixed;
    return this->straight ? m.x() * (a.y() * b.z() + a.z() * b.y()) + m.y() * (a.z() * b.x() + a.x() * b.z()) +
                              m.z() * (a.x() * b.y() + a.y() * b.x())
                          : a.dot(this->bend * b);
  }
  /// How far the patch comes towards a displacement that is tangent to it at its begin, or that displacement towards
  /// the patch [u].
  [[nodiscard]] double rise_u(const Vec3& step_u) const noexcept
  {
    const double rise_u = -0.5 * this->bending(step_u, step_u);
    const double above_u = rise_u > 0.0 ? rise_u : 0.0;
    return this->straight ? above_u : above_u + 0.5 * std::fabs(step_u.dot(this->strays * step_u));
  }
};

/// A gradient that is smaller, of the corners over the cell's length, is rounding.
inline constexpr double flatGradient = 1e-14;

/// One side of the surface f = level, seen as g = side (f - level).
struct IsoSide
{
  double level = 0.0;
  double side = 1.0; ///< 1 or -1
};

/// The space of a proxy on an isosurface: cells in which the scalar is trilinear, where they are, and the hand. A
/// place is a cell and where in it. All lengths [u] are in axes of its own.
class IsoSpace
{
public:
  IsoSpace() = default;
  IsoSpace(const IsoSpace&) = delete;
  IsoSpace& operator=(const IsoSpace&) = delete;
  virtual ~IsoSpace() = default;

  /// A place by a cell that is there; none outside.
  [[nodiscard]] virtual std::optional<GridPlace> within(const GridPlace& place) const noexcept = 0;
  /// g at the corners of a cell.
  [[nodiscard]] virtual TrilinearCell cell(const GridIndex& at, const IsoSide& of) const noexcept = 0;
  [[nodiscard]] virtual Vec3 gradient_u(const TrilinearCell& cell, const GridPlace& at) const noexcept = 0;
  /// A cell's polynomial from a place. `q_u`: from there to the hand, for where it has no direction.
  [[nodiscard]] virtual IsoRow row(
    const GridIndex& cell, const GridPlace& x, const IsoSide& of, const Vec3& q_u) const noexcept = 0;
  [[nodiscard]] virtual FieldSweepResult sweep(
    const IsoSide& of, const GridPlace& from, const Vec3& way_u) const noexcept = 0;
  [[nodiscard]] virtual Vec3 between_u(const GridPlace& from, const GridPlace& to) const noexcept = 0;
  /// Least width of a cell there, the scale of roundings, and the first step along a surface.
  [[nodiscard]] virtual double least_u(const GridPlace& at) const noexcept = 0;
  [[nodiscard]] virtual double rounded_u(const GridPlace& at) const noexcept { return this->least_u(at); }
  [[nodiscard]] virtual double firstStep_u(const GridPlace& at) const noexcept = 0;

  /// The place that is `shift_u` away from the hand; none where that is known to be outside.
  [[nodiscard]] virtual std::optional<GridPlace> besideHand(const Vec3& shift_u) const noexcept = 0;
  [[nodiscard]] virtual Vec3 toHand_u(const GridPlace& from) const noexcept = 0;
  [[nodiscard]] virtual Vec3 fromHand_u(const GridPlace& to) const noexcept = 0;
  /// The same to where the proxy is drawn.
  [[nodiscard]] virtual Vec3 toDrawn_u(const GridPlace& from) const noexcept = 0;
  virtual void draw(const Vec3& shift_u) noexcept = 0;
  /// How far the hand came since it was remembered, and remembers it.
  [[nodiscard]] virtual double handWay_u(IsoState& state) const noexcept = 0;
  virtual void remember(IsoState& state) const noexcept = 0;

  /// True if rounding cannot deny that a place is on its side.
  [[nodiscard]] bool isFree(const IsoSide& of, const GridPlace& at) const noexcept;
};

/// A proxy's tick in a space.
IsoResult moveIsoProxy(IsoSpace& space, const IsoPlan& plan, IsoState& state, FieldPathSink* sink = nullptr) noexcept;

} // namespace palpate
