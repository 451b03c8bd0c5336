// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mechanism/servo/SettledConstraints.h"
#include "haptics/tool/motion/ScrewStep.h"

namespace palpate
{

/// The mesh in the hand in one tick: how it follows the hand within the reach of the answer that its contacts are of.
/// Real-time safe.
class FollowingMesh
{
public:
  /// `named`: how many constraints of the joined plan were not found.
  FollowingMesh(MechanismInput& input, int named, MechanismState& state, SettledConstraints& laws) noexcept;

  /// Whether there is another answer that reaches the mesh, or reaches as far as the one before does. One that was
  /// looked for before the mesh went further tells nothing of the contacts that it has there: the next one will.
  [[nodiscard]] bool isOther() const noexcept;
  /// Whether contacts or other constraints have had forces since the tick before.
  [[nodiscard]] bool isPressed() const noexcept;
  /// Leads the mesh after the hand, from where it was behind: `touches` so that the force grows gently.
  void follow(bool touches) noexcept;
  /// A hand that leads the mesh to where nothing was looked for leads it as far as that was, until the next answer:
  /// back along the way from the tick before. A mesh that is beyond already, as a new answer reaches less far, goes no
  /// further.
  void slowDown() noexcept;
  /// Contacts turn a mesh no faster than a hand might: one that is held weakly on a corner would turn over at once, and
  /// contacts were found for little of a turn.
  void slowTurn() noexcept;
  /// The share of a way that the mesh goes in this tick: as far as the hand leads the mesh, and a step of the force
  /// that is felt at once. A mesh that was held by something comes free without a leap. At rest in each tick, the mesh
  /// goes no further than past the hand. `freely`: as far as the constraints bring the mesh, where they are met.
  [[nodiscard]] double shareOfTick(const ScrewStep& way, bool freely) const noexcept;
  /// Short of where the constraints bring it, a mesh would take momentum from a loose body that it pushes.
  [[nodiscard]] bool isBesideLoose() const noexcept;
  /// Of a force on the hand, whitened, the part that the hand feels: where the turn was held, its own spring alone.
  [[nodiscard]] Vec6 felt(Vec6 hand_N) const noexcept;
  /// A tick that has no work left to meet its constraints brings the mesh no further into a body that stands: it goes
  /// as far as the contacts that were found let it, and the hand feels the spring to there. The force on the hand,
  /// whitened.
  [[nodiscard]] Vec6 stopBefore(const Pose& before_W) noexcept;
  /// The mesh goes there, short of where the constraints bring it. The force of the hand's springs on it, whitened.
  [[nodiscard]] Vec6 stopAt(const Pose& at_W) noexcept;
  /// Whether the mesh is behind the hand.
  [[nodiscard]] bool isBehind() const noexcept;
  /// Where the hand leads the mesh in this tick, for the next one: a turn that is only slowed leaves it as it was.
  [[nodiscard]] Pose led_W() const noexcept;
  /// Where the hand would lead the mesh.
  [[nodiscard]] const Pose& hand_W() const noexcept { return this->hand_W_; }

private:
  /// That a mesh beside meshes that stand turns in a tick.
  [[nodiscard]] double mostTurn_rad() const noexcept;
  /// Share of an answer's reach that the mesh took in the tick before.
  [[nodiscard]] double takenOf(const FoundContacts& found) const noexcept;
  /// So much less is a mesh behind in this tick that nothing touches. At rest in each tick, it is behind at no time.
  [[nodiscard]] double quickShare() const noexcept;
  /// The same of a mesh that touches: the force grows by no more than a step that is felt at once.
  [[nodiscard]] double gentleShare() const noexcept;
  /// Of how far the mesh is behind, the way on which a stiff contact comes to that force.
  [[nodiscard]] double shareOf(double force_N) const noexcept;
  /// Of the answer's reach, as the constraints have it now.
  [[nodiscard]] double taken() const noexcept;
  /// A mesh that contacts turn further than was looked for, or too fast, is held as it is turned there.
  void holdTurn(const Quat& at_W) noexcept;
  /// Whether there are meshes that stand, which the tick keeps it out of.
  [[nodiscard]] bool isGuarded() const noexcept { return this->input_.meshes != nullptr; }
  /// Whether bodies are at rest in each tick.
  [[nodiscard]] bool isAtRest() const noexcept;
  /// The part of a motion of the mesh after which no contact reaches further into a body that stands than before.
  [[nodiscard]] double shareBefore(const Pose& from_W, const Pose& to_W) const noexcept;

  MechanismInput& input_; ///< with a spring that holds the turn, where the turn is held
  const MechanismPlan& plan_;
  int named_;
  MechanismState& state_;
  SettledConstraints& laws_;
  Pose hand_W_;
  Pose lead_W_;               ///< by the hand's spring, where the turn is held
  double turning_Nu_per_rad_; ///< of that spring
  bool turns_;                ///< by it
  bool turnIsHeld_ = false, turnIsSlowed_ = false;
};

} // namespace palpate
