// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/ArmLink.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace palpate
{
namespace
{

constexpr int mostSettling = 20; ///< answers within which counters that were set must show

bool isFinite(const Wrench& wrench) noexcept
{
  return wrench.force.allFinite() && wrench.torque.allFinite();
}

} // namespace

ArmLink::ArmLink(std::shared_ptr<ArmBus> bus, HidEntry entry, const ArmSetup& setup, const Clock& clock)
  : bus_(std::move(bus)), search_(std::move(entry)), setup_(setup),
    arm_(setup.plan ? std::optional<Arm>(*setup.plan) : std::nullopt), clock_(clock), limit_N_(setup.force_N.value)
{
}

std::string ArmLink::attach()
{
  return this->prepare(this->search_.first(*this->bus_));
}

std::string ArmLink::prepare(const FoundDevice& found)
{
  if (!found.entry)
  {
    return found.problem;
  }
  ArmBus::Opened opened = this->bus_->open(*found.entry);
  if (opened.value == nullptr)
  {
    return "\"" + found.entry->name + "\": " + opened.problem;
  }
  auto device = std::make_shared<Attached>();
  device->line = std::move(opened.value);
  device->unwrap = CounterUnwrap(this->setup_.counterBits);
  device->good_ns = this->clock_.now_ns();
  device->counted = this->setup_.pose.empty();
  this->search_.found(*this->bus_, *found.entry);
  {
    const std::lock_guard lock(this->stopMutex_);
    this->endedFor_.clear();
  }
  this->exchange_.mute(); // requests to the arm before
  this->exchange_.tell(std::nullopt);
  this->held_.hold(std::move(device), [this] { this->exchange_.presence.found(); });
  return {};
}

void ArmLink::reattach(std::int64_t now_ns)
{
  if (!this->pause_.over(now_ns))
  {
    return;
  }
  if (std::string problem = this->prepare(this->search_.again(*this->bus_)); !problem.empty())
  {
    this->held_.say(std::move(problem));
  }
}

void ArmLink::detach() noexcept
{
  if (const std::shared_ptr<Attached> device = this->held_.get())
  {
    device->line->letGo();
  }
  this->exchange_.presence.left();
  this->held_.letGo();
}

bool ArmLink::pass()
{
  const std::int64_t now_ns = this->clock_.now_ns();
  const std::shared_ptr<Attached> device = this->held_.get();
  if (device == nullptr)
  {
    this->reattach(now_ns);
    return false;
  }
  if (device->line->step())
  {
    device->line->proceed();
    device->good_ns = this->clock_.now_ns();
    return false;
  }
  const WireOrder order = this->orderOf(*device, now_ns);
  this->asking_ns_ = now_ns;
  ArmLine::Answer answer = device->line->exchange(order, answer_ms);
  this->asking_ns_ = notAsking;
  this->take(device, answer, now_ns);
  return true;
}

/// Steps of a clock that jumps count as silence, once.
bool ArmLink::fallsSilent(std::uint64_t beat, std::int64_t now_ns) noexcept
{
  if (beat != this->beat_ || now_ns < this->beat_ns_)
  {
    this->beat_ = beat;
    this->beat_ns_ = now_ns;
  }
  return now_ns - this->beat_ns_ > silence_ns;
}

WireOrder ArmLink::orderOf(Attached& device, std::int64_t now_ns) noexcept
{
  WireOrder order;
  device.pushed_N = 0.0;
  const PidOutput::Wish wish = this->exchange_.wish();
  const bool silent = this->fallsSilent(wish.beat, now_ns);
  if (device.setCounters.exchange(false))
  {
    order.counters = this->setup_.counters;
    device.unwrap.restart();
    device.settling = mostSettling;
    return order;
  }
  if (!silent && device.doubts == 0 && device.mayPush && device.counted && !wish.command.lapses)
  {
    this->push(device, wish.command.wrench_D, order);
  }
  return order;
}

/// Whatever is beyond a limit is made smaller as a whole: the direction stays.
void ArmLink::push(Attached& device, const Wrench& wrench_D, WireOrder& order) noexcept
{
  const double asked_N = wrench_D.force.norm(), limit_N = this->limit_N_;
  if (!isFinite(wrench_D) || !(limit_N > 0.0))
  {
    return;
  }
  const double share = asked_N > limit_N ? limit_N / asked_N : 1.0;
  device.pushed_N = asked_N;
  if (asked_N > 0.0)
  {
    this->forgetEnd(device);
  }
  order.wrench_D.force = device.still.share() * share * wrench_D.force;
  if (!this->arm_ || !device.reached)
  {
    return;
  }
  const JointVector torque_Nm = this->arm_->givenTorqueOf(
    device.reached->joints, device.reached->posture, order.wrench_D, JointVector::Zero(this->arm_->joints()));
  const JointVector motor_Nm = this->arm_->motorTorqueOf(torque_Nm);
  for (int i = 0; i < std::min<int>(this->arm_->motors(), WireOrder::motors); ++i)
  {
    order.joint_Nm[static_cast<std::size_t>(i)] = torque_Nm[i];
    order.motor_Nm[static_cast<std::size_t>(i)] = motor_Nm[i];
  }
}

void ArmLink::take(const std::shared_ptr<Attached>& device, ArmLine::Answer& answer, std::int64_t asked_ns)
{
  const std::int64_t now_ns = this->clock_.now_ns();
  const bool late = now_ns - asked_ns > answer_ms * perMs_ns || now_ns < asked_ns;
  device->doubts = answer.said != ArmLine::Said::Reading || late ? device->doubts + 1 : 0;
  ++this->counts_.outputs;
  if (device->doubts == 0)
  {
    device->good_ns = now_ns;
    this->takeReading(*device, answer.reading);
    ++this->counts_.inputs;
    this->counts_.rate.count(1, now_ns);
    return;
  }
  this->counts_.strange += answer.said == ArmLine::Said::Nonsense ? 1 : 0;
  const std::int64_t bound_ns = device->doubts > 1 ? lostAfter_ns : silence_ns;
  const bool silent = now_ns - device->good_ns > bound_ns || now_ns < asked_ns;
  if (answer.said == ArmLine::Said::Gone || silent)
  {
    this->lose(device, answer.said == ArmLine::Said::Reading ? "the device answers too late" : device->line->error());
  }
}

void ArmLink::takeReading(Attached& device, WireReading& reading)
{
  device.unwrap.follow(reading.encoder);
  {
    const std::lock_guard lock(this->stopMutex_);
    this->stopped_ = reading.stopped;
  }
  if (reading.calibrated && !this->setup_.pose.empty() && device.settling == 0)
  {
    device.setCounters = true;
  }
  this->takeCounters(device, reading);
  device.homed = reading.homed;
  const std::optional<HandExchange::Hand> hand = this->handOf(device, reading);
  device.mayPush = reading.homed && hand && reading.stopped.empty();
  if (hand)
  {
    device.still.follow(hand->p_D, device.pushed_N, PositionWatch::counts * this->limit_N_, this->clock_.now_ns());
    device.faded = device.still.share() == 0.0;
  }
  this->judgeUse(device, reading, hand.has_value());
  this->exchange_.tell(reading.homed && device.counted ? hand : std::nullopt);
}

/// An arm that becomes useless while it is attached is lost for the servo: only a person brings its force back.
void ArmLink::judgeUse(Attached& device, const WireReading& reading, bool hasHand)
{
  const bool before = std::exchange(device.usable, device.mayPush && device.counted);
  if (!before || device.usable)
  {
    return;
  }
  {
    const std::lock_guard lock(this->stopMutex_);
    this->endedFor_ = !reading.stopped.empty() ? reading.stopped
                      : !reading.homed         ? "the arm no longer knows its position"
                      : !hasHand               ? "the arm reports a position in which its links do not close"
                                               : "the counters of the arm are being set";
  }
  device.ended = true;
  this->exchange_.mute();
  this->exchange_.presence.stalled();
}

/// An arm that pushes again has no end of its force to explain any more.
void ArmLink::forgetEnd(Attached& device) noexcept
{
  if (std::exchange(device.ended, false))
  {
    const std::lock_guard lock(this->stopMutex_);
    this->endedFor_.clear();
  }
}

/// Counters that were set are believed once the device shows them.
void ArmLink::takeCounters(Attached& device, const WireReading& reading) noexcept
{
  if (device.settling == 0)
  {
    return;
  }
  --device.settling;
  bool shown = true;
  for (std::size_t i = 0; i < this->setup_.counters.size(); ++i)
  {
    shown = shown && std::fabs(reading.encoder[i] - this->setup_.counters[i]) < this->setup_.poseTolerance;
  }
  device.counted = shown;
  device.settling = shown ? 0 : device.settling;
}

std::optional<HandExchange::Hand> ArmLink::handOf(Attached& device, const WireReading& reading) const noexcept
{
  HandExchange::Hand hand;
  hand.buttons = reading.buttons;
  hand.grip = reading.grip;
  if (!this->arm_)
  {
    const Pose pose_D = reading.pose_D.value_or(Pose{});
    hand.p_D = pose_D.p;
    hand.q_D = pose_D.q;
    hand.velocity_D = reading.velocity_D.value_or(Twist{});
    return reading.pose_D && pose_D.p.allFinite() ? std::optional(hand) : std::nullopt;
  }
  JointVector turned_rad(this->arm_->joints());
  for (int i = 0; i < this->arm_->joints(); ++i)
  {
    const double unit =
      this->setup_.tellsAngles ? 360.0 : this->arm_->plan().joints[static_cast<std::size_t>(i)].countsPerTurn;
    turned_rad[i] = 2.0 * std::numbers::pi * reading.encoder[static_cast<std::size_t>(i)] / unit;
  }
  Attached::Reached& reached = device.reached.emplace();
  reached.joints = this->setup_.tellsAngles ? turned_rad : this->arm_->jointsOfEncoders(turned_rad);
  reached.posture = this->arm_->posture(reached.joints);
  hand.p_D = reached.posture.tip.p - this->arm_->plan().workSpace.centre_D;
  hand.q_D = reached.posture.tip.q;
  return reached.posture.exists ? std::optional(hand) : std::nullopt;
}

void ArmLink::lose(const std::shared_ptr<Attached>& device, const std::string& why)
{
  device->line->letGo();
  this->counts_.rate.restart();
  static_cast<void>(this->held_.letGo(device, why, [this] { this->exchange_.presence.lost(); }));
  this->search_.lost(*this->bus_);
}

std::optional<DeviceStep> ArmLink::step() const
{
  const std::shared_ptr<Attached> device = this->held_.get();
  if (device == nullptr)
  {
    return std::nullopt;
  }
  if (std::optional<DeviceStep> own = device->line->step())
  {
    return own;
  }
  if (!device->counted)
  {
    return DeviceStep{ this->setup_.pose, "Set Counters" };
  }
  return device->homed || this->setup_.homing.empty() ? std::nullopt
                                                      : std::optional(DeviceStep{ this->setup_.homing, "" });
}

void ArmLink::stepDone(const std::string& file)
{
  const std::shared_ptr<Attached> device = this->held_.get();
  if (device == nullptr)
  {
    return;
  }
  if (device->line->step())
  {
    device->line->stepDone(file);
  }
  else if (!device->counted)
  {
    device->setCounters = true;
  }
}

LinkReport ArmLink::report() const
{
  LinkReport report;
  this->counts_.reportTo(report);
  report.losses = this->exchange_.presence.losses();
  this->held_.reportTo(report);
  const std::optional<DeviceStep> next = this->step();
  const std::int64_t asking_ns = this->asking_ns_;
  const std::lock_guard lock(this->stopMutex_);
  report.endedFor = report.attached ? this->endedFor_ : "";
  if (report.attached && !this->stopped_.empty())
  {
    report.message = this->stopped_;
  }
  else if (report.attached && asking_ns != notAsking && this->clock_.now_ns() - asking_ns > stuckAfter_ns)
  {
    report.message = "the link to the device hangs";
  }
  else if (next)
  {
    report.message = next->sentence;
  }
  else if (const std::shared_ptr<Attached> device = this->held_.get(); device != nullptr && device->faded)
  {
    report.message = "the readings have not changed for 1.5 s under force, so the force has ended: move the handle; "
                     "if that brings no force back, unplug the device";
  }
  return report;
}

} // namespace palpate
