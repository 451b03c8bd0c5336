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

/// The shape of a soft body when its last snapshot was made.
struct BodyShape
{
  std::vector<Vec3> displacement_u; ///< of each vertex of the tetrahedra as they were given
  std::vector<Vec3>
    dent_u; ///< further displacement of each vertex in a view: a point under a force is drawn where it is felt
  std::vector<Mat3> deformation; ///< deformation gradient F of each tetrahedron, without that dent
  Vec3 hand_W = Vec3::Zero();    ///< hand position for which the snapshot was made
  double mostGradient = 0.0;     ///< largest |F - 1|
  Vec3 worst_W = Vec3::Zero();   ///< rest position of the node at which it occurs
  bool struck = false;           ///< the hand is faster than the body's inertia would let it follow
  double throughItself_u = 0.0;  ///< overlap length of the body with itself below the largest contact force; 0: none
};

/// The message for a body that has passed through itself.
inline constexpr const char* throughItselfText = "the body was pressed through itself, because self-contact is not "
                                                 "modelled: the force there is wrong; press less deep";

/// A soft body for a view.
struct SeenBody
{
  std::shared_ptr<const CheckedTetras> asMade; ///< map from its vertices to the input
  std::shared_ptr<const BodyShape> shape;      ///< null: no snapshot has been made
};

/// A soft body and its scene: makes the snapshots for the servo, one after the other. Used by a worker.
class BodyMaker
{
public:
  /// Factors the body, which may take seconds. Its first snapshot has the revision after `revision`. Null with
  /// `refusal` in words, or soon after a stop is asked for.
  [[nodiscard]] static std::unique_ptr<BodyMaker> make(const SoftBodyInput& input, const std::string& name,
    std::uint64_t revision, std::string& refusal, const std::stop_token& stop = {});

  /// Sets the other surfaces to touch; null: none. A surface of the body's name is left out for the body's own. Takes
  /// effect at the next snapshot.
  void touch(std::shared_ptr<const Scene> beside);
  /// The body under the forces of the hand, with at most `newtonSteps` steps towards its equilibrium. `period_s`: time
  /// until the next snapshot. Null if a factorisation failed: the previous snapshot stays in use.
  [[nodiscard]] std::shared_ptr<const PressedBody> press(
    const BodyHand& hand, double period_s, int newtonSteps = usualSteps);

  /// Snapshots have the compliance of these places as well, from the next one on.
  void watch(std::vector<SurfacePoint> places) { this->watched_ = std::move(places); }
  /// From the next one on, forces on the vertices of these parts act on the parts.
  void pressParts(std::vector<PressedPart> parts) { this->parts_ = std::move(parts); }

  /// A new inverse of the stiffness to condense around a point; snapshots use as much of it as is condensed. Null: the
  /// present one answered the last snapshot or may answer the next, or the stiffness changes with the deformation.
  [[nodiscard]] std::shared_ptr<KeptInverse> keepAround(const Vec3& place_W);
  /// Data of the last snapshot, from which the shape is computed; valid as long as this maker.
  [[nodiscard]] BodySight sight() const;
  [[nodiscard]] BodyShape shape() const;
  /// True if the body passed through itself below a contact, in the last snapshot or in any of those after which
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
  std::shared_ptr<const Scene> scene_; ///< of the last snapshot; null: the other surfaces have changed since
  std::uint64_t first_; ///< revision before the first snapshot: older forces belong to another body's vertices
  std::uint64_t revision_;
  std::vector<SurfacePoint> watched_;
  std::vector<PressedPart> parts_;
  Vec3 hand_W_ = Vec3::Zero();                     ///< of the last snapshot
  std::shared_ptr<const ComplianceSnapshot> last_; ///< null: none yet
  bool underPoints_ = false;                       ///< whether the last snapshot was for a point in place of a ball
  bool wentThroughItself_ = false;
  std::shared_ptr<KeptInverse> kept_; ///< null: none yet
  Vec3 keptAround_W_ = Vec3::Zero();
  double keptReach_u_ = 0.0;                      ///< distance from there to its farthest node
  std::shared_ptr<const TriangleMesh> heldFaces_; ///< faces of fixed nodes
  std::shared_ptr<const Scene> held_;             ///< scene of these faces
};

} // namespace palpate
