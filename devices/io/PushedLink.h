// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "devices/common/LinkNotes.h"
#include "devices/common/LinkedDevice.h"
#include "devices/hid/pid/PidOutput.h"
#include "devices/io/AttachedDevice.h"
#include "devices/io/FindAgain.h"
#include "devices/io/HandExchange.h"
#include "devices/io/LinkCounts.h"
#include "devices/io/WriterWatch.h"
#include "haptics/core/Clock.h"

namespace palpate
{

/// The link between a device with force feedback, a reader, a writer and the servo. The reader and the writer each call
/// their pass repeatedly and may block in it for seconds; the servo exchanges newest values with them and never waits.
/// After a loss the writer opens the device again, but gives no force until the servo has commanded no force once: only
/// the user brings it back.
///
/// `Attached` has all data of a device while it is plugged in: an `entry`, a `connection`, an `engine` and an
/// `output`; begin(bus, options) opens and prepares the device; step(now_ns, wish) sends the most urgent message;
/// disturbance(now_ns) says why the effects no longer play, or is null.
template<class Bus, class Attached>
class PushedLink
{
public:
  using Hand = HandExchange::Hand;
  using Heard = HandExchange::Heard;

  virtual ~PushedLink() = default;
  PushedLink(const PushedLink&) = delete;
  PushedLink& operator=(const PushedLink&) = delete;

  /// Finds, opens and prepares the device; its abilities then are those that it must have whenever it comes back.
  /// Empty, or the reason for the failure. Before there is a writer thread.
  [[nodiscard]] std::string attach()
  {
    std::string problem = this->prepare(this->search_.first(*this->bus_), {});
    this->opened_ = this->abilities().value_or(DeviceAbilities{});
    return problem;
  }
  /// Leaves the device without force and releases it. Writer thread, or after it.
  void detach() noexcept
  {
    if (const std::shared_ptr<Attached> device = this->held_.get())
    {
      device->engine->close();
    }
    this->exchange_.presence.left();
    this->held_.letGo();
  }

  /// Waits for input, keeps the newest hand, watches the writer. False: there is no device. Reader thread.
  bool readPass(int timeout_ms)
  {
    const std::shared_ptr<Attached> device = this->held_.get();
    if (device == nullptr)
    {
      return false;
    }
    std::optional<Hand> newest;
    const std::uint64_t before = this->counts_.inputs;
    const bool there = this->listen(*device, timeout_ms, newest);
    this->counts_.rate.count(this->counts_.inputs - before, this->clock_.now_ns());
    if (newest)
    {
      this->held_.with(device, [&] { this->exchange_.tell(newest); });
    }
    if (!there)
    {
      this->unplugged(device);
    }
    else if (this->writer_.hasStalled(this->clock_.now_ns()))
    {
      this->exchange_.presence.stalled();
      this->stalled(*device);
    }
    return there;
  }

  /// Sends the most urgent message. False: nothing to do now. Writer thread.
  bool writePass()
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

  /// Presence and the newest hand. Servo thread; wait-free.
  [[nodiscard]] Heard heard() noexcept { return this->exchange_.heard(); }
  /// Servo thread; wait-free.
  void command(const DeviceCommand& command) noexcept { this->exchange_.command(command); }

  /// Any thread but the servo's.
  [[nodiscard]] LinkReport report() const
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
      report.message = "the device has not reported a position yet: move the handle";
    }
    return report;
  }
  /// Sets the trust in forces that the device renders itself. Any thread.
  void trust(HeldTrust trust) noexcept { this->exchange_.trust(trust); }
  /// The abilities that the device offers; none before it was attached. Any thread but the servo's.
  [[nodiscard]] std::optional<DeviceAbilities> abilities() const
  {
    const std::lock_guard lock(this->abilitiesMutex_);
    return this->abilities_;
  }

protected:
  PushedLink(std::shared_ptr<Bus> bus, HidEntry entry, const PidOutputOptions& options, const Clock& clock)
    : bus_(std::move(bus)), search_(std::move(entry)), options_(options), clock_(clock), exchange_(options.trust)
  {
  }

  /// Position of the hand when a device has just been opened; none: the device does not report it.
  [[nodiscard]] virtual std::optional<Hand> firstHand(Attached& device) = 0;
  /// Waits for input and takes all of it. False: the device is gone. Reader thread.
  [[nodiscard]] virtual bool listen(Attached& device, int timeout_ms, std::optional<Hand>& newest) = 0;
  /// Handles the loss of a device that is gone. Reader thread.
  virtual void unplugged(const std::shared_ptr<Attached>& device) = 0;
  /// Loses a device whose effects do not play or that accepted no force, and ends its effects. Writer thread, since
  /// `since_ns` in this pass.
  virtual void giveUp(const std::shared_ptr<Attached>& device, std::int64_t since_ns, const std::string& why) = 0;
  /// Called when the writer has just been found to hang. Reader thread.
  virtual void stalled(Attached& /*device*/) {}
  /// True: a lost device may be opened again now.
  [[nodiscard]] virtual bool mayReattach() const noexcept { return true; }

  /// Marks the device as lost. False: another thread has noticed the loss already.
  [[nodiscard]] bool lose(const std::shared_ptr<Attached>& device, const std::string& why)
  {
    return this->held_.letGo(device, why, [this] { this->exchange_.presence.lost(); });
  }
  [[nodiscard]] Hand handOf(const PidHand& hand) noexcept
  {
    this->counts_.outOfRange += hand.outOfRange ? 1 : 0;
    const PidScale& scale = this->options_.scale;
    Hand here;
    here.p_D = { scale.toMetres(0, hand.at[0]), scale.toMetres(1, hand.at[1]), 0.0 };
    here.buttons = hand.buttons;
    return here;
  }
  [[nodiscard]] const Clock& clock() const noexcept { return this->clock_; }

  LinkCounts counts_;

private:
  /// The ability for walls that the device had before and lacks now; empty: none. The host goes on as if the device
  /// rendered its walls, and walls without their viscosity shake.
  [[nodiscard]] static std::string missing(const DeviceAbilities& before, const DeviceAbilities& now)
  {
    return !before.offersWalls() || now.offersWalls() ? "" : now.holdsWalls ? "viscosity" : "walls";
  }

  [[nodiscard]] std::string prepare(FoundDevice found, const DeviceAbilities& least)
  {
    if (!found.entry)
    {
      return found.problem;
    }
    auto device = std::make_shared<Attached>();
    device->entry = std::move(*found.entry);
    std::string problem = device->begin(*this->bus_, this->options_);
    if (const std::string lack = problem.empty() ? missing(least, device->output->abilities()) : ""; !lack.empty())
    {
      device->engine->close();
      problem = "the device came back without " + lack + ": the effect memory of the device may be full";
    }
    if (!problem.empty())
    {
      return "\"" + device->entry.name + "\": " + problem;
    }
    this->search_.found(*this->bus_, device->entry);
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

  [[nodiscard]] bool writeTo(const std::shared_ptr<Attached>& device, std::int64_t now_ns)
  {
    if (const char* const why = device->disturbance(now_ns))
    {
      this->giveUp(device, now_ns, why);
      return true;
    }
    const std::uint64_t restarts = device->output->restarts();
    const PidStep step = device->step(now_ns, this->exchange_.wish());
    if (step == PidStep::Failed)
    {
      this->giveUp(device, now_ns, describeFailedWrite(device->connection->error()));
    }
    this->counts_.outputs += step == PidStep::Sent ? 1 : 0;
    this->counts_.restarts += device->output->restarts() - restarts;
    return step == PidStep::Sent;
  }

  /// The devices present are noted before any waiting: the lost device may soon be back at another
  /// path.
  void reattach(std::int64_t now_ns)
  {
    this->search_.lost(*this->bus_);
    if (!this->mayReattach() || !this->pause_.over(now_ns))
    {
      return;
    }
    this->exchange_.mute();
    if (std::string problem = this->prepare(this->search_.again(*this->bus_), this->opened_); !problem.empty())
    {
      this->held_.say(std::move(problem));
    }
  }

  std::shared_ptr<Bus> bus_;
  DeviceSearch search_; ///< writer's, and the owner's before
  PidOutputOptions options_;
  const Clock& clock_;

  AttachedDevice<Attached> held_;     ///< reader, writer and owner only
  mutable std::mutex abilitiesMutex_; ///< writer and owner only
  std::optional<DeviceAbilities> abilities_;

  HandExchange exchange_;
  WriterWatch writer_;

  DeviceAbilities opened_; ///< writer's, and the owner's before: abilities when the device was opened
  SearchPause pause_;      ///< writer's
};

} // namespace palpate
