// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/mechanism/check/MechanismCheck.h"
#include "haptics/mechanism/servo/FeltMechanism.h"
#include "haptics/session/soft/VirtualBody.h"

namespace palpate
{

class ContactFinder;

/// A soft body of a mechanism, by the name that the mechanism calls it by.
struct MechanismSoftInput
{
  std::string name;
  std::shared_ptr<const SoftBodyInput> input;
  double tip_u = 0.0; ///< radius of the constraints' contacts on it; 0: as wide as its patches

  friend bool operator==(const MechanismSoftInput&, const MechanismSoftInput&) = default;
};

/// All that a mechanism is made of.
struct MechanismInputs
{
  Mechanism mechanism;
  std::vector<MechanismSoftInput> soft;
  double unit_m = 1.0; ///< metres a unit of the scene
};

/// The soft bodies of a mechanism at rest, in the order of its inputs.
using BodiesAtRest = std::vector<std::shared_ptr<const PressedBody>>;

/// The soft bodies of a mechanism and their snapshots for the servo. A worker's.
class MechanismBodies
{
public:
  ~MechanismBodies();
  MechanismBodies(const MechanismBodies&) = delete;
  MechanismBodies& operator=(const MechanismBodies&) = delete;

  /// Factors each body, which may take seconds. None of them with `refusal` in words, or soon after a stop is asked
  /// for.
  [[nodiscard]] static std::unique_ptr<MechanismBodies> make(
    const std::vector<MechanismSoftInput>& inputs, std::string& refusal, const std::stop_token& stop = {});

  [[nodiscard]] std::size_t size() const noexcept { return this->makers_.size(); }
  [[nodiscard]] const BodyMaker& maker(std::size_t body) const { return *this->makers_[body]; }
  /// As a check and a plan want to see them: at rest, the first time.
  [[nodiscard]] const std::vector<MechanismSoft>& atRest() const noexcept { return this->atRest_; }
  /// The same, for who judges other constraints.
  [[nodiscard]] const BodiesAtRest& first() const noexcept { return this->first_; }
  /// Where a plan's constraints are on the bodies: snapshots are made around these places from now on, and around those
  /// where meshes meet the bodies.
  void hold(const Mechanism& mechanism, const MechanismPlan& plan);

  /// The forces of the mechanism in a tick, and the place of the held body's tip: of each body the next snapshot
  /// answers there. Those of the plan before count where they are this plan's as well.
  void tell(const MechanismHand& hand);
  /// Whether the forces of a plan are at places of these bodies: of the plan that is held, or of one that it continues.
  [[nodiscard]] bool knows(std::uint64_t plan) const noexcept;
  /// Makes snapshots at that rate, each of which arrives a period after the forces that it was made from [s].
  void pace(double period_s);
  /// The newest of each at that time; virtual time, after pace().
  [[nodiscard]] std::span<const PressedBody* const> at(double time_s);
  /// Each at rest under the forces that were told last, by so many Newton steps.
  [[nodiscard]] std::span<const PressedBody* const> rest(int newtonSteps);

  /// Each once more, for the forces that were told last and a hand that has so long until the next [s]. False if one of
  /// them cannot be made any more: it stays as it was.
  [[nodiscard]] bool press(double period_s);
  /// The newest answer of the finder; `answer` 0: nothing is looked for, or the hand was not told yet.
  [[nodiscard]] const FoundContacts& found() const noexcept { return this->found_; }
  /// Surfaces of the mesh in the hand and of those that stand, that the tick keeps apart; null: there are none.
  [[nodiscard]] const std::shared_ptr<const StandingMeshes>& meshes() const noexcept { return this->meshes_; }
  /// Of each.
  [[nodiscard]] const std::vector<std::shared_ptr<const PressedBody>>& newest() const noexcept { return this->newest_; }
  /// The same by their names.
  [[nodiscard]] std::vector<MechanismSoft> newestNamed() const;
  /// How each is bent, as it was computed last.
  [[nodiscard]] std::vector<SeenBody> seen() const;
  /// Whether any of them is another since this was asked last.
  [[nodiscard]] bool changed();

private:
  MechanismBodies();
  [[nodiscard]] bool pressEach(double period_s, int newtonSteps);
  [[nodiscard]] bool looks() const noexcept;
  [[nodiscard]] std::uint64_t continues(const Mechanism& mechanism, const MechanismPlan& plan) const;
  [[nodiscard]] const FoundContacts& find();
  void findAt(double time_s);
  void tellBodies();
  void makeFinder(const Mechanism& mechanism, const MechanismPlan& plan);
  void gatherMeshes(const Mechanism& mechanism, const MechanismPlan& plan);
  void reachLoose(double heldMotion_u);
  void lookAround(std::size_t body, BodyHand& hand) const;

  std::vector<std::unique_ptr<BodyMaker>> makers_;
  BodiesAtRest first_;
  std::vector<std::shared_ptr<const PressedBody>> newest_;
  std::vector<MechanismSoft> atRest_;
  std::vector<std::shared_ptr<const CheckedTetras>> asMade_;
  std::vector<std::vector<SurfacePoint>> places_; ///< of constraints, of each body
  std::unique_ptr<ContactFinder> finder_;         ///< null: nothing is looked for
  std::shared_ptr<const StandingMeshes> meshes_;
  int held_ = -1;                       ///< body of the plan that is in the hand
  double rod_u_ = 0.0;                  ///< length of the rod in the hand; 0: there is none
  double diagonal_u_ = 0.0;             ///< of the largest soft body
  std::uint64_t plan_ = 0;              ///< revision of the one that is held
  std::uint64_t before_ = 0;            ///< of the one that it continues; 0: of none
  PosesOfBodies begin_W_{};             ///< of its bodies, before anything moves
  FoundContacts found_;                 ///< as the tick has it
  FoundContacts underWay_;              ///< arrives with the next snapshots; in virtual time
  double period_s_ = 0.0, due_s_ = 0.0; ///< likewise
  MechanismHand told_;
  std::optional<PosesOfBodies> looked_W_; ///< where the bodies were, the last time
  /// A loose body, for how far it may go until an answer is in use.
  struct Loose
  {
    int body = 0; ///< in the plan
    double radius_u = 0.0;
    double diagonal_u = 0.0;
    double falls_u_per_s2 = 0.0; ///< under its load
  };
  std::vector<Loose> loose_;
  std::array<double, Mechanism::mostBodies> looseReach_u_{}; ///< of each in the plan's order, of those that are loose
  std::uint64_t askedFound_ = 0;  ///< the newest answer, when it was asked whether the bodies are others
  std::vector<double> stiffness_; ///< E / (1 - nu^2) of each body [N/u^2]
  std::vector<double> tips_u_;    ///< of each body, as its description has it; 0: as its contacts are apart
  std::vector<BodyHand> hands_;
  std::vector<VirtualBody> paced_;
  std::vector<const PressedBody*> given_;
  std::vector<std::shared_ptr<const PressedBody>> asked_; ///< the newest, when it was asked whether they are others
};

} // namespace palpate
