// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/mechanism/check/BodiesOverlap.h"
#include "haptics/session/background/WorkerList.h"
#include "haptics/session/mechanism/MechanismBodies.h"
#include "haptics/session/mechanism/MechanismChoice.h"

namespace palpate
{

struct MechanismLinks;

/// How a mechanism is, for a person to see.
struct MechanismStatus : WorkStatus
{
  MechanismCheck check;           ///< plan and faults
  std::vector<BodyPair> overlaps; ///< bodies that overlap where they are felt, though no constraint joins them
  std::uint64_t plan = 0;         ///< revision of the one that the servo is given; 0: none
  std::vector<SeenBody> soft;     ///< of that, in the order of its inputs
  BodiesAtRest atRest;            ///< likewise
  std::vector<Vec3> wire_W;       ///< nodes of a wire as the tick had them last; of another mechanism none
};

/// A mechanism, and how the hand would hold it.
struct MechanismOrder
{
  MechanismChoice choice;
  MechanismGrip grip;

  [[nodiscard]] static MechanismOrder of(const MechanismChoice& choice, const WorkSurroundings& around)
  {
    return { choice, around.grip };
  }
  friend bool operator==(const MechanismOrder&, const MechanismOrder&) = default;
  [[nodiscard]] bool isActive() const noexcept { return this->choice.inputs != nullptr; }
  /// At whatever rate.
  [[nodiscard]] bool isSame(const MechanismOrder& before) const
  {
    return this->choice.inputs == before.choice.inputs && this->choice.name == before.choice.name;
  }
  /// Its soft bodies are others.
  [[nodiscard]] bool cancels(const MechanismOrder& before) const { return this->soft() != before.soft(); }
  [[nodiscard]] bool awaits(const MechanismOrder& before) const { return this->isActive() && !this->isSame(before); }
  [[nodiscard]] std::vector<MechanismSoftInput> soft() const
  {
    return this->isActive() ? this->choice.inputs->soft : std::vector<MechanismSoftInput>();
  }
};

/// Plans a mechanism, builds its soft bodies and makes their snapshots. A mechanism with the bodies of the one before
/// goes on with those. See WorkerList.
class MechanismTask
{
public:
  using Choice = MechanismChoice;
  using Order = MechanismOrder;
  using Status = MechanismStatus;
  static constexpr bool isHeld = true;
  [[nodiscard]] static MechanismLinks& linksOf(auto& all) noexcept { return all.mechanism; }

  MechanismTask(WorkerChannel<Order, Status>& channel, MechanismLinks& links) : channel_(channel), links_(links) {}
  bool apply(Order order, const std::stop_token& stop, bool again);
  std::optional<double> iterate();
  void step(double time_s);
  void giveUp();

private:
  bool judgeAnew(const std::stop_token& stop);
  bool build(const std::stop_token& stop);
  void makeBodies(std::string& refusal, const std::stop_token& stop);
  [[nodiscard]] std::string plan();
  [[nodiscard]] MechanismCheck judge() const;
  void readHand();
  void watchOverlaps(const MechanismHand* hand);
  void watchWire(bool ofThese);
  void publish(bool all);
  [[nodiscard]] double period_s() const noexcept { return workerPeriod_s(this->now_.choice.rate_Hz); }

  WorkerChannel<Order, Status>& channel_;
  MechanismLinks& links_;
  Order now_;
  std::vector<MechanismSoftInput> madeOf_; ///< the bodies, in use or kept for the next mechanism
  std::unique_ptr<MechanismBodies> bodies_;
  OverlapWatch watch_;
  MechanismPlan plan_;         ///< revision 0: none is felt
  std::uint64_t plans_ = 0;    ///< so many were made
  std::uint64_t revision_ = 0; ///< of the last that was published
  bool published_ = false;     ///< this plan
};

} // namespace palpate
