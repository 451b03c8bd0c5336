// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFeltSource.h"

#include "haptics/session/HapticSession.h"

const char* vtkHapticFeltSource::Chosen(const palpate::HapticSession& core)
{
  return core.running() ? " is chosen, and is being read" : " is chosen; press Touch";
}
