// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "haptics/core/Types.h"

namespace palpate
{

/// A feature that touches at the pose of the tool.
struct ToolContact
{
  Vec3 n_W = Vec3::UnitZ();  ///< unit, from the scene to the tool
  Vec3 arm_W = Vec3::Zero(); ///< from the tool's centre to the point of contact [u]
  double gap_u = 0.0;
};

/// The result of an update for the servo: the pose of the tool and its contacts. Of fixed size, so that a triple buffer
/// carries it without waiting.
struct ToolContacts
{
  static constexpr std::size_t capacity = 64;

  Pose pose_W;
  double characteristic_u = 1.0; ///< lever arm of the metric
  double reach_u = 0.0;          ///< largest distance of a point of the tool from its pose
  double restGap_u = 0.0;        ///< the servo keeps this gap
  std::uint64_t revision = 0;    ///< changes with each set that is published
  std::uint32_t count = 0;
  bool held = false;   ///< a tool is in the hand; false: the hand touches with its ball
  bool placed = false; ///< and it has a pose; false: no force
  double ball_u = 0.0; ///< above 0: rendered as a ball of that radius, which the tick sweeps; there are no contacts
  std::array<ToolContact, capacity> contacts{}; ///< if there are more, those with the smallest gaps
};

static_assert(std::is_trivially_destructible_v<ToolContacts>);

} // namespace palpate
