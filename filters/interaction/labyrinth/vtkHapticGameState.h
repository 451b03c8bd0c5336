// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticGameState_h
#define vtkHapticGameState_h

#include "haptics/labyrinth/GameLog.h"

/// What a session knows of the labyrinth that was played last.
struct vtkHapticGameState
{
  double Corridor_u = 0.0;
  palpate::GameLog Log;
};

#endif
