// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "haptics/compliance/servo/PressedBody.h"
#include "haptics/compliance/snapshot/SnapshotMaker.h"
#include "haptics/geometry/scene/SceneBuilder.h"

namespace palpate
{

struct BodySight;

/// How a soft body was when its last snapshot was made.
struct BodyShape
{
  std::vector<Vec3> displacement_u; ///< of each vertex of the tetrahedra that it was made of
  std::vector<Vec3>
    dent_u; ///< how much further each is to be seen: a place under a force at a point is where it is felt
  std::vector<Mat3> deformation; ///< F of each tetrahedron, no part of that dent
  Vec3 hand_W = Vec3::Zero();    ///< where the hand was that it was made for
  double mostGradient = 0.0;     ///< largest |F - 1|
  Vec3 worst_W = Vec3::Zero();   ///< and the middle, at rest, of where it is
  bool struck = false;           ///< the hand is faster than the body's inertia would let it follow
  double throughItself_u = 0.0;  ///< overlap length of the body with itself below the largest contact force; 0: none
};

/// The message for a body that has passed through itself.
inline constexpr const char* throughItselfText = "the body was pressed through itself, because self-contact is not "
                                                 "modelled: the force there is wrong; press less deep";

/// A soft body as it is to be seen.
struct SeenBody
{
  std::shared_ptr<const CheckedTetras> asMade; ///< map from its vertices to the input
  std::shared_ptr<const BodyShape> shape;      ///< how it bends; null: it does not yet
};

/// A soft body and its scene: makes the snapshots for the servo, one after the other. Used by a worker.
class BodyMaker
{
public:
  /// Factors the body, which may take seconds. Its first snapshot has the revision after `revision`. Null with
  /// `refusal` in words, or soon after a stop is asked for.
  [[nodiscard]] static std::unique_ptr<BodyMaker> make(const SoftBodyInput& input, const std::string& name,
    std::uint64_t revision, std::string& refusal, const std::stop_token& stop = {});

  /// Other surfaces that are touched; null: none. A surface of its name is the body's own, and gives way to it. From
  /// the next snapshot on.
  void touch(std::shared_ptr<const Scene> beside);
  /// The body under the force of the hand, for a hand that has so long until the next snapshot [s]; as many steps to
  /// its rest as are asked for. Null if a factorisation failed: the previous snapshot stays in use.
  [[nodiscard]] std::shared_ptr<const PressedBody> press(
    const BodyHand& hand, double period_s, int newtonSteps = usualSteps);

  /// An inverse to condense around a place, from which this answers as far as it is condensed; null: there is one that
  /// answered the last snapshot or may answer the next, or none is of use to the body's law.
  [[nodiscard]] std::shared_ptr<KeptInverse> keepAround(const Vec3& place_W);
  /// What the last snapshot was made of; it lives as long as this.
  [[nodiscard]] BodySight sight() const;
  [[nodiscard]] BodyShape shape() const;
  /// Whether the body has passed through itself below a contact, in the last snapshot or in any of those after which
  /// lookThrough() was called. Takes as long as a shape.
  [[nodiscard]] bool wentThroughItself() const;
  void lookThrough() { this->wentThroughItself_ = this->wentThroughItself(); }
  [[nodiscard]] const CheckedTetras& checked() const noexcept { return this->checked_; }

  /// One step leaves up to 30 % of the force at 10 Hz, three leave 3 %.
  static constexpr int usualSteps = 3;

private:
  BodyMaker(SoftBodyResult made, const SoftBodyInput& input, std::string name, std::uint64_t revision);
  [[nodiscard]] std::shared_ptr<const Scene> sceneOf(const ComplianceSnapshot& snapshot);
  [[nodiscard]] std::vector<Surface> surfacesWith(const std::vector<Vec3>& free_W, bool standingBeside);

  CheckedTetras checked_;
  std::string name_;
  std::unique_ptr<SoftBody> body_;
  SoftSurface surface_;
  SnapshotMaker snapshots_;
  SceneBuilder builder_;
  std::shared_ptr<const Scene> beside_;
  std::shared_ptr<const Scene> scene_; ///< the last one; null: the other surfaces have changed since
  std::uint64_t first_; ///< the revision before its first snapshot: forces on older ones are at another body's vertices
  std::uint64_t revision_;
  Vec3 hand_W_ = Vec3::Zero();                     ///< of the last snapshot
  std::shared_ptr<const ComplianceSnapshot> last_; ///< null: none yet
  bool underPoints_ = false;                       ///< the last one, and not under a ball
  bool wentThroughItself_ = false;
  std::shared_ptr<KeptInverse> kept_; ///< null: none yet
  Vec3 keptAround_W_ = Vec3::Zero();
  double keptReach_u_ = 0.0;                      ///< distance of its farthest node from there
  std::shared_ptr<const TriangleMesh> heldFaces_; ///< that nothing moves
  std::shared_ptr<const Scene> held_;             ///< of these
};

} // namespace palpate
