// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "haptics/mechanism/servo/MechanismTick.h"
#include "haptics/mechanism/sided/StandingMeshes.h"

namespace palpate
{

/// A mechanism as its worker had it at one moment. Immutable; the servo reads it.
class FeltMechanism
{
public:
  /// `revision`: above 0, another one for each. `bodies`: in the plan's order, none of them null. `meshes`: see
  /// MechanismInput.
  FeltMechanism(std::uint64_t revision, const MechanismPlan& plan,
    std::vector<std::shared_ptr<const PressedBody>> bodies, const FoundContacts& found = {},
    std::shared_ptr<const StandingMeshes> meshes = nullptr)
    : revision_(revision), plan_(plan), bodies_(std::move(bodies)), found_(found), meshes_(std::move(meshes))
  {
    for (const auto& body : this->bodies_)
    {
      this->given_.push_back(body.get());
    }
  }

  [[nodiscard]] std::uint64_t revision() const noexcept { return this->revision_; }
  [[nodiscard]] const MechanismPlan& plan() const noexcept { return this->plan_; }
  [[nodiscard]] const std::vector<std::shared_ptr<const PressedBody>>& bodies() const noexcept { return this->bodies_; }
  /// The newest answer of the finder; null: nothing is looked for, or nothing has been yet.
  [[nodiscard]] const FoundContacts* found() const noexcept
  {
    return this->found_.answer != 0 ? &this->found_ : nullptr;
  }
  [[nodiscard]] const std::shared_ptr<const StandingMeshes>& meshes() const noexcept { return this->meshes_; }
  /// The bodies, as a tick is given them.
  [[nodiscard]] std::span<const PressedBody* const> soft() const noexcept { return this->given_; }

private:
  std::uint64_t revision_;
  MechanismPlan plan_;
  std::vector<std::shared_ptr<const PressedBody>> bodies_;
  std::vector<const PressedBody*> given_;
  FoundContacts found_;
  std::shared_ptr<const StandingMeshes> meshes_;
};

/// The servo's message to the worker of a mechanism: poses of the bodies and forces of the constraints.
struct MechanismHand
{
  std::uint64_t tick = 0;
  std::uint64_t plan = 0;     ///< revision of the plan that the presses are of; 0: of none
  Vec3 hand_W = Vec3::Zero(); ///< of the device [u]
  Vec3 tip_W = Vec3::Zero();
  int pressCount = 0;
  decltype(MechanismResult::presses) presses{};
  decltype(MechanismResult::pose_W) pose_W{};                       ///< of held and rigid bodies
  std::array<ConstraintPhase, Mechanism::mostConstraints> phases{}; ///< of the constraints

  /// Of the bodies and the constraint's forces that a tick came to.
  void press(const MechanismResult& result) noexcept
  {
    this->pose_W = result.pose_W;
    std::ranges::transform(result.laws, this->phases.begin(), [](const ConstraintNow& law) { return law.phase; });
    this->pressCount = result.pressCount;
    std::copy_n(result.presses.begin(), result.pressCount, this->presses.begin());
  }
  [[nodiscard]] std::span<const MechanismPress> pressing() const noexcept
  {
    return { this->presses.data(), static_cast<std::size_t>(this->pressCount) };
  }
};

} // namespace palpate
