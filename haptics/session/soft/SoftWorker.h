// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "haptics/realtime/SnapshotMailbox.h"
#include "haptics/realtime/TripleBuffer.h"
#include "haptics/session/beside/MadeBeside.h"
#include "haptics/session/beside/PacedThread.h"
#include "haptics/session/soft/VirtualBody.h"

namespace palpate
{

/// A soft body that is to be touched.
struct SoftChoice
{
  std::shared_ptr<const SoftBodyInput> input; ///< null: none
  std::string name;
  double rate_Hz = 30.0; ///< packets a second, or as many as can be made

  friend bool operator==(const SoftChoice&, const SoftChoice&) = default;
};

/// Between the servo and the thread that computes a soft body.
struct SoftLinks
{
  SnapshotMailbox<PressedBody> bodies; ///< worker -> servo
  TripleBuffer<BodyHand> hand;         ///< servo -> worker
};

/// How a soft body is, for a person to see.
struct SoftStatus
{
  std::string problem;   ///< why it cannot be touched, or does not give way any more; "": it can
  bool building = false; ///< it is meant to be touched and is not there yet
  std::uint64_t packets = 0;
  std::shared_ptr<const BodyShape> shape;      ///< how it bends; null: it does not yet
  std::shared_ptr<const CheckedTetras> asMade; ///< what its vertices are, of what came in
};

/// The soft body of a session, and the thread that computes it beside the servo. It builds the body, too. Its owner
/// never waits for it, but for its end, and then no longer than a factor takes.
class SoftWorker
{
public:
  /// The links must outlive it. In virtual time there is no thread: see step().
  SoftWorker(SoftLinks& links, bool virtualTime) : links_(links), virtualTime_(virtualTime) {}
  ~SoftWorker() { this->building_.request_stop(); }

  void take(const SoftChoice& choice);
  /// What is touched beside the body.
  void touch(std::shared_ptr<const Scene> beside);
  /// What its thread does, in the caller's, after a tick at that time. Virtual time.
  void step(double time_s);
  [[nodiscard]] SoftStatus status() const;
  /// What it has made, for a recording.
  [[nodiscard]] MadeBeside<PressedBody>& made() noexcept { return this->made_; }

private:
  struct Order
  {
    SoftChoice choice;
    std::shared_ptr<const Scene> beside;
    std::stop_token stop; ///< the body is wanted no more
  };
  void give(Order order);
  double run();
  void obey();
  void giveUp();
  void build(const Order& order);
  void publish(std::shared_ptr<const PressedBody> body);

  SoftLinks& links_;
  bool virtualTime_;

  mutable std::mutex mutex_; ///< between owner and thread; guards the next three
  Order wanted_;
  std::stop_source building_; ///< of the body that is wanted
  SoftStatus status_;
  std::atomic<bool> news_ = false; ///< asked without the lock in each step
  MadeBeside<PressedBody> made_;

  // Of the thread alone.
  Order now_;
  bool stopped_ = false; ///< before its body was built
  std::unique_ptr<BodyMaker> maker_;
  std::optional<VirtualBody> paced_; ///< in virtual time
  std::uint64_t revision_ = 0;       ///< of the last packet

  PacedThread thread_; ///< last: it ends before what it uses
};

} // namespace palpate
