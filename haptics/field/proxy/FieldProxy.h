// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/field/FieldBlock.h"
#include "haptics/field/iso/IsoProxy.h"
#include "haptics/field/proxy/FieldPlan.h"

namespace palpate
{

/// State of a field from tick to tick.
struct FieldState
{
  bool placed = false;
  Vec3 soft_W = Vec3::Zero();   ///< proxy of the pulls of limited strength
  Vec3 detent_W = Vec3::Zero(); ///< proxy of the smooth detent
  IsoState surface, click;
  std::uint64_t brick = 0; ///< content of the block, or of the data's own cells, that the cells are of
  FieldBlockGrid grid;     ///< of the block; without points: they are the data's own
};

struct FieldResult
{
  Vec3 pull_W = Vec3::Zero();    ///< sum of the displacements from the hand to each proxy [u]
  double stretch2_u2 = 0.0;      ///< sum of their squares
  Vec3 push_W = Vec3::Zero();    ///< force of the vectors, in the axes of W [N]
  Vec3 surface_W = Vec3::Zero(); ///< proxy of the isosurface, where there is one
  double error_u = 0.0;          ///< the pulls of limited strength are certainly balanced to this
  int contacts = 0;              ///< surfaces that push, each once however many of its cells do
  std::uint32_t passes = 0;
  bool outside = false; ///< the hand is where the field has no value
  bool beyond = false;  ///< it is beyond the block
  bool letGo = false;   ///< a surface ended or vanished, or the field did, in this tick
  bool capped = false;
};

/// How many springs a plan uses on a block: they share the stiffness of the hand's coupling. Each has a proxy of its
/// own, so that each by itself takes no less than it gives: one proxy that respects them one after the other would have
/// a force with curl.
[[nodiscard]] int springsOf(const FieldBlock& brick, const FieldPlan& plan) noexcept;

/// One tick of a hand at p_W in a field. `stiffness_N_per_u`: of each spring. Where the block has a finer one around
/// the hand that is felt, and of surfaces the data's own cells where it has those; coming to them and from them is
/// another block. A surface that holds a hand holds it beyond the values too. Real-time safe.
[[nodiscard]] FieldResult moveFieldProxy(const FieldBlock& whole, const FieldPlan& plan, double stiffness_N_per_u,
  const Vec3& p_W, FieldState& state) noexcept;

} // namespace palpate
