// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/ServoLoop.h"

#include <algorithm>

#include "haptics/recording/RecordedStages.h"

namespace palpate
{
namespace
{

constexpr std::uint64_t ticksPerReport = 250; // four times a second at 1 kHz, for a person to read
/// Slack for the release to be taken and for a ramp that is no whole number of ticks; and how long a stop is waited
/// for.
constexpr double letGoSlack_s = 0.005, longestLetGo_s = 0.5;

bool pushes(const DeviceCommand& command) noexcept
{
  return command.wrench_D.force != Vec3::Zero() || command.wrench_D.torque != Vec3::Zero() || command.wallCount > 0 ||
         command.viscosity_Ns_per_m > 0.0;
}

} // namespace

ServoLoop::ServoLoop(
  HapticDevice& device, TickTimer& timer, ServoLinks& links, const Clock& costClock, double period_s) noexcept
  : device_(device), timer_(timer), links_(links), clock_(costClock), period_s_(period_s)
{
  const ServoLinks::Versioned& first = links.parameters.read();
  this->version_ = first.version;
  this->parameters_ = first.parameters;
  TickInputs::forEach(
    [this]<class K>(std::type_identity<K>) { std::get<input::WorkspaceOf<K>>(this->workspaces_).put(this->input_); });
}

void ServoLoop::run(const std::stop_token& stop) noexcept
{
  bool more = true;
  while (more && !stop.stop_requested())
  {
    more = this->tick();
  }
  if (more)
  {
    this->letGo();
  }
  this->finish();
}

/// No stop waits longer than the ramp takes, whatever keeps the force.
void ServoLoop::letGo() noexcept
{
  double left_s = std::min(this->parameters_.safety.releaseRamp_s + letGoSlack_s, longestLetGo_s);
  while (this->pushes_ && left_s > 0.0 && this->tick())
  {
    left_s -= this->input_.dt_s;
  }
}

void ServoLoop::finish() noexcept
{
  this->device_.write(DeviceCommand{});
  this->publishReport();
}

/// Everything that happens before a tick goes into the recording before the tick, in the order in which the tick takes
/// it.
void ServoLoop::takeChanges() noexcept
{
  const ServoLinks::Versioned& latest = this->links_.parameters.read();
  if (latest.version != this->version_)
  {
    this->version_ = latest.version;
    this->maps_ += isSame(latest.parameters.map, this->parameters_.map) ? 0 : 1;
    this->parameters_ = latest.parameters;
    if (this->recorder_ != nullptr)
    {
      this->recorder_->pushParameters(this->input_.tick, this->parameters_);
    }
  }
  this->takeInputs();
  this->followRecorder();
  std::size_t count = 0;
  while (count < this->events_.size() && this->links_.events.tryPop(this->events_[count]))
  {
    this->events_[count].tick = this->input_.tick;
    if (this->recorder_ != nullptr)
    {
      this->recorder_->pushEvent(this->events_[count]);
    }
    ++count;
  }
  this->input_.events = { this->events_.data(), count };
}

/// All have come before any is taken: some depend on others.
void ServoLoop::takeInputs() noexcept
{
  TickInputs::Each<input::Arrival> arrivals;
  TickInputs::forEach(
    [&]<class K>(std::type_identity<K>) { std::get<input::Arrival<K>>(arrivals) = input::arrive<K>(this->links_); });
  TickInputs::forEach(
    [&]<class K>(std::type_identity<K>)
    {
      if (input::takeInto<K>(this->input_, arrivals) && this->recorder_ != nullptr)
      {
        this->recorder_->pushInput<K>(this->input_.tick, K::of(this->input_));
      }
    });
}

bool ServoLoop::replacesInput() const noexcept
{
  bool replaces = false;
  TickInputs::forEach([&]<input::Replaces K>(std::type_identity<K>)
    { replaces = replaces || K::replaces(this->input_, this->renderer_); });
  return replaces;
}

/// Not in a tick that replaces a scene or a field: the scene before is no part of a recording that begins there.
void ServoLoop::followRecorder() noexcept
{
  Recorder* const wanted = this->links_.recorder.load(std::memory_order_acquire);
  if (wanted == this->recorder_ || this->replacesInput())
  {
    return;
  }
  if (this->recorder_ != nullptr && !this->recorder_->pushEnd())
  {
    return;
  }
  this->recorder_ = nullptr;
  const RendererState first = recordedPart(this->renderer_);
  if (wanted != nullptr && wanted->pushStart(this->parameters_, first))
  {
    this->recorder_ = wanted;
    this->renderer_ = first;
    this->pushInputs();
  }
}

/// Records the inputs that are in use when a recording begins.
void ServoLoop::pushInputs() noexcept
{
  TickInputs::forEach(
    [this]<class K>(std::type_identity<K>)
    {
      if (K::of(this->input_) != nullptr)
      {
        this->recorder_->pushInput<K>(this->input_.tick, K::of(this->input_));
      }
    });
}

void ServoLoop::tellWorkers(const TickOutput& output) noexcept
{
  const input::TickDone done{ this->input_, output, this->renderer_, this->parameters_,
    static_cast<double>(this->input_.tick) * this->period_s_, this->maps_ };
  TickInputs::forEach([&]<input::TellsWorker K>(std::type_identity<K>) { K::tellWorker(done, this->links_); });
}

/// With the faults and changes of the tick, which a reader would else learn only by computing the tick again.
void ServoLoop::recordTick(const TickOutput& output) noexcept
{
  if (this->recorder_ == nullptr)
  {
    return;
  }
  this->recorder_->pushTick(makeRecord(this->input_, output));
  if (output.state.fault != this->fault_ && output.state.fault != Fault::None)
  {
    this->recorder_->pushEvent({ this->period_, EventKind::Fault, static_cast<std::uint64_t>(output.state.fault) });
  }
  const ConstraintChanges& changes = output.state.mechanism.changes;
  for (std::uint64_t i = changes.firstOf(this->period_); i < changes.count; ++i)
  {
    const MechanismEvent& event = changes.at(i);
    this->recorder_->pushEvent(
      { this->period_, EventKind::Constraint, event.law | static_cast<std::uint64_t>(event.change) << 32 });
  }
}

bool ServoLoop::tick() noexcept
{
  const Wakeup wakeup = this->timer_.wait();
  const std::int64_t start_ns = this->clock_.now_ns();
  this->period_ += 1 + wakeup.missed;
  this->input_.tick = this->period_;
  this->input_.dt_s = static_cast<double>(1 + wakeup.missed) * this->period_s_;
  // Before the hand is asked for: a caller who changes the meaning of a pose withdraws the hand first, and feeds it
  // afterwards.
  this->takeChanges();
  this->input_.status = this->device_.read(static_cast<double>(this->period_) * this->period_s_, this->input_.sample);
  if (this->input_.status == DeviceStatus::Ended)
  {
    this->report_.ended = true;
    return false;
  }
  this->input_.lateness =
    judgeLateness(this->behind_s(wakeup), this->latenessP99_s_, this->period_s_, this->device_.info().simulated);
  const TickOutput output = renderTick(this->input_, this->parameters_, this->renderer_);
  this->device_.write(output.command);
  this->tellWorkers(output);
  this->pushes_ = pushes(output.command);
  this->recordTick(output);
  this->fault_ = output.state.fault;
  this->links_.state.write(output.state);
  this->account(wakeup, output, 1e-3 * static_cast<double>(this->clock_.now_ns() - start_ns));
  return true;
}

double ServoLoop::behind_s(const Wakeup& wakeup) const noexcept
{
  return static_cast<double>(wakeup.missed) * this->period_s_ + 1e-9 * static_cast<double>(wakeup.lateness_ns);
}

void ServoLoop::account(const Wakeup& wakeup, const TickOutput& output, double cost_us) noexcept
{
  LoopReport& r = this->report_;
  const HapticState& s = output.state;
  ++r.ticks;
  r.missed += wakeup.missed;
  r.periods = this->period_;
  r.elapsed_s = static_cast<double>(this->period_) * this->period_s_;
  r.contactTicks += s.contacts > 0;
  r.cappedTicks += s.capped || s.overBudget;
  r.pinnedTicks += s.pinned;
  r.peakForce_N = std::max(r.peakForce_N, s.force_D.norm());
  r.peakStabiliser_N = std::max(r.peakStabiliser_N, s.stabiliser_D.norm());
  if (s.gain == 1.0 && s.stiffnessFactor == 1.0 && !s.clamped && !s.riseLimited && !s.held && !s.deviceHolds &&
      !s.tool.held && !s.soft.felt && !s.mechanism.held && this->parameters_.damping_Ns_per_m == 0.0 &&
      this->renderer_.blend_D.isZero(0.0))
  {
    const WorkspaceMap& map = this->parameters_.map;
    const Vec3 spring_D = map.directionToDevice(s.stiffness_N_per_m / map.scale_u_per_m * (s.proxy_W.p - s.device_W.p));
    r.forceResidual_N = std::max(r.forceResidual_N, (s.force_D - s.besideContact_D - s.stabiliser_D - spring_D).norm());
  }
  this->cost_.add(cost_us);
  this->lateness_.add(r.elapsed_s, 1e6 * this->behind_s(wakeup));
  if (r.ticks % ticksPerReport == 0)
  {
    this->publishReport();
  }
}

void ServoLoop::publishReport() noexcept
{
  this->report_.cost = this->cost_.quantiles();
  this->report_.lateness = this->lateness_.quantiles();
  this->latenessP99_s_ = 1e-6 * this->report_.lateness.p99_us;
  this->links_.report.write(this->report_);
}

} // namespace palpate
