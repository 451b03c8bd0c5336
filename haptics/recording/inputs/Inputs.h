// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/recording/inputs/Bodies.h"
#include "haptics/recording/inputs/FieldBlocks.h"
#include "haptics/recording/inputs/InputList.h"
#include "haptics/recording/inputs/Mechanisms.h"
#include "haptics/recording/inputs/Scenes.h"
#include "haptics/recording/inputs/Tools.h"

namespace palpate
{

using TickInputs = input::InputList<input::Mechanisms, // first: while one is held, ball, tool and soft body rest
  input::Scenes,                                       // that of a soft body, where there is one
  input::Bodies,                                       // after the scene that they are felt in
  input::FieldBlocks,                                  // the field around the hand
  input::Tools>;

} // namespace palpate
