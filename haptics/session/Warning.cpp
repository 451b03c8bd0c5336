// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/Warning.h"

#include <cmath>
#include <cstdio>

namespace palpate
{
namespace
{

std::string lateSentence(double p99_us, double stiffnessFactor)
{
  char late_ms[32];
  std::snprintf(late_ms, sizeof late_ms, "%.1f", 1e-3 * p99_us);
  return std::string("the servo is late by ") + late_ms + " ms (99th percentile): stiffness limited to " +
         std::to_string(std::lround(100.0 * stiffnessFactor)) + " %; close other programs or grant real-time priority";
}

std::string beyondSentence(const HapticState& state)
{
  if (state.known.late)
  {
    return "the server does not answer: no force until what is around the hand is there";
  }
  return state.tool.held && state.tool.ball_u == 0.0
           ? "the tool reaches beyond what is there of the server's surfaces: no force until all that it reaches is "
             "there; if it stays so, raise the number of triangles up to which a surface is fetched whole"
           : "the hand is beyond what is there of the server's surfaces: no force until what is around it is there";
}

} // namespace

std::string warning(const HapticState& state, const LoopReport& report)
{
  if (state.letGo)
  {
    return "the dead-man is not held: hold its button or the grip to feel";
  }
  if (state.known.beyond)
  {
    return beyondSentence(state);
  }
  if (state.frozen)
  {
    return "the position has not changed for a quarter of a second under force: if the handle moved, check the device";
  }
  return state.stiffnessFactor < 1.0 ? lateSentence(report.lateness.p99_us, state.stiffnessFactor) : std::string();
}

std::string otherDeviceSentence(const std::string& running, const std::string& chosen)
{
  return running == chosen ? std::string() : running + " still leads the hand: let go and touch again to use " + chosen;
}

} // namespace palpate
