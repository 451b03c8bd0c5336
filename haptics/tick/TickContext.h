// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "haptics/contact/view/PlanFor.h"
#include "haptics/tick/ForceRenderer.h"
#include "haptics/tick/ProxyStep.h"

namespace palpate
{

/// The part of a tool's pull that turns, as displacements of its lever.
struct TurnPull
{
  Vec3 pull_D = Vec3::Zero();     ///< from the device to where contact turns it [m]
  Vec3 velocity_D = Vec3::Zero(); ///< of the hand's turning [m/s]
  double lever_m = 0.0;           ///< 0: nothing turns
};

/// With the ball of a tool that is felt as one.
[[nodiscard]] inline ContactPlan contactOf(const TickInput& input, const HapticParameters& p) noexcept
{
  ContactPlan plan = p.contact;
  plan.radius_u = input.tool != nullptr && input.tool->ball_u > 0.0 ? input.tool->ball_u : plan.radius_u;
  return input.scene != nullptr ? planFor(*input.scene, plan) : plan;
}

/// Data of the stages of one tick, and results for later stages. Lives for a tick, on the stack.
struct TickContext
{
  const TickInput& input;
  const HapticParameters& p;
  RendererState& s;
  TickOutput& out; ///< written where the caller has it: it is too large to be copied for nothing
  PathSink* sink = nullptr;

  SceneStep scene = sceneStep(input, p.known, s);
  ContactPlan contact = contactOf(input, p); ///< of this tick
  std::optional<Vec3>
    way_D = {}; ///< of the hand since the tick before [m]; none: that tick did not know the place of the hand
  std::optional<Vec3> turn_D = {};  ///< likewise how it has turned: a small rotation vector [rad]
  Vec3 handBefore_W = Vec3::Zero(); ///< where the hand was in the scene when it was known last [u]
  bool otherMap = false;            ///< than in the tick before
  bool knownChanged = false;        ///< the hand left its known surroundings, or returned
  GameForce game = {};              ///< request of a labyrinth in this tick
  bool seatFailed = false;          ///< the ball found no place
  Vec3 pull_D = Vec3::Zero();       ///< from the device to where contact draws it [m]
  TurnPull turn = {};               ///< likewise for how it is turned
  bool toolWaits = false;           ///< a tool stands nowhere yet, for it met the scene wherever the hand was
  double stretch_m = 0.0;           ///< of a plain spring that holds as much energy as the contact
  Vec3 coupled_D = Vec3::Zero();    ///< force of contact and its additions, before blend and limits [N]

  /// Nothing that pushes has a place.
  [[nodiscard]] bool homeless() const noexcept { return this->seatFailed || this->toolWaits; }

  /// A tool that is moved beside the servo touches, in place of a ball.
  [[nodiscard]] bool touchesByMesh() const noexcept
  {
    return this->input.tool != nullptr && !(this->input.tool->ball_u > 0.0);
  }

  /// After Surroundings.
  [[nodiscard]] bool touchable() const noexcept
  {
    return this->input.scene != nullptr && !this->input.scene->empty() && !this->s.beyondKnown;
  }

  /// The proxy of the hand without tool or mechanism.
  [[nodiscard]] bool holdsBall() const noexcept { return !this->touchesByMesh() && this->input.mechanism == nullptr; }

  /// Something couples the hand to the scene by a spring: contact, or the constraints of a mechanism.
  [[nodiscard]] bool coupled() const noexcept { return this->touchable() || this->input.mechanism != nullptr; }

  /// Whether there is anything that could push the hand, of any stage.
  [[nodiscard]] bool feelable() const noexcept;

  /// Springs of the hand: they share the stable stiffness of device and rate.
  [[nodiscard]] int springs() const noexcept
  {
    const int field = this->input.brick != nullptr ? springsOf(*this->input.brick, this->p.field) : 0;
    return std::max(1, field + (this->coupled() ? 1 : 0));
  }

  /// A force that does not come from contact, whose work is no work of the contact.
  void addBesideContact(const Vec3& force_D) noexcept
  {
    this->s.besideContact_D += force_D;
    this->out.state.besideContact_D = this->s.besideContact_D;
    this->out.state.rendered_D += force_D;
    this->coupled_D = this->out.state.rendered_D;
  }

  /// Ends the force until the person engages again. The first fault is the one that is told.
  void latch(Fault fault) noexcept
  {
    if (fault != Fault::None && this->s.engage != EngageState::Fault)
    {
      this->s.engage = EngageState::Fault;
      this->s.fault = fault;
    }
  }

  /// Ends the force where a pressed body is not computed any more, whose last answer would hold the hand where it was.
  void judgeAge(double age_s) noexcept { this->latch(age_s > this->p.softLate_s ? Fault::BodyLate : Fault::None); }
};

} // namespace palpate
