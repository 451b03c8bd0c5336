// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticGameState_h
#define vtkHapticGameState_h

#include "haptics/labyrinth/GameLog.h"

/// State of the last played labyrinth.
struct vtkHapticGameState
{
  double Corridor_u = 0.0;
  palpate::GameLog Log;
};

#endif
