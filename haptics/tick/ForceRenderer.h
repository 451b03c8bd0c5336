// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "haptics/compliance/servo/PressedBody.h"
#include "haptics/contact/GodObject.h"
#include "haptics/core/DeviceCommand.h"
#include "haptics/core/DeviceSample.h"
#include "haptics/core/HapticDevice.h"
#include "haptics/field/FieldBlock.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/mechanism/servo/FeltMechanism.h"
#include "haptics/safety/LatenessPolicy.h"
#include "haptics/tick/HapticEvent.h"
#include "haptics/tick/HapticParameters.h"
#include "haptics/tick/base/HapticState.h"
#include "haptics/tool/servo/ToolContacts.h"

namespace palpate
{

/// All that the tick remembers: the states of all its stages, whose members are its own. Copyable; every recording
/// begins with a new one.
struct RendererState : TickStages::States
{
};

/// Inputs of one tick. The scene may be null.
struct TickInput
{
  std::uint64_t tick = 0;
  std::uint32_t hand = 0; ///< whose tick this is: each hand has its state, all share the scene
  double dt_s = 1e-3;
  DeviceSample sample;
  DeviceStatus status = DeviceStatus::Ok;
  const Scene* scene = nullptr;
  const Scene* previousScene = nullptr;     ///< in the tick that takes a new scene: the one before, still alive
  const FieldBlock* brick = nullptr;        ///< the field around the hand; may be null
  const ToolContacts* tool = nullptr;       ///< contacts of the tool in the hand; null: the hand touches with its ball
  const FeltMechanism* mechanism = nullptr; ///< in the hand in place of ball and tool; may be null
  MechanismTick* mechanismTick = nullptr;   ///< workspace; not null with a tool
  const PressedBody* body = nullptr;        ///< soft body; null: none. With a body the scene is that of the body
  SoftScratch* softScratch = nullptr;       ///< workspace of its contact; not null with a body
  LatenessVerdict lateness;
  std::span<const HapticEvent> events;
};

struct TickOutput
{
  DeviceCommand command;
  HapticState state;
};

/// The tick: (sample, scene, parameters, events, state) -> (state, command), one stage after the other. The servo
/// thread, the virtual clock, the replay, the VTK filter and the program all call this one function. Deterministic,
/// bounded, no allocation, no lock, no clock, no I/O.
[[nodiscard]] TickOutput renderTick(
  const TickInput& input, const HapticParameters& parameters, RendererState& state, PathSink* sink = nullptr) noexcept;

} // namespace palpate
