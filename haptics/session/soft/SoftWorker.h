// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "haptics/recording/inputs/Bodies.h"
#include "haptics/session/background/BackgroundWorker.h"
#include "haptics/session/soft/SoftChoice.h"
#include "haptics/session/soft/VirtualBody.h"

namespace palpate
{

/// How a soft body is, for a person to see.
struct SoftStatus
{
  std::string problem;   ///< why it cannot be touched, or does not give way any more; "": it can
  bool building = false; ///< it is meant to be touched and is not there yet
  std::uint64_t packets = 0;
  std::shared_ptr<const BodyShape> shape;      ///< how it bends; null: it does not yet
  std::shared_ptr<const CheckedTetras> asMade; ///< what its vertices are, of what came in
};

/// A soft body and the scene beside it.
struct SoftOrder
{
  SoftChoice choice;
  std::shared_ptr<const Scene> beside;

  [[nodiscard]] bool isActive() const noexcept { return this->choice.input != nullptr; }
  /// Another body, at whatever rate.
  [[nodiscard]] bool cancels(const SoftOrder& before) const
  {
    return this->choice.input != before.choice.input || this->choice.name != before.choice.name;
  }
  void announce(const SoftOrder& before, SoftStatus& status) const
  {
    status.building = status.building || (this->isActive() && this->cancels(before));
  }
};

/// Builds a soft body and makes its packets. See BackgroundWorker.
class SoftTask
{
public:
  using Order = SoftOrder;
  using Status = SoftStatus;

  SoftTask(WorkerChannel<Order, Status>& channel, SoftLinks& links) : channel_(channel), links_(links) {}
  bool apply(Order order, const std::stop_token& stop, bool again);
  std::optional<double> iterate();
  void step(double time_s);
  void giveUp();

private:
  bool build(const std::stop_token& stop);
  void publish(std::shared_ptr<const PressedBody> body);
  [[nodiscard]] double period_s() const noexcept { return workerPeriod_s(this->now_.choice.rate_Hz); }

  WorkerChannel<Order, Status>& channel_;
  SoftLinks& links_;
  Order now_;
  std::unique_ptr<BodyMaker> maker_;
  std::optional<VirtualBody> paced_; ///< in virtual time
  std::uint64_t revision_ = 0;       ///< of the last packet
};

/// The soft body of a session, and the thread that computes it beside the servo.
class SoftWorker : public BackgroundWorker<SoftTask>
{
public:
  /// The links must outlive it.
  SoftWorker(SoftLinks& links, bool virtualTime) : BackgroundWorker(virtualTime, links) {}

  void setBody(const SoftChoice& choice) { this->order({ choice, this->wanted().beside }); }
  /// The scene that is touched beside the body.
  void setScene(std::shared_ptr<const Scene> beside) { this->order({ this->wanted().choice, std::move(beside) }); }
};

} // namespace palpate
