// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of a server: how much of them is fetched, and the parts that are here.
#include "vtkHapticServerSurfaces.h"
#include "vtkHapticSessionInternals.h"

std::string vtkHapticSession::Internals::FollowServerLimit()
{
  this->Server.SetLimit(this->Settings.whole("ServerLimit"));
  return {};
}
