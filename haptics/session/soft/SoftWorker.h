// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "haptics/session/background/WorkerList.h"
#include "haptics/session/soft/SoftChoice.h"
#include "haptics/session/soft/VirtualBody.h"

namespace palpate
{

struct SoftLinks;
class SoftAside;

/// State of a soft body for the user.
struct SoftStatus : WorkStatus
{
  std::shared_ptr<const BodyShape> shape;      ///< null: no snapshot has been made
  std::shared_ptr<const CheckedTetras> asMade; ///< map from its vertices to the input
};

/// A soft body and the scene beside it.
struct SoftOrder
{
  SoftChoice choice;
  std::shared_ptr<const Scene> beside;

  [[nodiscard]] static SoftOrder of(const SoftChoice& choice, const WorkSurroundings& around)
  {
    return { choice, around.scene };
  }
  friend bool operator==(const SoftOrder&, const SoftOrder&) = default;
  [[nodiscard]] bool isActive() const noexcept { return this->choice.input != nullptr; }
  /// True for another body; another rate alone cancels nothing.
  [[nodiscard]] bool cancels(const SoftOrder& before) const
  {
    return this->choice.input != before.choice.input || this->choice.name != before.choice.name;
  }
  [[nodiscard]] bool awaits(const SoftOrder& before) const { return this->isActive() && this->cancels(before); }
};

/// Builds a soft body and makes its snapshots. See WorkerList.
class SoftTask
{
public:
  using Choice = SoftChoice;
  using Order = SoftOrder;
  using Status = SoftStatus;
  static constexpr bool isHeld = false;
  [[nodiscard]] static SoftLinks& linksOf(auto& all) noexcept { return all.soft; }

  SoftTask(WorkerChannel<Order, Status>& channel, SoftLinks& links);
  ~SoftTask();
  bool apply(Order order, const std::stop_token& stop, bool again);
  std::optional<double> iterate();
  void step(double time_s);
  void giveUp();

private:
  bool build(const std::stop_token& stop);
  void publish(std::shared_ptr<const PressedBody> body);
  void show(BodyShape shape);
  [[nodiscard]] double period_s() const noexcept { return workerPeriod_s(this->now_.choice.rate_Hz); }

  WorkerChannel<Order, Status>& channel_;
  SoftLinks& links_;
  Order now_;
  std::unique_ptr<BodyMaker> maker_;
  std::optional<VirtualBody> paced_; ///< in virtual time
  std::uint64_t revision_ = 0;       ///< of the last snapshot
  std::unique_ptr<SoftAside> aside_; ///< null: no shape was shown; last: destroyed before the members that it uses
};

} // namespace palpate
