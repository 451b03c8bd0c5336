// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "haptics/mechanism/check/BodiesOverlap.h"
#include "haptics/session/mechanism/MechanismBodies.h"

namespace palpate
{

/// How a hand holds a mechanism.
struct MechanismHold
{
  double stiffness_N_per_m = 1000.0; ///< of the spring between hand and held body, > 0
  double turning_N_m_per_rad = 0.0;  ///< likewise of turning, >= 0; 0: the held body turns freely
  double scale_u_per_m = 1.0;        ///< of the hand's motion, > 0
  double lowRate_Hz = 30.0; ///< snapshots a second of soft bodies, >= 0; 0: at rest in every tick, the reference
};

/// A mechanism along a path of the hand that is known before, a tick a place, without a device. A person's hand is
/// `scale_u_per_m` times smaller than the scene: forces are those of the hand.
class MechanismTouch
{
public:
  /// Builds the soft bodies, which may take seconds. Null with `refusal` in words: a fault of the mechanism, of a body,
  /// of the hold.
  [[nodiscard]] static std::unique_ptr<MechanismTouch> make(
    const MechanismInputs& inputs, const MechanismHold& hold, std::string& refusal);

  /// The hand is there at that time, which is later than the time before. Wrench on the hand: N, N m.
  [[nodiscard]] MechanismResult next(double time_s, const Pose& hand_W);
  /// A person breaks a constraint.
  void breakConstraint(std::uint32_t law) noexcept { this->tick_.breakConstraint(law); }

  [[nodiscard]] const MechanismCheck& check() const noexcept { return this->check_; }
  [[nodiscard]] const MechanismPlan& plan() const noexcept { return this->plan_; }
  /// Bodies that overlapped at the last place of the hand, though no constraint joined them.
  [[nodiscard]] const std::vector<BodyPair>& overlaps() const noexcept { return this->watch_.seen(); }
  /// Bodies in which a held mesh was at the first place of the hand.
  [[nodiscard]] const std::vector<BodyPair>& begunIn() const noexcept { return this->begunIn_; }
  [[nodiscard]] const MechanismBodies& bodies() const noexcept { return *this->bodies_; }

private:
  MechanismTouch(const Mechanism& mechanism, const MechanismHold& hold, std::unique_ptr<MechanismBodies> bodies);
  void begin(const MechanismInput& input, const Pose& hand_W);
  [[nodiscard]] const FoundContacts* newestFound() const noexcept;
  [[nodiscard]] MechanismResult compute(MechanismInput& input);
  [[nodiscard]] MechanismResult computeAtRest(MechanismInput& input);
  [[nodiscard]] MechanismHand handOf(const MechanismInput& input, const MechanismResult& result) const;

  Mechanism mechanism_;
  MechanismHold hold_;
  MechanismGrip grip_;
  std::unique_ptr<MechanismBodies> bodies_;
  MechanismCheck check_;
  MechanismPlan plan_;
  MechanismTick tick_;
  OverlapWatch watch_;
  std::vector<BodyPair> begunIn_;
  std::uint64_t count_ = 0; ///< of ticks
  double time_s_ = 0.0;
};

/// Of a hand that turns the held body, in life size: a mechanism is judged by it before anybody holds the mechanism.
[[nodiscard]] MechanismHold usualHold(double unit_m) noexcept;

/// "", or that a plan has nothing for a hand to hold.
[[nodiscard]] std::string refuseHeld(const MechanismPlan& plan);

/// The spring of a hold in units of the scene.
[[nodiscard]] MechanismGrip gripOf(const MechanismHold& hold) noexcept;

/// The new state of a constraint, in words.
[[nodiscard]] const char* wordsOf(ConstraintChange change) noexcept;

/// All faults of a check in one line; "": none.
[[nodiscard]] std::string faultsOf(const MechanismCheck& check);

} // namespace palpate
