// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/Warning.h"

#include <cmath>
#include <cstdio>

namespace palpate
{
namespace
{

std::string lateText(double p99_us, double stiffnessFactor)
{
  char late_ms[32];
  std::snprintf(late_ms, sizeof late_ms, "%.1f", 1e-3 * p99_us);
  return std::string("the servo is late by ") + late_ms + " ms (99th percentile): stiffness limited to " +
         std::to_string(std::lround(100.0 * stiffnessFactor)) + " %; close other programs or grant real-time priority";
}

std::string beyondText(const HapticState& state)
{
  if (state.known.late)
  {
    return "the server does not answer: no force until the surroundings of the hand are loaded";
  }
  return state.tool.held && state.tool.ball_u == 0.0
           ? "the tool reaches beyond the loaded part of the remote surfaces: no force until its surroundings are "
             "loaded; if this persists, raise 'Server whole up to'"
           : "the hand is beyond the loaded part of the remote surfaces: no force until its surroundings are loaded";
}

} // namespace

std::string warning(const HapticState& state, const LoopReport& report)
{
  if (state.letGo)
  {
    return "the dead-man switch is released: hold its button or the grip to enable force";
  }
  if (state.known.beyond)
  {
    return beyondText(state);
  }
  if (state.frozen)
  {
    return "the position has not changed for 0.25 s under force: if the handle moved, check the device";
  }
  return state.stiffnessFactor < 1.0 ? lateText(report.lateness.p99_us, state.stiffnessFactor) : std::string();
}

std::string otherDeviceText(const std::string& running, const std::string& chosen)
{
  return running == chosen ? std::string()
                           : running + " still moves the hand: release and touch again to use " + chosen;
}

} // namespace palpate
