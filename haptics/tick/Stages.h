// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tick/base/StageList.h"
#include "haptics/tick/stages/Blend.h"
#include "haptics/tick/stages/Clutch.h"
#include "haptics/tick/stages/ConstantForce.h"
#include "haptics/tick/stages/Contact.h"
#include "haptics/tick/stages/Coupling.h"
#include "haptics/tick/stages/DeviceWalls.h"
#include "haptics/tick/stages/Engage.h"
#include "haptics/tick/stages/Field.h"
#include "haptics/tick/stages/Game.h"
#include "haptics/tick/stages/Guide.h"
#include "haptics/tick/stages/Hand.h"
#include "haptics/tick/stages/HeldMechanism.h"
#include "haptics/tick/stages/Protect.h"
#include "haptics/tick/stages/Report.h"
#include "haptics/tick/stages/Samples.h"
#include "haptics/tick/stages/Soft.h"
#include "haptics/tick/stages/Stiffness.h"
#include "haptics/tick/stages/Surroundings.h"
#include "haptics/tick/stages/Tool.h"

namespace palpate
{

/// The tick. A force of one's own is added to rendered_D between Coupling and Blend. Engage lets it start small;
/// Protect limits whatever has been rendered.
using TickStages = StageList< //
  stage::Requests,            // requests of the person
  stage::Samples,             // whether the hand is where the device says
  stage::Stiffness,           // of the coupling in this tick
  stage::Hand,                // where it is and how fast
  stage::Clutch,              // or where it stays
  stage::Surroundings,        // whether all around it is known
  stage::GameLead,            // of a labyrinth, before contact
  stage::SoftLead,            // soft body, before contact
  stage::Contact,             // where the proxy rests
  stage::Soft,                // soft body, after contact
  stage::Tool,                // or the tool
  stage::HeldMechanism,       // or a mechanism
  stage::Coupling,            // spring and damper between the two
  stage::Field,               // field around the hand
  stage::Guide,               // to a plane
  stage::ConstantForce,       // the same wherever the hand is
  stage::HandGuard,           // an impossible motion ends the force
  stage::Blend,               // a replaced scene never steps
  stage::GameArrival,         // of a labyrinth, after contact
  stage::Engage,              // how much of the force is let through
  stage::DeviceWalls,         // walls in the device's own loop
  stage::Protect,             // limits
  stage::Report>;             // report of the tick

} // namespace palpate
