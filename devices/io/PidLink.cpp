// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/PidLink.h"
#include "devices/common/LinkNotes.h"

#include <utility>

namespace palpate
{
namespace
{

constexpr int firstReads = 10, firstRead_ms = 10; ///< a device that has something to say says it in that time

constexpr const char* effectsTaken =
  "another program took its effects: close that program, or take the device's evdev node away (see plugin/README.md)";

/// For walls that are left to the device, which it could hold before; empty: nothing.
const char* missing(const DeviceAbilities& before, const DeviceAbilities& now) noexcept
{
  if (!before.offersWalls() || now.offersWalls())
  {
    return "";
  }
  return now.holdsWalls ? "viscosity" : "walls";
}

} // namespace

PidLink::PidLink(std::shared_ptr<HidBus> bus, HidEntry entry, const PidOutputOptions& options, const Clock& clock)
  : bus_(std::move(bus)), search_(std::move(entry)), options_(options), clock_(clock), exchange_(options.trust)
{
}

std::string PidLink::attach()
{
  std::string problem = this->prepare(this->search_.first(*this->bus_), {});
  this->opened_ = this->abilities().value_or(DeviceAbilities{});
  return problem;
}

/// Whoever steers by what the device held goes on as if it held it: walls without their viscosity shake.
std::string PidLink::prepare(FoundDevice found, const DeviceAbilities& least)
{
  if (!found.entry)
  {
    return found.problem;
  }
  auto device = std::make_shared<Attached>();
  device->entry = std::move(*found.entry);
  if (std::string problem = device->begin(*this->bus_, this->options_); !problem.empty())
  {
    return "\"" + device->entry.name + "\": " + problem;
  }
  if (const std::string lack = missing(least, device->output->abilities()); !lack.empty())
  {
    device->engine->close();
    return "\"" + device->entry.name + "\": it came back without " + lack + ": its memory for effects may be full";
  }
  this->search_.found(*this->bus_, device->entry);
  device->drain();
  const std::optional<Hand> hand = this->firstHand(*device);
  {
    const std::lock_guard lock(this->abilitiesMutex_);
    this->abilities_ = device->output->abilities();
  }
  const auto sayFound = [this, &hand]
  {
    this->exchange_.tell(hand);
    this->exchange_.presence.found();
  };
  this->held_.hold(std::move(device), sayFound);
  return {};
}

/// A device that stands still may say nothing, and a place from before the loss says nothing about now.
std::optional<PidLink::Hand> PidLink::firstHand(Attached& device)
{
  std::optional<Hand> hand;
  for (int i = 0; i < firstReads && !hand; ++i)
  {
    static_cast<void>(takeReports(*device.connection, firstRead_ms,
      [&](std::span<const std::uint8_t> report) { this->take(device, report, hand); }));
  }
  return hand;
}

std::string PidLink::Attached::begin(HidBus& bus, const PidOutputOptions& options)
{
  const HidBus::Descriptor read = bus.descriptor(this->entry);
  if (!read.problem.empty())
  {
    return "its report descriptor cannot be read: " + read.problem;
  }
  this->descriptor = parseReportDescriptor(read.bytes);
  std::string problem = PidEngine::refusal(this->descriptor);
  if (!problem.empty())
  {
    return problem;
  }
  const PidKind kind = pidKind(this->descriptor);
  this->input.emplace(this->descriptor, kind.sensedAxes);
  HidBus::Opened opened = bus.open(this->entry);
  if (opened.connection == nullptr)
  {
    return opened.problem;
  }
  this->connection = std::move(opened.connection);
  this->spare = bus.open(this->entry).connection;
  this->engine.emplace(*this->connection, this->descriptor);
  this->output.emplace(*this->engine, options, kind);
  problem = this->engine->open();
  problem = problem.empty() ? this->output->begin() : problem;
  this->watch.emplace(*this->engine).begin();
  return problem;
}

void PidLink::Attached::drain() const noexcept
{
  static_cast<void>(takeReports(*this->connection, 0, [](std::span<const std::uint8_t>) {}));
}

void PidLink::detach() noexcept
{
  const std::shared_ptr<Attached> device = this->held_.get();
  if (device != nullptr)
  {
    device->engine->close();
  }
  this->exchange_.presence.left();
  this->held_.letGo();
}

/// False: another thread has noticed the loss already.
bool PidLink::lose(const std::shared_ptr<Attached>& device, const std::string& why)
{
  return this->held_.letGo(device, why, [this] { this->exchange_.presence.lost(); });
}

/// Nothing where another thread is sending that order already.
void PidLink::Attached::stopPastTheWriter() noexcept
{
  const std::unique_lock alone(this->spareMutex, std::try_to_lock);
  if (alone && this->spare != nullptr)
  {
    static_cast<void>(PidEngine(*this->spare, this->descriptor).control(pid::stopAll));
  }
}

bool PidLink::readPass(int timeout_ms)
{
  const std::shared_ptr<Attached> device = this->held_.get();
  if (device == nullptr)
  {
    return false;
  }
  std::optional<Hand> newest;
  const std::uint64_t before = this->counts_.inputs;
  const int length = takeReports(*device->connection, timeout_ms,
    [&](std::span<const std::uint8_t> report) { this->take(*device, report, newest); });
  this->counts_.rate.count(this->counts_.inputs - before, this->clock_.now_ns());
  if (newest)
  {
    this->held_.with(device, [&] { this->exchange_.tell(newest); });
  }
  if (length < 0)
  {
    this->loseAndStop(device);
    return false;
  }
  this->watchWriter(*device);
  return true;
}

/// The servo knows of the loss before the order to stop is sent, for sending may hang. The device may still be there
/// and push. A device that the writer has lost has had its order, and what is there now may be another device.
void PidLink::loseAndStop(const std::shared_ptr<Attached>& device)
{
  this->stopping_ = true;
  if (this->lose(device, "it was unplugged"))
  {
    device->stopPastTheWriter();
  }
  this->stopping_ = false;
}

void PidLink::take(Attached& device, std::span<const std::uint8_t> report, std::optional<Hand>& newest)
{
  if (const std::optional<PidHand> hand = device.input->hand(report))
  {
    const PidScale& scale = this->options_.scale;
    newest =
      Hand{ { scale.toMetres(0, hand->at[0]), scale.toMetres(1, hand->at[1]), 0.0 }, hand->buttons, device.gripped };
    device.last = newest;
    ++this->counts_.inputs;
    this->counts_.outOfRange += hand->outOfRange ? 1 : 0;
    return;
  }
  const std::optional<PidState> state = device.engine->state(report);
  if (!state)
  {
    ++this->counts_.strange;
    return;
  }
  this->takeState(device, *state, newest);
}

/// Some firmwares never say that their switch is on: only a switch that was on can have been switched off.
void PidLink::takeState(Attached& device, const PidState& state, std::optional<Hand>& newest)
{
  if (!state.actuatorsEnabled)
  {
    device.actuatorsOff = true;
  }
  if (!state.playing && state.block > 0)
  {
    device.stoppedBlock = state.block;
  }
  device.switchSeen = device.switchSeen || state.overrideOn;
  device.withoutForce = !state.power                             ? "its motors have no power: check its power supply"
                        : state.paused                           ? "it is paused"
                        : device.switchSeen && !state.overrideOn ? "its forces are switched off by a switch on it"
                                                                 : nullptr;
  device.gripped = state.safetyClosed;
  if (device.last)
  {
    device.last->grip = device.gripped;
    newest = device.last;
  }
}

/// A write that hangs cannot be called back, and until the write ends nobody can open the device. So the order to stop
/// goes by a connection that was opened before. The order lies behind the write in the system's queue, and comes first
/// when the device takes anything again. Sending may hang as long: the reader has nothing else to do for a lost device.
void PidLink::watchWriter(Attached& device)
{
  if (this->writer_.hasStalled(this->clock_.now_ns()))
  {
    this->exchange_.presence.stalled();
    device.stalled = true; // before the device can say that it has stopped
    device.stopPastTheWriter();
  }
}

bool PidLink::writePass()
{
  const std::int64_t now_ns = this->clock_.now_ns();
  const std::shared_ptr<Attached> device = this->held_.get();
  if (device == nullptr)
  {
    this->reattach(now_ns);
    return false;
  }
  this->writer_.begins(now_ns);
  const bool sent = this->writeTo(device, now_ns);
  this->writer_.ends();
  return sent;
}

bool PidLink::writeTo(const std::shared_ptr<Attached>& device, std::int64_t now_ns)
{
  if (const char* const why = device->disturbance(now_ns))
  {
    this->loseAndStop(device, now_ns, why);
    return true;
  }
  const std::uint64_t restarts = device->output->restarts();
  const PidOutput::Step step = device->output->step(now_ns, this->exchange_.wish());
  if (step == PidOutput::Step::Failed)
  {
    this->loseAndStop(device, now_ns, describeFailedWrite(device->connection->error()));
  }
  this->counts_.outputs += step == PidOutput::Step::Sent ? 1 : 0;
  this->counts_.restarts += device->output->restarts() - restarts;
  return step == PidOutput::Step::Sent;
}

/// What the device was told last would go on until it ends by itself. A device that took nothing for long would only
/// hang again, and has had its order past the writer. The servo knows before the order is sent, for sending may hang.
void PidLink::loseAndStop(const std::shared_ptr<Attached>& device, std::int64_t since_ns, const std::string& why)
{
  const bool answers = this->clock_.now_ns() - since_ns <= WriterWatch::stuckAfter_ns;
  static_cast<void>(this->lose(device, why));
  if (answers && !device->engine->control(pid::stopAll))
  {
    device->stopPastTheWriter();
  }
}

/// Why the device's effects do not play any more; null: they do. A device that was told to stop past the writer may not
/// say so, and that order also switches the actuators of some devices off.
const char* PidLink::Attached::disturbance(std::int64_t now_ns) noexcept
{
  if (this->stalled)
  {
    return "it did not take forces in time and was told to stop";
  }
  const bool off = this->actuatorsOff.exchange(false) && this->output->shouldBeOn(now_ns);
  const bool stopped = this->output->plays(this->stoppedBlock.exchange(0));
  if (off || stopped)
  {
    return "another program or a switch on it took its forces away";
  }
  return this->watch->undisturbed(now_ns) ? nullptr : effectsTaken;
}

/// The devices that are there are noted before anything is waited for: the lost one may soon be back in another place.
void PidLink::reattach(std::int64_t now_ns)
{
  this->search_.lost(*this->bus_);
  if (this->stopping_ || !this->pause_.over(now_ns))
  {
    return;
  }
  this->exchange_.mute();
  if (std::string problem = this->prepare(this->search_.again(*this->bus_), this->opened_); !problem.empty())
  {
    this->held_.say(std::move(problem));
  }
}

LinkReport PidLink::report() const
{
  LinkReport report;
  this->counts_.reportTo(report);
  report.stalls = this->writer_.stalls();
  report.losses = this->exchange_.presence.losses();
  this->held_.reportTo(report);
  const std::shared_ptr<Attached> device = this->held_.get();
  if (const char* const why = device != nullptr ? device->withoutForce.load() : nullptr)
  {
    report.message = why;
  }
  if (report.attached && !this->exchange_.handKnown())
  {
    report.message = "it has not said yet where the hand is: move it";
  }
  return report;
}

std::optional<DeviceAbilities> PidLink::abilities() const
{
  const std::lock_guard lock(this->abilitiesMutex_);
  return this->abilities_;
}

} // namespace palpate
