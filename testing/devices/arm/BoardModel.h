// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "testing/devices/arm/LedArm.h"

namespace palpate::test
{

/// An arm behind a link of bytes: its mechanics, its motors and its firmware. Its members switch faults on.
class BoardModel : public LedArm
{
public:
  /// Bytes of the host, in pieces of any length.
  virtual void take(std::span<const std::uint8_t> bytes) = 0;
  /// Force of the motors on the hand now [N].
  [[nodiscard]] virtual Vec3 force_N() const = 0;
  /// The largest change of that force by one step of its numbers [N].
  [[nodiscard]] virtual double step_N() const = 0;

  std::deque<std::uint8_t> said;
  bool present = true, frozen = false;
  int silentFor = 0; ///< so many answers do not come
  int cutAnswers = 0, wrongAnswers = 0;
  int callsUntilUnplugged = -1; ///< of the link, whatever they are
  int answers = 0;

protected:
  /// Says an answer, as far as nothing is wrong with it.
  void say(std::vector<std::uint8_t> answer);
};

} // namespace palpate::test
