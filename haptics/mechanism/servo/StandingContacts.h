// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "haptics/mechanism/servo/FollowingMesh.h"
#include "haptics/mechanism/servo/StandingGuard.h"

namespace palpate
{

/// The mesh in the hand before meshes that stand, in one tick. Contacts that were found hold it; those that were not,
/// or whose planes are of another place, are found here, as its way is proven. They need no answer, hold for one tick,
/// and their friction begins where the tick does. Real-time safe.
class StandingContacts
{
public:
  /// `named`: how many constraints of the joined plan were not found.
  StandingContacts(const MechanismInput& input, int named, MechanismPlan& joined, MechanismState& state,
    SettledConstraints& laws, FollowingMesh& mesh) noexcept;

  /// The places on meshes that stand which the mesh would meet first become contacts, and all constraints are solved
  /// anew, until its way is free. After some such rounds the mesh goes as far as its way is proven.
  void goFree() noexcept;
  /// Where that is; none: the mesh goes to where the constraints bring it.
  [[nodiscard]] const std::optional<Pose>& stopsAt() const noexcept { return this->stopsAt_; }
  [[nodiscard]] double rest_u() const noexcept { return this->guard_.rest_u(); }
  /// In the unit of ContactPlan::workBudget.
  [[nodiscard]] std::uint32_t work() const noexcept;
  /// At the end of the tick.
  void forget() noexcept;

private:
  static constexpr int most = 8;
  /// A constraint of this tick, and the contact that was in its place.
  struct Instead
  {
    int law = 0;
    ConstraintState state;
    FoundContact contact;
  };

  /// The way on which the constraints bring the mesh, as far as it goes in a tick, and `share` of it.
  struct Way
  {
    ScrewStep step;
    double share = 1.0;
  };
  [[nodiscard]] Way wayOfTick() const noexcept;
  void stayNear() noexcept;
  [[nodiscard]] FreeWay look(const ScrewStep& way) noexcept;
  void settle() noexcept;
  void settleSmooth() noexcept;
  [[nodiscard]] bool isOfBoth(const PlannedConstraint& law) const noexcept;
  [[nodiscard]] bool press(const FreeWay& free, const ScrewStep& way) noexcept;
  [[nodiscard]] bool raise(const MetPlace& met, const ScrewStep& way) noexcept;
  [[nodiscard]] bool add(const MetPlace& met, const ScrewStep& way) noexcept;
  [[nodiscard]] int room() noexcept;
  [[nodiscard]] bool isOwn(int law) const noexcept;
  /// The body of a mesh that stands: these are in the plan's order.
  [[nodiscard]] int bodyOf(int mesh) const noexcept;

  const MechanismPlan& plan_;
  int named_;
  MechanismPlan& joined_;
  MechanismState& state_;
  SettledConstraints& laws_;
  FollowingMesh& mesh_;
  StandingGuard guard_;
  double lift_u_;
  double part_ = 1.0; ///< of the motion
  bool freely_;       ///< the mesh goes as far as the constraints bring it, while that can be proven
  bool smooth_ = false;
  std::uint64_t work_ = 0;
  std::array<Instead, most> instead_;
  int count_ = 0;
  std::optional<Pose> stopsAt_;
};

} // namespace palpate
