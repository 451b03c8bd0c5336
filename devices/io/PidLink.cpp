// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/PidLink.h"

#include <utility>

namespace palpate
{
namespace
{

constexpr int firstReads = 10, firstRead_ms = 10; ///< a device that reports at all does so in that time

constexpr const char* effectsTaken = "another program took the effects of the device: close that program, or remove "
                                     "access to the device's evdev node (see plugin/README.md)";

} // namespace

std::string AttachedPid::begin(HidBus& bus, const PidOutputOptions& options)
{
  const HidBus::Descriptor read = bus.descriptor(this->entry);
  if (!read.problem.empty())
  {
    return "the report descriptor of the device cannot be read: " + read.problem;
  }
  this->descriptor = parseReportDescriptor(read.value);
  std::string problem = PidEngine::refusal(this->descriptor);
  if (!problem.empty())
  {
    return problem;
  }
  const PidKind kind = pidKind(this->descriptor);
  this->input.emplace(this->descriptor, kind.sensedAxes);
  HidBus::Opened opened = bus.open(this->entry);
  if (opened.value == nullptr)
  {
    return opened.problem;
  }
  this->connection = std::move(opened.value);
  this->spare = bus.open(this->entry).value;
  this->engine.emplace(*this->connection, this->descriptor);
  this->output.emplace(*this->engine, options, kind);
  problem = this->engine->open();
  problem = problem.empty() ? this->output->begin() : problem;
  this->watch.emplace(*this->engine).begin();
  return problem;
}

void AttachedPid::drain() const noexcept
{
  static_cast<void>(takeReports(*this->connection, 0, [](std::span<const std::uint8_t>) {}));
}

/// Does nothing while another thread sends that order.
void AttachedPid::stopPastTheWriter() noexcept
{
  const std::unique_lock alone(this->spareMutex, std::try_to_lock);
  if (alone && this->spare != nullptr)
  {
    static_cast<void>(PidEngine(*this->spare, this->descriptor).control(pid::stopAll));
  }
}

/// Why the device's effects no longer play; null: they do. A device that was stopped past the writer may not report
/// that it stopped, and that order also disables the actuators of some devices.
const char* AttachedPid::disturbance(std::int64_t now_ns) noexcept
{
  if (this->stalled)
  {
    return "the device accepted forces too late and was stopped";
  }
  const bool off = this->actuatorsOff.exchange(false) && this->output->shouldBeOn(now_ns);
  const bool stopped = this->output->shouldPlay(this->stoppedBlock.exchange(0), now_ns);
  if (off || stopped)
  {
    return "another program, or a switch on the device, disabled its forces";
  }
  return this->watch->undisturbed(now_ns) ? nullptr : effectsTaken;
}

/// A device at rest may report nothing, and a position from before the loss is no longer valid.
std::optional<PidLink::Hand> PidLink::firstHand(AttachedPid& device)
{
  device.drain();
  std::optional<Hand> hand;
  for (int i = 0; i < firstReads && !hand; ++i)
  {
    static_cast<void>(takeReports(*device.connection, firstRead_ms,
      [&](std::span<const std::uint8_t> report) { this->take(device, report, hand); }));
  }
  return hand;
}

bool PidLink::listen(AttachedPid& device, int timeout_ms, std::optional<Hand>& newest)
{
  const auto takeOne = [&](std::span<const std::uint8_t> report) { this->take(device, report, newest); };
  return takeReports(*device.connection, timeout_ms, takeOne) >= 0;
}

/// The servo learns of the loss before the order to stop is sent, for sending may hang. The device may still be present
/// and push. A device that the writer has lost was sent the order, and the present device may be another one.
void PidLink::unplugged(const std::shared_ptr<AttachedPid>& device)
{
  this->stopping_ = true;
  if (this->lose(device, "the cable was unplugged"))
  {
    device->stopPastTheWriter();
  }
  this->stopping_ = false;
}

void PidLink::take(AttachedPid& device, std::span<const std::uint8_t> report, std::optional<Hand>& newest)
{
  if (const std::optional<PidHand> hand = device.input->hand(report))
  {
    newest = this->handOf(*hand);
    newest->grip = device.gripped;
    device.last = newest;
    ++this->counts_.inputs;
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

/// Some firmwares never report that their switch is on: only a switch that was on can have been switched off.
void PidLink::takeState(AttachedPid& device, const PidState& state, std::optional<Hand>& newest)
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
  device.withoutForce = !state.power                             ? "the motors have no power: check the power supply"
                        : state.paused                           ? "the device is paused"
                        : device.switchSeen && !state.overrideOn ? "a switch on the device disables its forces"
                                                                 : nullptr;
  device.gripped = state.safetyClosed;
  if (device.last)
  {
    device.last->grip = device.gripped;
    newest = device.last;
  }
}

/// A write that hangs cannot be cancelled, and until the write ends the device cannot be opened. So the order to stop
/// goes by a connection that was opened before. The order lies behind the write in the system's queue, and comes first
/// when the device accepts data again. Sending may hang as long: the reader has no other work for a lost device.
void PidLink::stalled(AttachedPid& device)
{
  device.stalled = true; // before the device can report that it has stopped
  device.stopPastTheWriter();
}

/// The last effects would play until they expire. A device that accepted nothing for long would only hang again, and
/// was sent its order past the writer. The servo learns of the loss before the order is sent, for sending may hang.
void PidLink::giveUp(const std::shared_ptr<AttachedPid>& device, std::int64_t since_ns, const std::string& why)
{
  const bool answers = this->clock().now_ns() - since_ns <= WriterWatch::stuckAfter_ns;
  static_cast<void>(this->lose(device, why));
  if (answers && !device->engine->control(pid::stopAll))
  {
    device->stopPastTheWriter();
  }
}

} // namespace palpate
