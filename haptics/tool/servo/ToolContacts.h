// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "haptics/core/Types.h"

namespace palpate
{

/// One touched feature where the tool stands.
struct ToolContact
{
  Vec3 n_W = Vec3::UnitZ();  ///< unit, from the scene to the tool
  Vec3 arm_W = Vec3::Zero(); ///< from the tool's centre to the point that touches [u]
  double gap_u = 0.0;
};

/// What an update hands to the servo: where the tool is and what holds it there. Of fixed size, so that a triple buffer
/// carries it without waiting.
struct ToolContacts
{
  static constexpr std::size_t capacity = 64;

  Pose pose_W;
  double characteristic_u = 1.0; ///< of the metric
  double reach_u = 0.0;          ///< no point of the tool is further from its pose
  double restGap_u = 0.0;        ///< the servo keeps this gap
  std::uint64_t revision = 0;    ///< another for each set that is handed on
  std::uint32_t count = 0;
  bool held = false;   ///< a tool is in the hand; false: the hand touches with its ball
  bool placed = false; ///< and it stands somewhere; false: no force
  double ball_u = 0.0; ///< above 0: it is felt as a ball of that radius, which the tick sweeps; there are no contacts
  std::array<ToolContact, capacity> contacts{}; ///< where there is no room for all, those with the smallest gaps
};

static_assert(std::is_trivially_destructible_v<ToolContacts>);

} // namespace palpate
