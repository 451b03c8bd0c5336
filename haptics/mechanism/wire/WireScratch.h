// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/wire/WireNewton.h"
#include "haptics/mechanism/wire/WireTick.h"
#include "haptics/mechanism/wire/WireVessel.h"

namespace palpate
{

/// Workspace, state and result of a tick. Some 1 MB.
struct WireScratch
{
  WireState state;
  WireResult result;
  WireLoads loads;
  WireNewton newton;
  WireVessel vessel;
  std::uint64_t vesselHash = 0; ///< of the surface that its lists are of
  WireContacts near;
  ContactProblem problem;
  FrictionScratch friction;
  ContactForces forces;
  std::array<bool, WireContacts::mostFound> isChosen{};
  std::array<const WireContact*, WireTouch::most> chosen{};
  std::array<WireTouch, WireTouch::most> touches;
  WireVector free;
  WireVector motion;
  WireVector since;  ///< motion of this tick so far
  WirePresses begun; ///< forces with which the tick began
  int begunCount = 0;
  WireVector pressed;
};

} // namespace palpate
