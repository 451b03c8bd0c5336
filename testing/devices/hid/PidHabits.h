// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace palpate::test
{

/// When a firmware takes over the numbers of a condition.
enum class ConditionOrder : std::uint8_t
{
  Any,
  OnlyAfterSetEffect, ///< numbers before the effect's settings are forgotten
  OnlyWithSetEffect,  ///< it counts from the settings that follow, with a sign for each axis from their angle
};

/// Differences of firmwares where the class's specification leaves it open, or in spite of it. Each was seen in the
/// public source of one that people have; the default is that of most.
struct PidHabits
{
  bool pointsTo = false;        ///< the angle says where a force points to, not where it comes from
  bool bindsTrigger = false;    ///< any trigger button but all ones plays the effect again when it is pressed
  bool stopAllDisables = false; ///< to stop all is to pause: off until enabled, and effects still run out by themselves
  ConditionOrder conditions = ConditionOrder::Any;
  bool wakesCentred = false;   ///< a spring to the centre, on after a reset, off after a stop of all
  bool deadConditions = false; ///< taken, and nothing is felt
  bool oneMotor = false;       ///< behind two axes: a wheel whose y is a pedal
  bool wipesSilently = false;  ///< effects that are gone are not reported

  [[nodiscard]] std::string text() const;
};

/// Every combination.
[[nodiscard]] std::vector<PidHabits> allHabits();

} // namespace palpate::test
