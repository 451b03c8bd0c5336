// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "haptics/mechanism/check/BodiesOverlap.h"
#include "haptics/mechanism/servo/FeltMechanism.h"
#include "haptics/realtime/SnapshotMailbox.h"
#include "haptics/realtime/TripleBuffer.h"
#include "haptics/session/beside/MadeBeside.h"
#include "haptics/session/beside/PacedThread.h"
#include "haptics/session/mechanism/MechanismBodies.h"

namespace palpate
{

/// A mechanism that is to be felt.
struct MechanismChoice
{
  std::shared_ptr<const MechanismInputs> inputs; ///< null: none
  std::string name;
  double rate_Hz = 30.0; ///< packets of its soft bodies a second, or as many as can be made

  friend bool operator==(const MechanismChoice&, const MechanismChoice&) = default;
};

/// Between the servo and the thread that computes a mechanism's soft bodies.
struct MechanismLinks
{
  SnapshotMailbox<FeltMechanism> felt; ///< worker -> servo
  TripleBuffer<MechanismHand> hand;    ///< servo -> worker
};

/// How a mechanism is, for a person to see.
struct MechanismStatus
{
  std::string problem;            ///< why it cannot be felt, or its bodies do not give way any more; "": it can
  bool building = false;          ///< it is meant to be felt and is not there yet
  MechanismCheck check;           ///< what it becomes
  std::vector<BodyPair> overlaps; ///< bodies that share room where they are felt, though no law between them holds
  std::uint64_t packets = 0;
  std::uint64_t plan = 0;     ///< revision of the one that the servo is given; 0: none
  std::vector<SeenBody> soft; ///< of that, in the order of its inputs
  BodiesAtRest atRest;        ///< likewise
};

/// The mechanism of a session, and the thread that computes its soft bodies beside the servo. It builds them, too: one
/// that was there before with the same bodies goes on with those. Its owner never waits for it, but for its end, and
/// then no longer than a factor takes.
class MechanismWorker
{
public:
  /// The links must outlive it. In virtual time there is no thread: see step().
  MechanismWorker(MechanismLinks& links, bool virtualTime) : links_(links), virtualTime_(virtualTime) {}
  ~MechanismWorker() { this->building_.request_stop(); }

  /// `grip`: how the hand would hold it, for the check.
  void take(const MechanismChoice& choice, const MechanismGrip& grip);
  /// What its thread does, in the caller's, after a tick at that time. Virtual time.
  void step(double time_s);
  [[nodiscard]] MechanismStatus status() const;
  /// What it has made, for a recording.
  [[nodiscard]] MadeBeside<FeltMechanism>& made() noexcept { return this->made_; }

private:
  struct Order
  {
    MechanismChoice choice;
    MechanismGrip grip;
    std::stop_token stop; ///< its bodies are wanted no more
  };
  double run();
  void giveUp();
  void obey();
  void judgeAnew(const Order& order);
  void build(const Order& order);
  void makeBodies(const Order& order, std::string& refusal);
  [[nodiscard]] std::string plan(const Order& order);
  [[nodiscard]] MechanismCheck judge(const Order& order) const;
  void listen();
  void watchOverlaps(const MechanismHand* hand);
  void publish(bool all);

  MechanismLinks& links_;
  bool virtualTime_;

  mutable std::mutex mutex_; ///< between owner and thread; guards the next three
  Order wanted_;
  std::stop_source building_; ///< of the bodies that are wanted
  MechanismStatus status_;
  std::atomic<bool> news_ = false; ///< asked without the lock in each step
  MadeBeside<FeltMechanism> made_;

  // Of the thread alone.
  Order now_;
  bool stopped_ = false;                   ///< before its bodies were built
  std::vector<MechanismSoftInput> madeOf_; ///< the bodies, in use or kept for the next mechanism
  std::unique_ptr<MechanismBodies> bodies_;
  OverlapWatch watch_;
  MechanismPlan plan_;         ///< revision 0: none is felt
  std::uint64_t plans_ = 0;    ///< so many were made
  std::uint64_t revision_ = 0; ///< of the last that was published
  bool published_ = false;     ///< this plan

  PacedThread thread_; ///< last: it ends before what it uses
};

} // namespace palpate
