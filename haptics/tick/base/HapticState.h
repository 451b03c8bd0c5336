// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "haptics/contact/GodObject.h"
#include "haptics/core/Fault.h"
#include "haptics/core/Types.h"
#include "haptics/force/PassivityController.h"
#include "haptics/labyrinth/LabyrinthGame.h"
#include "haptics/mechanism/FoundContacts.h"
#include "haptics/mechanism/servo/MechanismTick.h"
#include "haptics/tool/servo/ToolForce.h"

namespace palpate
{

/// Whether the hand may be pushed.
enum class EngageState : std::uint8_t
{
  Safe,    ///< no force
  Armed,   ///< force was asked for; waits until it would start small
  Engaged, ///< force is given
  Fault,   ///< no force until the person engages again
};

[[nodiscard]] const char* name(EngageState state) noexcept;

/// Result of a field in a tick.
struct FieldReport
{
  Vec3 force_D = Vec3::Zero();   ///< the part of the force that is the field's [N]
  Vec3 proxy_W = Vec3::Zero();   ///< where its surface, or all of its springs together, draw the hand [u]
  double pushPower_W = 0.0;      ///< that the vectors give the hand as a force [W]
  double error_u = 0.0;          ///< the pulls of limited strength are certainly balanced to this [u]
  std::int32_t contacts = 0;     ///< surfaces of it that push
  bool outside = false;          ///< the hand is where the field has no value
  std::uint64_t beyondTicks = 0; ///< in which the hand was beyond the block that was there, until now
  bool capped = false;           ///< the proxy goes on in the next tick
  EnergyMeter energy;            ///< of its springs
};

/// Result of a tool in a tick.
struct ToolState
{
  bool held = false;                                ///< one is in the hand
  bool placed = false;                              ///< and stands somewhere
  double ball_u = 0.0;                              ///< it is felt as a ball of that radius; 0: by its mesh
  Pose hand_W;                                      ///< where the hand would have it; proxy_W is where it is [u]
  std::int32_t active = 0;                          ///< contacts that push
  std::int32_t touching = 0;                        ///< and all that there are
  std::array<ToolPress, ToolPress::most> presses{}; ///< the first `active`
  double lever_m = 0.0;    ///< in the hand: the stiffness of turning is the stiffness times its square
  double injected_J = 0.0; ///< by contacts that were replaced in this tick: energy of the new ones less the old ones'
};

/// Result of a soft body in a tick.
struct SoftReport
{
  bool felt = false;             ///< there is one
  bool pressed = false;          ///< and it deforms under the ball
  double age_s = 0.0;            ///< of the state at which its snapshot was made
  double stored_J = 0.0;         ///< elastic energy under the hand: of body and coupling
  double added_N = 0.0;          ///< along the force, so that the hand gets back no more than it gave
  Vec3 yielded_W = Vec3::Zero(); ///< how far the surface under the ball has gone [u]
};

/// Whether all was known around hand and proxy in a tick, where the scene is a part of a whole.
struct KnownReport
{
  bool beyond = false;           ///< it was not: nothing could be touched
  bool late = false;             ///< for the next part was asked for and did not come
  std::uint64_t beyondTicks = 0; ///< until now
};

/// State of a constraint, for a person.
struct ConstraintReport
{
  ConstraintPhase phase = ConstraintPhase::Open;
  double force_N = 0.0;     ///< its size
  Vec3 at_W = Vec3::Zero(); ///< where, as it has yielded
  double inside_u = 0.0;    ///< of the shaft, beyond its hole
};

/// Which constraints have changed since the mechanism was taken: the newest few.
struct ConstraintChanges
{
  std::uint64_t plan = 0;                                          ///< its revision
  std::uint64_t count = 0;                                         ///< all of them
  std::array<MechanismEvent, Mechanism::mostConstraints> newest{}; ///< change i, from 0, is at i % size

  void add(const MechanismEvent& event) noexcept { this->newest[this->count++ % this->newest.size()] = event; }
  /// Those of one tick, if no later one has changed any: oldest first, as numbers of changes [first, count).
  [[nodiscard]] std::uint64_t firstOf(std::uint64_t tick) const noexcept
  {
    std::uint64_t first = this->count;
    const std::uint64_t kept = this->count < this->newest.size() ? this->count : this->newest.size();
    while (this->count - first < kept && this->at(first - 1).tick == tick)
    {
      --first;
    }
    return first;
  }
  [[nodiscard]] const MechanismEvent& at(std::uint64_t change) const noexcept
  {
    return this->newest[change % this->newest.size()];
  }
};

/// A contact that was found and presses, for a person.
struct FoundPress
{
  std::int32_t mesh = 0;       ///< the body that is pressed here, in the order of the description
  std::int32_t body = 0;       ///< the body that presses it
  Vec3 at_W = Vec3::Zero();    ///< where, as the bodies have yielded [u]
  Vec3 force_W = Vec3::Zero(); ///< on the mesh, friction with it, before limits [N]
};

/// Result of a mechanism in a tick. Bodies and constraints are in the order of its description.
struct MechanismNow
{
  bool held = false;          ///< one is in the hand, and has been somewhere
  std::uint64_t revision = 0; ///< of its plan
  int bodyCount = 0;
  int lawCount = 0;
  Pose hand_W;                                      ///< pose of the held body without contact [u]
  std::array<Pose, Mechanism::mostBodies> pose_W{}; ///< of held and rigid bodies [u]
  std::array<ConstraintReport, Mechanism::mostConstraints> laws{};
  ConstraintChanges changes;
  double age_s = 0.0;                                  ///< of the oldest snapshot of a soft body that is pressed
  double residual_u = 0.0;                             ///< largest of the constraints'
  bool capped = false;                                 ///< the solver goes on in the next tick
  int touching = 0;                                    ///< contacts that were found, and press
  std::array<FoundPress, FoundContacts::most> found{}; ///< the first `touching`
  int leftOut = 0;                                     ///< places that touch, for which the tick has no room
  bool ahead = false; ///< the hand is ahead of the held mesh, whose contacts were looked for no further
  WireReport wire;    ///< of the body in the hand; the first of its contacts are among those that were found
};

/// Result of a tick for view, panel and recording.
struct HapticState
{
  std::uint64_t tick = 0;
  std::uint32_t hand = 0; ///< index of the hand
  double time_s = 0.0;
  Vec3 handle_D = Vec3::Zero();         ///< where the device is [m]
  Pose device_W;                        ///< hand in the scene [u]
  Pose proxy_W;                         ///< god-object in the scene [u]
  Vec3 velocity_D = Vec3::Zero();       ///< estimated from the positions [m/s]
  Vec3 rendered_D = Vec3::Zero();       ///< force before safety [N]
  Vec3 besideContact_D = Vec3::Zero();  ///< the part of it that does not come from contact, of a guide say [N]
  Vec3 stabiliser_D = Vec3::Zero();     ///< the part of it that the passivity controller added [N]
  Vec3 force_D = Vec3::Zero();          ///< force on the hand [N]
  Vec3 force_W = Vec3::Zero();          ///< the same, as seen in the scene
  Vec3 renderedTorque_D = Vec3::Zero(); ///< torque before safety [N m]
  Vec3 torque_D = Vec3::Zero();         ///< torque on the hand [N m]
  double turned_J = 0.0;                ///< net work of the torque on the hand, negative when taken from it
  std::int32_t contacts = 0;
  std::int32_t passes = 0;
  std::int32_t sweeps = 0;
  std::uint32_t work = 0;
  FrictionState friction = FrictionState::None;
  std::uint64_t sceneRevision = 0;
  double sceneAge_s = 0.0;  ///< since the scene of that revision was taken
  double sceneShare = 1.0;  ///< how far its surfaces have come, but for a soft body's own, 0..1
  double motionLag_s = 0.0; ///< how late moving surfaces are felt: the time from the snapshot before to this one
  EngageState engage = EngageState::Safe;
  Fault fault = Fault::None;
  bool clamped = false; ///< the force, or the torque, was cut to the largest allowed
  bool riseLimited = false;
  bool capped = false; ///< see ContactResult
  bool overBudget = false;
  bool infeasible = false;
  bool pinned = false;       ///< moving surfaces leave the ball less space than it needs
  bool frozen = false;       ///< the position stays the same to the bit under force: does the device still measure?
  bool letGo = false;        ///< the dead-man switch is released
  std::uint32_t buttons = 0; ///< that are down, as DeviceSample has them
  bool deviceHolds = false;  ///< the device renders walls and viscosity itself; force_D is their force
  std::int32_t walls = 0;    ///< that the device holds
  double guideShare = 0.0;   ///< of the guide to a plane that acts, 0..1
  GamePhase game = GamePhase::Off;
  double gameTime_s = 0.0;        ///< of exploring the labyrinth, until now or until the exit
  bool held = false;              ///< no force this tick: its sample was not finite
  double gain = 0.0;              ///< engage ramp, 0..1
  double stiffnessFactor = 1.0;   ///< below 1: cut because the loop runs late
  double stiffness_N_per_m = 0.0; ///< of the coupling in this tick, after every limit
  bool stiffnessLimited = false;  ///< to the stable stiffness of device and rate
  EnergyMeter energy;
  FieldReport field;
  ToolState tool;
  SoftReport soft;
  KnownReport known;
  MechanismNow mechanism;
};

} // namespace palpate
