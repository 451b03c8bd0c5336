// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "haptics/contact/GodObject.h"
#include "haptics/core/DeviceCommand.h"
#include "haptics/core/DeviceSample.h"
#include "haptics/core/HapticDevice.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/safety/LatenessPolicy.h"
#include "haptics/tick/HapticEvent.h"
#include "haptics/tick/HapticParameters.h"
#include "haptics/tick/HapticState.h"
#include "haptics/tick/WallKeeper.h"

namespace palpate
{

/// All that the tick remembers. Copyable; every recording begins with a new one.
struct RendererState
{
  GodObjectState contact;
  EngageState engage = EngageState::Safe;
  Fault fault = Fault::None;
  double gain = 0.0; ///< share of the force that is let through, 0..1
  PositionWatch watch;
  Vec3 lastForce_D = Vec3::Zero();    ///< what the hand got last tick [N]
  Vec3 lastRendered_D = Vec3::Zero(); ///< what the scene asked for last tick [N]
  Vec3 blend_D = Vec3::Zero();        ///< what is left of the force of the scene before [N]
  VelocityHistory velocity;
  EnergyMeter energy;
  Vec3 lastP_D = Vec3::Zero(); ///< where the hand was last tick [m]
  bool tracked = false;        ///< lastP_D is of the tick before
  bool ownForce = false;       ///< what the hand got last tick was the coupling's own force, unlimited
  WorkspaceMap map;            ///< of the last tick: another map places the proxy anew
  double radius_u = 0.0;       ///< of the last tick: another ball is seated where the old one was
  std::uint64_t sceneRevision = 0;
  std::uint64_t sceneGeometry = 0; ///< what surfaces it had, wherever they were
  HeldWallState walls;
  GameState game;
  double guideShare = 0.0;             ///< of the guide that acts, 0..1
  Vec3 lastGuide_D = Vec3::Zero();     ///< its part of the last tick's force [N]
  double sceneAge_s = 0.0;             ///< since the scene was taken: how far its surfaces have moved
  double sinceBad_s = longAgo_s;       ///< time since the last sample that was not finite
  double sinceBadBefore_s = longAgo_s; ///< and since the one before it

  static constexpr double longAgo_s = std::numeric_limits<double>::infinity();
};

/// What one tick works on. The scene may be null.
struct TickInput
{
  std::uint64_t tick = 0;
  double dt_s = 1e-3;
  DeviceSample sample;
  DeviceStatus status = DeviceStatus::Ok;
  const Scene* scene = nullptr;
  const Scene* previousScene = nullptr; ///< in the tick that takes a new scene: the one before, still alive
  LatenessVerdict lateness;
  std::span<const HapticEvent> events;
};

struct TickOutput
{
  DeviceCommand command;
  HapticState state;
};

/// The tick: (sample, scene, parameters, events, state) -> (state, command). The servo thread, the virtual clock, the
/// replay, the VTK filter and the program all call this one function. Deterministic, bounded, no allocation, no lock,
/// no clock, no I/O.
[[nodiscard]] TickOutput renderTick(
  const TickInput& input, const HapticParameters& parameters, RendererState& state, PathSink* sink = nullptr) noexcept;

} // namespace palpate
