// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/ForceRenderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/contact/view/PlanFor.h"
#include "haptics/contact/view/Resolution.h"
#include "haptics/force/VirtualCoupling.h"
#include "haptics/safety/ForceLimits.h"
#include "haptics/tick/ProxyStep.h"

namespace palpate
{

const char* name(EngageState state) noexcept
{
  switch (state)
  {
    case EngageState::Safe:
      return "safe";
    case EngageState::Armed:
      return "armed";
    case EngageState::Engaged:
      return "engaged";
    case EngageState::Fault:
      return "fault";
  }
  return "unknown";
}

namespace
{

constexpr double deviceLoop_s = 1e-3;     // of a device that closes walls itself
constexpr double badSampleWindow_s = 1.0; // the third bad sample within it latches

class Render
{
public:
  Render(const TickInput& input, const HapticParameters& parameters, RendererState& state, PathSink* sink) noexcept
    : in_(input), p_(parameters),
      plan_(input.scene != nullptr ? planFor(*input.scene, parameters.contact) : parameters.contact), s_(state),
      step_(sceneStep(input, state)), sink_(sink)
  {
    this->out_.state.tick = input.tick;
    this->out_.state.time_s = input.sample.time_s;
    this->out_.state.sceneRevision = input.scene != nullptr ? input.scene->revision() : 0;
  }

  TickOutput run() noexcept
  {
    this->takeEvents();
    this->s_.sinceBad_s += this->in_.dt_s;
    this->s_.sinceBadBefore_s += this->in_.dt_s;
    if (this->in_.status == DeviceStatus::Lost)
    {
      this->latch(Fault::DeviceLost);
      this->s_.gain = 0.0;
    }
    this->latchIf(this->in_.lateness.fault);
    if (this->in_.status == DeviceStatus::Waiting)
    {
      return this->holdNothing();
    }
    if (!isFinite(this->in_.sample) || !this->p_.map.toScene(this->in_.sample.pose_D.p).allFinite())
    {
      this->countBadSample();
      return this->holdNothing();
    }
    this->stiffen();
    this->watchHand();
    this->contact();
    this->latchIf(judgeHand(this->p_.safety.hand, this->out_.state.velocity_D.norm(), this->s_.lastForce_D.norm(),
      this->out_.state.energy.excess_J));
    this->blendScenes();
    this->arrive();
    this->protect();
    return this->out_;
  }

private:
  [[nodiscard]] bool touchable() const noexcept { return this->in_.scene != nullptr && !this->in_.scene->empty(); }

  void latch(Fault fault) noexcept
  {
    if (this->s_.engage != EngageState::Fault)
    {
      this->s_.engage = EngageState::Fault;
      this->s_.fault = fault;
    }
  }

  void latchIf(Fault fault) noexcept
  {
    if (fault != Fault::None)
    {
      this->latch(fault);
    }
  }

  /// Who lets go of what must be held is not pushed, and starts again from a small force.
  void watchHand() noexcept
  {
    const DeviceSample& sample = this->in_.sample;
    this->out_.state.frozen =
      this->s_.tracked && this->s_.watch.look(sample.pose_D.p, this->s_.lastP_D, this->s_.lastForce_D.norm(),
                            this->p_.safety.frozenAbove_N, this->in_.dt_s);
    this->out_.state.buttons = sample.buttons;
    this->out_.state.letGo = !isHeld(this->p_.safety.deadMan, sample.buttons, sample.grip);
    if (this->out_.state.letGo && this->s_.engage == EngageState::Engaged)
    {
      this->s_.engage = EngageState::Armed;
    }
  }

  void takeEvents() noexcept
  {
    if (!this->p_.safety.needsEngage && this->s_.engage == EngageState::Safe)
    {
      this->s_.engage = EngageState::Engaged;
      this->s_.gain = 1.0;
    }
    for (const HapticEvent& event : this->in_.events)
    {
      if (event.kind == EventKind::Engage && this->s_.engage != EngageState::Engaged)
      {
        this->s_.engage = EngageState::Armed;
        this->s_.fault = Fault::None;
        this->s_.sinceBad_s = this->s_.sinceBadBefore_s = RendererState::longAgo_s;
        this->s_.gain = 0.0;
      }
      else if (event.kind == EventKind::Play)
      {
        this->again_ = true;
      }
      else if (event.kind == EventKind::Release)
      {
        this->s_.engage = EngageState::Safe;
        this->s_.fault = Fault::None;
      }
    }
  }

  /// The third within a second latches.
  void countBadSample() noexcept
  {
    if (this->s_.sinceBadBefore_s < badSampleWindow_s)
    {
      this->latch(Fault::NonFiniteSample);
      this->s_.gain = 0.0;
    }
    this->s_.sinceBadBefore_s = this->s_.sinceBad_s;
    this->s_.sinceBad_s = 0.0;
  }

  /// No force in a tick that does not know where the hand is.
  TickOutput holdNothing() noexcept
  {
    this->s_.lastForce_D = Vec3::Zero();
    this->s_.lastGuide_D = Vec3::Zero();
    this->s_.ownForce = false;
    this->s_.velocity.count = 0;
    this->s_.tracked = false;
    this->s_.walls = {};
    this->out_.state.held = true;
    this->out_.state.buttons = this->in_.sample.buttons;
    this->out_.state.letGo = !isHeld(this->p_.safety.deadMan, this->in_.sample.buttons, this->in_.sample.grip);
    this->out_.state.game = this->s_.game.phase;
    this->out_.state.gameTime_s = this->s_.game.time_s;
    this->out_.state.proxy_W.p = this->s_.contact.x_W;
    this->report();
    return this->out_;
  }

  void stiffen() noexcept
  {
    HapticState& state = this->out_.state;
    state.stiffnessFactor = this->in_.lateness.stiffnessFactor;
    state.stiffnessLimited = this->p_.stiffness_N_per_m > this->p_.stiffnessLimit_N_per_m;
    state.stiffness_N_per_m =
      std::min(this->p_.stiffness_N_per_m, this->p_.stiffnessLimit_N_per_m) * state.stiffnessFactor;
    this->plan_.coupling_N_per_m = state.stiffness_N_per_m;
  }

  void contact() noexcept
  {
    HapticState& state = this->out_.state;
    state.device_W = { this->p_.map.toScene(this->in_.sample.pose_D.p), this->p_.map.q_WD * this->in_.sample.pose_D.q };
    state.velocity_D =
      estimateVelocity(this->p_.velocity, this->in_.sample.pose_D.p, this->in_.dt_s, this->s_.velocity);
    this->lead();
    const ProxyStep moved = moveProxy(
      { this->in_, this->step_, this->plan_, this->p_.map, this->touchable() && this->game_.contact, this->sink_ },
      this->target_W(), this->s_);
    const ContactResult& result = moved.contact;
    state.pinned = moved.pinned;
    state.proxy_W = { result.proxy_W, state.device_W.q };
    state.contacts = result.contacts;
    state.passes = result.passes;
    state.sweeps = result.sweeps;
    state.work = moved.carryWork + result.work;
    state.friction = result.friction;
    state.capped = result.capped;
    state.overBudget = result.overBudget;
    state.infeasible = result.infeasible;
    this->seatFailed_ = result.seatFailed;
    const double scale_u_per_m = this->p_.map.scale_u_per_m;
    const double share = this->isRounding(result) ? 0.0 : 1.0 / scale_u_per_m;
    this->couple(this->p_.map.directionToDevice(share * result.pull_W), share * std::sqrt(result.held_u2));
    this->guide();
  }

  /// Where contact is computed: a hand that is led to a plane touches what is below it there.
  [[nodiscard]] Vec3 target_W() const noexcept
  {
    const Vec3& p_W = this->out_.state.device_W.p;
    return this->p_.guide.on ? this->p_.guide.foot_W(p_W) : p_W;
  }

  /// The foot of a hand that moves across the plane stays but for rounding, and that is not a spring to be damped.
  [[nodiscard]] bool isRounding(const ContactResult& result) const noexcept
  {
    Resolution resolution;
    resolution.include(result.proxy_W);
    resolution.include(this->out_.state.device_W.p);
    return this->p_.guide.on && result.pull_W.norm() <= resolution.tol();
  }

  /// Only once force is given, so that who is far from the plane can ask for it.
  void guide() noexcept
  {
    HapticState& state = this->out_.state;
    GuidePlan plan = this->p_.guide;
    const bool on = plan.on && this->s_.engage == EngageState::Engaged;
    this->s_.guideShare = rampedShare(this->s_.guideShare, on, plan.ramp_s, this->in_.dt_s);
    state.guideShare = this->s_.guideShare;
    this->s_.lastGuide_D = Vec3::Zero();
    if (state.guideShare > 0.0)
    {
      plan.stiffness_N_per_m =
        std::min(plan.stiffness_N_per_m, this->p_.stiffnessLimit_N_per_m) * state.stiffnessFactor;
      const double height_m = plan.normal_W.dot(state.device_W.p - plan.point_W) / this->p_.map.scale_u_per_m;
      const Vec3 normal_D = this->p_.map.directionToDevice(plan.normal_W);
      this->s_.lastGuide_D =
        guideForce(plan, state.guideShare, height_m, normal_D.dot(state.velocity_D), this->in_.dt_s) * normal_D;
      state.rendered_D += this->s_.lastGuide_D;
      this->coupled_D_ = state.rendered_D;
    }
  }

  /// Whose hand is led to the start of a labyrinth feels no wall on the way.
  void lead() noexcept
  {
    GameTick tick;
    tick.hand_D = this->in_.sample.pose_D.p;
    tick.velocity_D = this->out_.state.velocity_D;
    tick.start_D = this->p_.map.toDevice(this->p_.game.start_W);
    tick.stiffness_N_per_m = this->p_.stiffnessLimit_N_per_m * this->out_.state.stiffnessFactor;
    tick.engaged = this->s_.engage == EngageState::Engaged && this->touchable();
    tick.again = this->again_;
    tick.dt_s = this->in_.dt_s;
    tick.loop_s = this->p_.walls.hold ? deviceLoop_s : this->in_.dt_s;
    this->game_ = palpate::lead(this->p_.game, tick, this->s_.game);
    if (this->game_.seat)
    {
      this->s_.contact = GodObjectState{};
      this->s_.contact.x_W = this->s_.contact.device_W = this->p_.game.start_W;
      this->s_.contact.placed = true;
    }
  }

  /// The lead and the shaking at the exit; a device that holds the walls shakes by itself, however slow its link is.
  void arrive() noexcept
  {
    HapticState& state = this->out_.state;
    const Vec3 shake_D = palpate::arrive(this->p_.game, state.proxy_W.p, this->in_.dt_s, this->s_.game);
    state.game = this->s_.game.phase;
    state.gameTime_s = this->s_.game.time_s;
    if (this->p_.walls.hold && state.game == GamePhase::Arrived)
    {
      this->out_.command.signal = Signal::Oscillation;
    }
    if (this->game_.walls < 1.0)
    {
      state.rendered_D = this->game_.walls * state.rendered_D + this->game_.lead_D;
    }
    state.rendered_D += shake_D;
  }

  /// Spring, damper, and the damping that keeps their held force passive. Pull in D and the stretch of
  /// a plain spring that holds as much energy [m].
  void couple(const Vec3& pull_D, double stretch_m) noexcept
  {
    HapticState& state = this->out_.state;
    const Vec3 plain_D = coupleDevice(pull_D, state.velocity_D, state.stiffness_N_per_m, this->p_.damping_Ns_per_m);
    const SpringTick spring = this->springTick(pull_D, stretch_m);
    measureEnergy(spring, this->s_.energy);
    state.energy = this->s_.energy;
    const double damping = stabilisingDamping(this->p_.passivity, spring, this->s_.energy);
    state.rendered_D = damping == 0.0 ? plain_D
                                      : coupleDevice(pull_D, state.velocity_D, state.stiffness_N_per_m,
                                          this->p_.damping_Ns_per_m + damping);
    state.stabiliser_D = state.rendered_D - plain_D;
    this->coupled_D_ = state.rendered_D;
  }

  /// What the hand did in the period that ended, under the force it really got.
  [[nodiscard]] SpringTick springTick(const Vec3& pull_D, double stretch_m) noexcept
  {
    const HapticState& state = this->out_.state;
    const Vec3& p_D = this->in_.sample.pose_D.p;
    SpringTick spring;
    const double pull_m = pull_D.norm();
    spring.stretch_m = stretch_m;
    spring.inward_m_per_s = pull_m > 0.0 ? -pull_D.dot(state.velocity_D) / pull_m : 0.0;
    spring.stiffness_N_per_m = state.stiffness_N_per_m;
    const Vec3 contact_D = this->s_.ownForce ? Vec3(this->s_.lastForce_D - this->s_.lastGuide_D) : this->s_.lastForce_D;
    spring.work_J = this->s_.tracked ? contact_D.dot(p_D - this->s_.lastP_D) : 0.0;
    spring.dt_s = this->in_.dt_s;
    spring.restart = !this->s_.ownForce || this->step_.replaced;
    this->s_.lastP_D = p_D;
    this->s_.tracked = true;
    return spring;
  }

  /// F = F_new + (F_old - F_new) decaying: a replaced scene never steps (Mark et al. 1996). Not for the first scene,
  /// not for surfaces that only move or bend, and not a safety limit.
  void blendScenes() noexcept
  {
    HapticState& state = this->out_.state;
    if (this->step_.replaced && this->s_.sceneRevision != 0 && this->p_.sceneBlend_s > 0.0)
    {
      this->s_.blend_D += this->s_.lastRendered_D - state.rendered_D;
    }
    else
    {
      const double blend_s = this->p_.sceneBlend_s;
      this->s_.blend_D *= blend_s > 0.0 ? blend_s / (blend_s + this->in_.dt_s) : 0.0;
    }
    this->s_.sceneAge_s = this->step_.age_s;
    this->s_.sceneRevision = state.sceneRevision;
    this->s_.sceneGeometry = this->in_.scene != nullptr ? this->in_.scene->geometryHash() : 0;
    this->s_.lastRendered_D = state.rendered_D;
    state.rendered_D += this->s_.blend_D;
  }

  void protect() noexcept
  {
    HapticState& state = this->out_.state;
    const SafetyLimits& limits = this->p_.safety;
    if (this->s_.engage == EngageState::Armed && !state.letGo && !this->seatFailed_ && this->touchable() &&
        state.rendered_D.norm() <= limits.engageBelow_N)
    {
      this->s_.engage = EngageState::Engaged;
    }
    this->updateGain();
    if (this->deviceHolds())
    {
      this->game_.walls < 1.0 ? this->giveLead() : this->giveWalls();
      this->report();
      return;
    }
    this->s_.walls = {};
    Vec3 force = smoothstep(this->s_.gain) * (this->seatFailed_ ? Vec3(Vec3::Zero()) : state.rendered_D);
    const Vec3 clamped = clampMagnitude(force, limits.maxForce_N);
    state.clamped = clamped != force;
    force = limitRise(clamped, this->s_.lastForce_D, limits.maxRise_N_per_s, this->in_.dt_s);
    state.riseLimited = force != clamped;
    if (!force.allFinite())
    {
      force = Vec3::Zero();
      this->latch(Fault::NonFiniteSample);
    }
    this->s_.lastForce_D = force;
    this->s_.ownForce = force == this->coupled_D_;
    state.force_D = force;
    state.force_W = this->p_.map.directionToScene(force);
    this->out_.command.wrench_D.force = force;
    this->report();
  }

  [[nodiscard]] bool deviceHolds() const noexcept
  {
    return this->p_.walls.hold && this->touchable() && !this->seatFailed_ && this->s_.gain > 0.0;
  }

  /// The force on the hand is the device's business; what is told of it is what the walls give at rest.
  void giveWalls() noexcept
  {
    HapticState& state = this->out_.state;
    const SafetyLimits& limits = this->p_.safety;
    const WallTick tick{ *this->in_.scene, this->plan_, this->s_.contact, this->p_.map, this->in_.sample.pose_D.p,
      state.stiffness_N_per_m, limits.maxRise_N_per_s, this->in_.dt_s, this->in_.scene->shareAt(this->s_.sceneAge_s) };
    state.work += keepWalls(this->p_.walls, tick, this->s_.walls);
    const double share = smoothstep(this->s_.gain);
    const double stiffness_N_per_m = heldStiffness(share * state.stiffness_N_per_m, tick, this->s_.walls);
    command(this->s_.walls.walls, stiffness_N_per_m, this->out_.command, limits.maxForce_N);
    this->out_.command.viscosity_Ns_per_m = share * this->p_.walls.viscosity_Ns_per_m;
    rampLimits(tick, this->s_.walls, this->out_.command);
    this->tellHeld();
  }

  /// Opposite walls at one place are the spring of the lead.
  void giveLead() noexcept
  {
    const double share = smoothstep(this->s_.gain);
    const Vec3& drawn_D = this->s_.game.drawn_D;
    this->s_.walls = {};
    AxisWalls walls;
    for (int i = 0; i < AxisWalls::count; ++i)
    {
      walls.offset_m[static_cast<std::size_t>(i)] = AxisWalls::direction(i).dot(drawn_D);
    }
    command(walls, share * this->game_.spring_N_per_m, this->out_.command,
      std::min(
        std::numbers::sqrt2 * share * this->game_.spring_N, this->p_.safety.maxForce_N)); // along an axis all of it
    this->out_.command.viscosity_Ns_per_m = share * this->game_.damping_Ns_per_m;
    this->tellHeld();
  }

  /// What walls and viscosity of the command give a hand where it is [N].
  [[nodiscard]] Vec3 heldForce() const noexcept
  {
    const DeviceCommand& held = this->out_.command;
    return forceOfWalls(held, this->in_.sample.pose_D.p) - held.viscosity_Ns_per_m * this->out_.state.velocity_D;
  }

  /// What the device gives by itself, as far as the host knows. Walls that are not numbers are not sent. Energy is not
  /// metered: the force that is told is a spring's, a function of the place, and gives nothing over a closed way
  /// whatever the device really does.
  void tellHeld() noexcept
  {
    HapticState& state = this->out_.state;
    const Vec3 held_D = this->heldForce();
    const Vec3 force_D = clampMagnitude(held_D, this->p_.safety.maxForce_N);
    state.clamped = force_D != held_D;
    const bool usable = isFinite(this->out_.command) && force_D.allFinite();
    if (!usable)
    {
      this->s_.walls = {};
      this->out_.command.wallCount = 0;
      this->out_.command.viscosity_Ns_per_m = 0.0;
      this->latch(Fault::NonFiniteSample);
    }
    state.force_D = usable ? force_D : Vec3(Vec3::Zero());
    state.force_W = this->p_.map.directionToScene(state.force_D);
    state.deviceHolds = true;
    state.walls = this->out_.command.wallCount;
    this->s_.lastForce_D = state.force_D;
    this->s_.ownForce = false;
  }

  /// Up over the engage ramp; down over the release ramp, or the shorter one of a fault.
  void updateGain() noexcept
  {
    const SafetyLimits& limits = this->p_.safety;
    const auto step = [this](double ramp_s) { return ramp_s > 0.0 ? this->in_.dt_s / ramp_s : 1.0; };
    if (this->s_.engage == EngageState::Engaged && (this->touchable() || !limits.needsEngage))
    {
      this->s_.gain = std::min(1.0, this->s_.gain + step(limits.engageRamp_s));
    }
    else
    {
      const double ramp_s = this->s_.engage == EngageState::Fault ? limits.faultRamp_s : limits.releaseRamp_s;
      this->s_.gain = std::max(0.0, this->s_.gain - step(ramp_s));
    }
  }

  void report() noexcept
  {
    HapticState& state = this->out_.state;
    state.sceneAge_s = this->s_.sceneAge_s;
    const bool underWay = this->touchable() && this->in_.scene->shareAt(state.sceneAge_s) < 1.0;
    state.motionLag_s = underWay ? this->in_.scene->motion_s() : 0.0;
    state.engage = this->s_.engage;
    state.gain = this->s_.gain;
    state.fault = this->s_.fault;
    if (state.fault == Fault::None && this->in_.status == DeviceStatus::Waiting)
    {
      state.fault = Fault::NoHand;
    }
    else if (state.fault == Fault::None && this->seatFailed_)
    {
      state.fault = Fault::Seated;
    }
    else if (state.fault == Fault::None && !this->touchable())
    {
      state.fault = Fault::SceneRefused;
    }
  }

  const TickInput& in_;
  const HapticParameters& p_;
  ContactPlan plan_; ///< with the stiffness of this tick
  RendererState& s_;
  SceneStep step_;
  PathSink* sink_;
  TickOutput out_;
  GameForce game_;
  bool again_ = false; ///< another game is asked for
  bool seatFailed_ = false;
  Vec3 coupled_D_ = Vec3::Zero(); ///< force of spring and damper, before blend and limits [N]
};

} // namespace

TickOutput renderTick(
  const TickInput& input, const HapticParameters& parameters, RendererState& state, PathSink* sink) noexcept
{
  return Render(input, parameters, state, sink).run();
}

} // namespace palpate
