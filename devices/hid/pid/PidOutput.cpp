// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/pid/PidOutput.h"

#include <algorithm>
#include <utility>

#include "haptics/core/Clock.h"
#include "haptics/safety/ForceLimits.h"

namespace palpate
{
namespace
{

constexpr std::int64_t answersWithin_ns = 50 * perMs_ns; // a device reports its actuators and its effects

bool same(const Condition& a, const Condition& b) noexcept
{
  return a.centre == b.centre && a.deadBand == b.deadBand && a.positiveCoefficient == b.positiveCoefficient &&
         a.negativeCoefficient == b.negativeCoefficient && a.positiveSaturation == b.positiveSaturation &&
         a.negativeSaturation == b.negativeSaturation;
}

/// The wall on one side of a condition.
struct Side
{
  double beyond = 0.0; ///< so much of the travel lies behind it
  double coefficient = 0.0, saturation = 0.0;
};

Side lowerSide(const Condition& c) noexcept
{
  return { 1.0 + c.centre - c.deadBand, c.negativeCoefficient, c.negativeSaturation };
}

Side upperSide(const Condition& c) noexcept
{
  return { 1.0 - c.centre - c.deadBand, c.positiveCoefficient, c.positiveSaturation };
}

bool lessens(const Side& before, const Side& now) noexcept
{
  constexpr double nothing = 1e-9;
  const bool pushed = before.coefficient > 0.0 && before.beyond > nothing;
  return pushed &&
         (now.coefficient < before.coefficient || now.saturation < before.saturation || now.beyond <= nothing);
}

/// A wall is gone, or softer, or may push less hard than it did.
bool lessens(const Condition& before, const Condition& now) noexcept
{
  return lessens(lowerSide(before), lowerSide(now)) || lessens(upperSide(before), upperSide(now));
}

bool lessens(const std::array<Condition, 4>& before, const std::array<Condition, 4>& now) noexcept
{
  bool any = false;
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    any = any || lessens(before[i], now[i]);
  }
  return any;
}

} // namespace

PidOutput::PidOutput(EffectEngine& engine, const PidOutputOptions& options, const PidKind& kind) noexcept
  : engine_(engine), options_(options), kind_(kind),
    shake_(engine, { options.duration_ms, options.restartEvery_ms, options.wallsEvery_ms }),
    rumble_({ options.scale.maxForce_N, options.largestShare })
{
}

std::string PidOutput::begin()
{
  if (std::string problem = this->makeForces(); !problem.empty())
  {
    return problem;
  }
  this->makeConditions();
  std::string problem = this->kind_.shaking ? this->shake_.begin(*this->kind_.shaking) : "";
  if (this->kind_.pushedAxes == 0)
  {
    return problem;
  }
  // Last, so that a device that went meanwhile is not taken for one that merely lacks an effect.
  bool takes = true;
  for (std::size_t axis = 0; axis < this->kind_.pushedAxes; ++axis)
  {
    takes = takes && this->engine_.setConstantForce(this->forces_[axis].block, 0.0);
  }
  return takes ? "" : "the device rejects a force: " + this->engine_.error();
}

std::string PidOutput::makeForces()
{
  for (std::size_t axis = 0; axis < this->kind_.pushedAxes; ++axis)
  {
    if (std::string problem = this->make(this->forces_[axis], pid::constantForce, pidAxes[axis].comesFrom_deg);
        !problem.empty())
    {
      return problem;
    }
  }
  return {};
}

DeviceAbilities PidOutput::abilities() const noexcept
{
  return { static_cast<std::uint8_t>(this->kind_.sensedAxes), this->spring_.block > 0, this->damper_.block > 0,
    this->shake_.exists() };
}

std::string PidOutput::make(Effect& effect, HidUsage type, double comesFrom_deg)
{
  const EffectEngine::Created made = this->engine_.create(type);
  if (!made.problem.empty())
  {
    return made.problem;
  }
  effect = { { type, this->options_.duration_ms, 1.0, comesFrom_deg }, made.value };
  return this->engine_.setEffect(made.value, effect.settings) ? "" : "the device rejects the settings of an effect";
}

void PidOutput::makeConditions()
{
  const DeviceAbilities wanted = promised(this->kind_);
  this->conditions_ = this->kind_.conditions;
  if (!wanted.holdsWalls || !this->makeCondition(this->spring_, pid::spring))
  {
    this->spring_.block = 0;
    this->conditions_ = {};
  }
  if (!wanted.viscous || !this->makeCondition(this->damper_, pid::damper))
  {
    this->damper_.block = 0;
  }
}

/// Empty, as a new effect is not promised to do nothing.
bool PidOutput::makeCondition(Effect& effect, HidUsage type)
{
  bool taken = this->make(effect, type, EffectSettings{}.comesFrom_deg).empty();
  for (std::size_t axis = 0; axis < this->kind_.pushedAxes; ++axis)
  {
    taken = taken && this->engine_.setCondition(effect.block, static_cast<int>(axis), {});
  }
  return taken && this->engine_.setEffect(effect.block, effect.settings);
}

std::array<PidOutput::Effect*, 4> PidOutput::effects() noexcept
{
  return { &this->forces_[0], &this->forces_[1], &this->spring_, &this->damper_ };
}

PidOutput::Step PidOutput::step(std::int64_t now_ns, const Wish& wish) noexcept
{
  if (this->fallsSilent(now_ns, wish.beat))
  {
    return sentOrFailed(this->engine_.control(pid::stopAll));
  }
  // While silent the effects are emptied: no effect may start again with an old force.
  const Wish wanted = this->silent_ ? Wish{} : wish;
  Step step = this->silent_ ? this->endLingering(now_ns) : this->enable(now_ns);
  if (step == Step::Idle && this->kind_.pushedAxes == 0)
  {
    return this->shake_.vibrate(now_ns, this->rumble_.next(now_ns, wanted.command, wanted.p_D));
  }
  if (step == Step::Idle && !this->silent_)
  {
    step = this->restart(now_ns, wanted);
  }
  if (step == Step::Idle)
  {
    step = this->sendWalls(now_ns, wanted);
  }
  if (step == Step::Idle)
  {
    step = this->shake_.play(wanted.command.signal);
  }
  return step == Step::Idle ? this->sendForce(wanted) : step;
}

bool PidOutput::fallsSilent(std::int64_t now_ns, std::uint64_t beat) noexcept
{
  if (this->beat_ns_ == never || beat != this->beat_)
  {
    this->beat_ = beat;
    this->beat_ns_ = now_ns;
    this->silent_ = false;
    return false;
  }
  if (this->silent_ || now_ns - this->beat_ns_ <= this->options_.silence_ms * perMs_ns)
  {
    return false;
  }
  this->silent_ = true;
  this->askedSince_ns_ = never;
  this->allStopped(now_ns);
  return true;
}

void PidOutput::allStopped(std::int64_t now_ns) noexcept
{
  this->enabled_ = false;
  for (Effect* effect : this->effects())
  {
    effect->lingers = effect->lingers || effect->started_ns != never;
    effect->started_ns = never;
    effect->stopped_ns = now_ns;
  }
  this->shake_.forget();
}

PidOutput::Step PidOutput::stop(Effect& effect, std::int64_t now_ns) noexcept
{
  effect.stopped_ns = now_ns;
  return sentOrFailed(this->engine_.stop(effect.block));
}

/// To some devices a stop of all is a pause: their effects would go on with old values once anything is set.
PidOutput::Step PidOutput::endLingering(std::int64_t now_ns) noexcept
{
  for (Effect* effect : this->effects())
  {
    if (std::exchange(effect->lingers, false))
    {
      return this->stop(*effect, now_ns);
    }
  }
  return Step::Idle;
}

PidOutput::Step PidOutput::enable(std::int64_t now_ns) noexcept
{
  if (this->enabled_)
  {
    return Step::Idle;
  }
  this->enabled_ = true;
  this->enabled_ns_ = now_ns;
  return sentOrFailed(this->engine_.control(pid::enableActuators));
}

bool PidOutput::shouldBeOn(std::int64_t now_ns) const noexcept
{
  return this->enabled_ && (this->enabled_ns_ == never || now_ns - this->enabled_ns_ >= answersWithin_ns);
}

PidOutput::Step PidOutput::restart(std::int64_t now_ns, const Wish& wish) noexcept
{
  for (Effect* effect : this->effects())
  {
    const bool doubted =
      (effect == &this->spring_ && !wish.trust.walls) || (effect == &this->damper_ && !wish.trust.damper);
    if (doubted && std::exchange(effect->started_ns, never) != never)
    {
      return this->stop(*effect, now_ns);
    }
    const bool playing = effect->started_ns != never;
    const bool due = !playing || now_ns - effect->started_ns >= this->options_.restartEvery_ms * perMs_ns;
    effect->lapses = wish.command.lapses && (effect->lapses || (playing && due));
    if (effect->block > 0 && due && !doubted && !effect->lapses)
    {
      this->restarts_ += effect->started_ns != never ? 1 : 0;
      effect->started_ns = now_ns;
      return sentOrFailed(this->engine_.start(effect->block));
    }
  }
  return Step::Idle;
}

bool PidOutput::shouldPlay(int block, std::int64_t now_ns) const noexcept
{
  const auto should = [block, now_ns](const Effect& effect)
  {
    return effect.block == block && effect.started_ns != never && !effect.lapses &&
           (effect.stopped_ns == never || now_ns - effect.stopped_ns >= answersWithin_ns);
  };
  return block > 0 &&
         (should(this->forces_[0]) || should(this->forces_[1]) || should(this->spring_) || should(this->damper_));
}

double PidOutput::rampedShare(std::int64_t now_ns, const DeviceCommand& command) noexcept
{
  if (!asksForForce(command))
  {
    return this->options_.largestShare;
  }
  if (this->askedSince_ns_ == never)
  {
    this->askedSince_ns_ = now_ns;
  }
  const double since_ms = static_cast<double>(now_ns - this->askedSince_ns_) / static_cast<double>(perMs_ns);
  return this->options_.largestShare * smoothstep(since_ms / std::max(1, this->options_.rampUp_ms));
}

/// Walls that move wait for their time; a change that takes force away does not.
PidOutput::Step PidOutput::sendWalls(std::int64_t now_ns, const Wish& wish) noexcept
{
  const double share = this->rampedShare(now_ns, wish.command);
  const ConditionAbilities holds = wish.trust.walls ? this->conditions_ : ConditionAbilities{};
  this->plan_ = planWalls(wish.command, this->options_.scale, holds, share);
  const Condition braking = wish.trust.damper ? planDamper(wish.command, this->options_.scale, share) : Condition{};
  const Conditions wanted{ this->plan_.springs[0], this->plan_.springs[1], braking, braking };
  const bool early =
    this->wallsSent_ns_ != never && now_ns - this->wallsSent_ns_ < this->options_.wallsEvery_ms * perMs_ns;
  if (!early || lessens(this->wanted_, wanted))
  {
    this->wanted_ = wanted;
  }
  const Step step = this->sendCondition();
  this->wallsSent_ns_ = step == Step::Idle || early ? this->wallsSent_ns_ : now_ns;
  return step;
}

/// One after the other, and after all of them a turn for later reports, so that nothing starves. After those of an
/// effect its settings, again.
PidOutput::Step PidOutput::sendCondition() noexcept
{
  constexpr std::size_t perEffect = 3; // both axes, then the settings
  for (; this->turn_ < 2 * perEffect; ++this->turn_)
  {
    const std::size_t which = this->turn_ / perEffect, axis = this->turn_ % perEffect, i = 2 * which + axis;
    Effect& effect = which == 0 ? this->spring_ : this->damper_;
    if (effect.block == 0)
    {
      continue;
    }
    if (axis == perEffect - 1 && std::exchange(effect.unsettled, false))
    {
      ++this->turn_;
      return sentOrFailed(this->engine_.setEffect(effect.block, effect.settings));
    }
    if (axis < this->kind_.pushedAxes && !same(this->sent_[i], this->wanted_[i]))
    {
      ++this->turn_;
      this->sent_[i] = this->wanted_[i];
      effect.unsettled = true;
      return sentOrFailed(this->engine_.setCondition(effect.block, static_cast<int>(axis), this->wanted_[i]));
    }
  }
  this->turn_ = 0;
  return Step::Idle;
}

PidOutput::Step PidOutput::sendForce(const Wish& wish) noexcept
{
  const double largest_N = this->options_.scale.maxForce_N;
  const Vec3 walls_N =
    clampMagnitude(hostWallForce(wish.command, this->plan_, wish.p_D), this->options_.largestShare * largest_N);
  const Vec3 force_N = wish.command.wrench_D.force + wish.command.wallMotors * walls_N;
  std::array<double, 2> shares{};
  std::array<bool, 2> changed{};
  for (std::size_t axis = 0; axis < this->kind_.pushedAxes; ++axis)
  {
    const int a = static_cast<int>(axis);
    shares[axis] = pidAxes[axis].sign * PidScale::sign(a) * force_N[a] / largest_N;
    changed[axis] = this->engine_.constantForceSteps(shares[axis]) != this->sentForce_[axis];
  }
  if (!changed[0] && !changed[1])
  {
    return Step::Idle;
  }
  // Both: in turn, so that neither starves.
  const std::size_t axis = changed[0] && changed[1] ? static_cast<std::size_t>(1 - this->lastAxis_)
                           : changed[0]             ? 0
                                                    : 1;
  this->lastAxis_ = static_cast<int>(axis);
  this->sentForce_[axis] = this->engine_.constantForceSteps(shares[axis]);
  return sentOrFailed(this->engine_.setConstantForce(this->forces_[axis].block, shares[axis]));
}

} // namespace palpate
