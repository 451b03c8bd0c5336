// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/compliance/wire/Beam.h"
#include "haptics/compliance/wire/WireFactor.h"

namespace palpate
{

/// A ring around a beam, through which it slides: its place there, between its nodes along the chord, is drawn onto the
/// world's x axis.
struct WireRing
{
  int beam = -1;      ///< none
  double share = 0.0; ///< of the second node
  double hold_N_per_u = 0.0;
};

/// Supports, forces and springs that act on a wire.
struct WireLoads
{
  /// Which of a node's six motions are held, by bits: displacements along x, y and z, turns about them.
  static constexpr std::uint8_t place = 0b000111, turn = 0b111000, clamped = 0b111111;

  WireVector force{}; ///< a force [N] and a moment [N u] at each node, in the world's axes
  /// How fast those fall as their node goes along: supports that yield [N/u, N u/rad].
  WireVector falls{};
  std::array<std::uint8_t, Wire::mostNodes> held{};
  WireRing ring;
  /// Drag towards where each step begins: no force at rest.
  double placeDrag_N_per_u = 0.0;
  double turnDrag_Nu_per_rad = 0.0;
  /// Of places, across the wire: one that slides along itself feels none.
  std::array<double, Wire::mostNodes> acrossDrag_N_per_u{};
  /// Springs of each node towards a place, for a hand or a vessel.
  std::array<double, Wire::mostNodes> spring_N_per_u{};
  std::array<Vec3, Wire::mostNodes> pulledTo_W{};

  WireLoads() noexcept;
};

/// How a search for rest ended.
struct WireRest
{
  bool met = false;
  int steps = 0;
  double residual_N = 0.0; ///< the largest force that is out of balance; moments count by the first beam's length
};

/// Newton's steps on the balance of a wire. Some 200 kB: not for the stack. Real-time safe.
class WireNewton
{
public:
  /// Balance and stiffness of the wire there, and its factor. Where the stiffness is not positive definite, as beyond a
  /// wire's buckling, drag across it is added until it is; `firm` says whether none was needed. False: no drag was
  /// enough.
  [[nodiscard]] bool linearise(const Wire& wire, const WirePlaces& places_W, const WireLoads& loads) noexcept;
  [[nodiscard]] bool firm() const noexcept { return this->firm_; }
  /// How many factors that took.
  [[nodiscard]] int factors() const noexcept { return this->factors_; }

  /// Largest force that is out of balance [N]; moments count by the first beam's length.
  [[nodiscard]] double residual_N() const noexcept { return this->residual_N_; }
  /// Energy of the beams [N u].
  [[nodiscard]] double energy_Nu() const noexcept { return this->energy_Nu_; }
  /// Force and moment that hold a node against the wire: at a held motion those of its support.
  [[nodiscard]] const NodeVector& held(int node) const noexcept { return this->inner_[node]; }
  [[nodiscard]] const WireMatrix& stiffness() const noexcept { return this->stiffness_; }
  [[nodiscard]] WireFactor& factor() noexcept { return this->factor_; }

  /// The step to rest as the linearised wire has it.
  void step(WireVector& motion) const noexcept;
  /// The same with further forces on the nodes, which the balance does not know yet.
  void step(const WireVector& further, WireVector& motion) const noexcept;

  /// Steps to rest, at most so many, until no more than this is out of balance.
  WireRest toRest(
    const Wire& wire, const WireLoads& loads, int mostSteps, double tolerance_N, WirePlaces& places_W) noexcept;

private:
  void assemble(const Wire& wire, const WirePlaces& places_W) noexcept;
  void addLoads(const Wire& wire, const WirePlaces& places_W, const WireLoads& loads) noexcept;
  void addRing(const WirePlaces& places_W, const WireRing& ring) noexcept;
  void hold(const WireLoads& loads) noexcept;

  bool firm_ = false;
  int factors_ = 0;
  double residual_N_ = 0.0;
  double energy_Nu_ = 0.0;
  WireVector inner_;
  WireVector open_; ///< force that is out of balance
  WireMatrix stiffness_;
  WireFactor factor_;
  WireVector motion_;
};

/// Moves nodes by a step, shortened where it would turn a node or a chord too far for a step. Gives the share of the
/// step that was taken.
double moveWire(const Wire& wire, const WireVector& motion, WirePlaces& places_W) noexcept;

} // namespace palpate
