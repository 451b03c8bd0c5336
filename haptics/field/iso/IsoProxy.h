// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/field/FieldBlock.h"

namespace palpate
{

/// The surface f = level and how its proxy is moved. Lengths are those of the grid's spacing.
struct IsoPlan
{
  double level = 0.0;
  double yield_u = std::numeric_limits<double>::infinity(); ///< further than this the surface does not hold the hand
  double scrub_u = 0.0; ///< how far the felt surface may move in a tick while `level` changes; 0: at once
  FrictionPlan friction;
  std::uint32_t passCap = 10; ///< the rest is done in the next tick: a capped proxy stands on its own side
};

/// State from tick to tick. Directions at the surface are not: they are computed where the proxy is.
struct IsoState
{
  static constexpr int mostCells = 5;
  static constexpr std::uint32_t mostStuck = 30; ///< ticks in which a surface that can go no further fades: it vanishes

  bool placed = false;
  GridPlace x;             ///< the proxy, never on the other side
  GridPlace device;        ///< the hand of the last tick
  double side = 1.0;       ///< of f - level on which the hand is
  double level = 0.0;      ///< that is felt; it follows the plan's
  bool slips = false;      ///< it slid in the last tick: friction is the kinetic one
  bool catchingUp = false; ///< the proxy is not back at the surface after the level moved
  std::uint32_t stuck = 0; ///< ticks in which the level could not move, less those in which it did: how far it faded
  std::array<GridIndex, mostCells> cells{}; ///< whose polynomials hold the proxy, the newest last
  int count = 0;
  Vec3 x_W = Vec3::Zero(); ///< of x, where it is a place in the data's own cells
};

struct IsoResult
{
  Vec3 pull_u = Vec3::Zero(); ///< from the hand to the proxy, in the axes of the grid [u]
  Vec3 normal = Vec3::Zero(); ///< of the newest patch that holds the proxy, towards its side; 0: none
  std::uint32_t passes = 0;
  std::uint32_t sweeps = 0;
  std::uint32_t cells = 0; ///< looked into
  int contacts = 0;
  bool capped = false;
  bool released = false; ///< the surface ended, there are no values, or a pocket vanished: the hand is let go
  bool yielded = false;  ///< the hand went through
};

/// Told of every straight segment that a proxy was moved along, for tests and experiments.
class FieldPathSink
{
public:
  virtual ~FieldPathSink() = default;
  virtual void piece(const GridPlace& from, const GridPlace& to, double level, double side) noexcept = 0;
};

/// Moves the proxy of an isosurface of a trilinear field to the place nearest to the hand that can be reached on its
/// side. Two-sided: where the hand first is, is its side. Every displacement is swept exactly before it is made and
/// every hop comes nearer, so nothing is passed and nothing goes round in a circle. `device`: index coordinates.
/// Outside the grid and where there are no values nothing is felt.
IsoResult moveIsoProxy(const FieldBlockComponent& field, const Vec3& spacing_u, const IsoPlan& plan, const Vec3& device,
  IsoState& state, FieldPathSink* sink = nullptr) noexcept;

} // namespace palpate
