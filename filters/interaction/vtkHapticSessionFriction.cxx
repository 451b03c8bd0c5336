// SPDX-License-Identifier: GPL-3.0-or-later
// Friction: two coefficients that may come in either order, and its effect now.
#include <algorithm>

#include "vtkHapticSessionInternals.h"

std::string vtkHapticSession::Internals::FollowFriction()
{
  const double statical = this->Settings.number("FrictionStatic");
  const double kinetic = std::min(this->Settings.number("FrictionKinetic"), statical);
  this->Change([=](palpate::HapticParameters& p) { p.contact.friction = { statical, kinetic }; });
  return {};
}

const char* vtkHapticSession::Internals::SayFrictionText()
{
  switch (this->State.friction)
  {
    case palpate::FrictionState::Sticks:
      return "sticks";
    case palpate::FrictionState::Slips:
      return "slips";
    default:
      return "";
  }
}
