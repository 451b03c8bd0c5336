// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "haptics/compliance/servo/PressedBody.h"
#include "haptics/compliance/snapshot/SpreadPatches.h"
#include "haptics/mechanism/FoundContacts.h"
#include "haptics/mechanism/servo/MechanismTick.h"
#include "haptics/mechanism/sided/SidedSurface.h"

namespace palpate
{

/// The mesh of a rigid body.
struct FinderMesh
{
  int body = 0; ///< in the plan
  std::shared_ptr<const SidedSurface> surface;
  double friction = 0.0; ///< Coulomb's: that of a mesh which stands counts where it is touched
  bool loose = false;    ///< it moves by the forces on it
};

/// How near a mesh and the soft bodies have to be.
struct FinderReach
{
  double reach_u = 0.0;   ///< surfaces that are further apart do not meet until the next answer
  double touches_u = 0.0; ///< those that are no further apart touch, or will soon
  double covers_u = 0.0;  ///< likewise of the mesh in the hand with one that stands
};

/// The bodies as a finder looks at them.
struct FinderView
{
  std::span<const Pose> pose_W;             ///< of the rigid bodies, in the plan's order
  FinderReach held;                         ///< of the mesh in the hand
  FinderReach standing;                     ///< of the others
  std::span<const PressedBody* const> soft; ///< in the plan's order
  std::span<const MechanismPress> presses;  ///< the forces under which the soft bodies are bent
  std::span<const double> loose_u = {};     ///< reach of loose bodies, in the plan's order
};

/// A mesh and the body that it may meet, as a finder looks at the two. The mesh may be the surface of a soft body.
struct PairView
{
  const SidedSurface& mesh;
  Pose mesh_W;
  const SidedSurface& other; ///< a soft body's, or a mesh that stands
  const PressedBody* soft;   ///< null: a mesh that stands
  int index = 0;             ///< of the pair: another name for each place
  int mesh_i = 0;            ///< places are judged without the forces of this body of the plan; below 0: without any
  int soft_i = 0;
  double reach_u = 0.0;
  std::span<const MechanismPress> presses;
  bool rigid = false; ///< both are, and may lie flush on one another: edges meet only where both are sharp
  const PressedBody* softMesh = nullptr; ///< whose surface the mesh is; null: the mesh is rigid
  int softMesh_i = 0;                    ///< among the presses' soft bodies
  int other_i = 0;                       ///< of the plan: the soft mesh is judged without the forces of that body
};

/// A place where two surfaces meet, or may.
struct NearPlace
{
  FoundContact contact;
  double gap_u = 0.0;            ///< along the normal, the soft body bent as the forces bend it; below 0 they overlap
  double free_u = 0.0;           ///< the same to the other body without the forces of PairView::mesh_i
  Vec3 without_W = Vec3::Zero(); ///< place of the other body, bent in that way
  double area_u2 = 0.0;          ///< between two soft bodies: of the surfaces that touch, the part of this place
};

/// All places where a mesh may meet another body: a vertex of the body before the mesh, a vertex of the mesh before
/// the body, and two edges that cross, of the mesh's those that are sharp. In the order of their features.
[[nodiscard]] std::vector<NearPlace> nearPlaces(const PairView& view);

/// Of those the ones that are nearest, at most so many: on the other body, or on a soft mesh.
[[nodiscard]] std::vector<SurfacePoint> nearestPlaces(
  const std::vector<NearPlace>& near, std::size_t most, SurfacePoint FoundContact::*place = &FoundContact::place_B);

/// The least edge of a surface around a place [u].
[[nodiscard]] double edgeAround(const SidedSurface& surface, const SurfacePoint& place);

/// How many places may be chosen.
struct PlaceRoom
{
  std::size_t most = 0;
  std::size_t apart = 0; ///< no further place that does not touch yet is added to so many
};

/// Of those at most so many, one for each `apart_u` and each direction: of those that touch the deepest in the body as
/// it is without the mesh's forces, or almost the deepest if it was chosen before. `apart_u` is made larger until those
/// that touch have room.
struct ChosenPlaces
{
  std::vector<NearPlace> places;
  double apart_u = 0.0;
  int leftOut = 0;
};
/// Places that are taken one by one no nearer than some distance leave each a square with a side of so many of it.
inline constexpr double sideOfPlace = 1.2;
/// Whether a place is so far from each of others that press in much the same direction.
[[nodiscard]] bool standsApart(const NearPlace& near, const std::vector<NearPlace>& chosen, double apart_u);
[[nodiscard]] ChosenPlaces choosePlaces(
  const std::vector<NearPlace>& near, PlaceRoom room, double apart_u, double touches_u, const FoundContacts& before);

/// Finds where the meshes of rigid bodies meet the soft bodies, and soft bodies one another, the mesh in the hand those
/// that stand, and loose ones all others. Beside the tick, at the rate of the bodies' snapshots; the same view gives
/// the same answer on any number of threads. Not real-time safe.
class ContactFinder
{
public:
  /// `held`: the body of the plan that is in the hand; `most`: contacts that the tick has room for.
  ContactFinder(std::vector<FinderMesh> meshes, int held, std::size_t most);

  /// `body`: in the plan; `stiffness`: E / (1 - nu^2) of its softest material [N/u^2]; `friction`: Coulomb's, on other
  /// soft bodies. In the order in which views have them.
  void add(int body, const PressedBody& atRest, double stiffness, double friction = 0.0);

  [[nodiscard]] const FoundContacts& find(const FinderView& view);
  [[nodiscard]] const FoundContacts& last() const noexcept { return this->last_; }
  /// Radius of the patches through which a soft body is pressed: as wide as the contacts are apart, and no wider than a
  /// ball's contact, where the mesh is as round as one. That of the mesh in the hand, while it is near; the last one,
  /// where nothing was near.
  [[nodiscard]] double tip_u(std::size_t soft) const noexcept { return this->bodies_[soft].tip_u; }
  /// Places of a soft body where a mesh that stands or another soft body may press, the nearest ones.
  [[nodiscard]] const std::vector<SurfacePoint>& watched(std::size_t soft) const noexcept
  {
    return this->bodies_[soft].watched;
  }
  /// Parts of a soft body that contacts with other soft bodies press, of the last answer.
  [[nodiscard]] const std::vector<PressedPart>& parts(std::size_t soft) const noexcept
  {
    return this->bodies_[soft].parts;
  }
  /// Which body of the plan that is.
  [[nodiscard]] int bodyOf(std::size_t soft) const noexcept { return this->bodies_[soft].body; }
  /// The mesh in the hand; null: the hand has none.
  [[nodiscard]] const SidedSurface* held() const noexcept;

private:
  /// A mesh before a soft body.
  struct Ball
  {
    std::optional<double> contact_u; ///< radius of its contact, where it is as round as a ball; none: it is not
    std::optional<double>
      deep_u; ///< of its deepest place, by NearPlace::free_u, at the last answer; none: it was not near
  };
  struct Body
  {
    int body = 0;
    std::shared_ptr<const SidedSurface> surface;
    double stiffness = 0.0;
    double friction = 0.0;
    double tip_u = 0.0;
    std::vector<Ball> balls; ///< of each mesh
    std::vector<SurfacePoint> watched;
    std::vector<PressedPart> parts;
  };
  /// A mesh and another body that are near one another.
  struct Meeting
  {
    std::size_t mesh = 0,
                other = 0;       ///< `mesh`: or after these a soft body; `other`: a soft body, or after these a mesh
    std::vector<NearPlace> near; ///< in the other's frame
    double reach_u = 0.0;        ///< places that are no further apart were looked for
    Pose mesh_B;                 ///< of the mesh in the other's frame
  };

  [[nodiscard]] bool isHeld(std::size_t mesh) const noexcept
  {
    return mesh < this->meshes_.size() && this->meshes_[mesh].body == this->held_;
  }
  [[nodiscard]] bool isOfSoft(const Meeting& meeting) const noexcept { return meeting.mesh >= this->meshes_.size(); }
  /// The soft body whose surface the mesh of a meeting is; null: a rigid body's.
  [[nodiscard]] Body* softMeshOf(const Meeting& meeting) noexcept
  {
    return this->isOfSoft(meeting) ? &this->bodies_[meeting.mesh - this->meshes_.size()] : nullptr;
  }
  [[nodiscard]] const SidedSurface& surfaceOf(std::size_t mesh) const noexcept
  {
    const std::size_t rigid = this->meshes_.size();
    return mesh < rigid ? *this->meshes_[mesh].surface : *this->bodies_[mesh - rigid].surface;
  }
  /// Whether it is looked for places where a mesh meets another one: each pair once.
  [[nodiscard]] bool meets(std::size_t mesh, std::size_t other) const noexcept;
  [[nodiscard]] bool isOfLoose(const Meeting& meeting) const noexcept;
  [[nodiscard]] double reachOf(std::size_t mesh, const FinderView& view) const;
  [[nodiscard]] std::vector<Meeting> meetings(const FinderView& view) const;
  /// Of two soft bodies.
  [[nodiscard]] Meeting meetingOfSoft(std::size_t first, std::size_t second, int pair, const FinderView& view) const;
  [[nodiscard]] std::size_t touchingFirst(std::vector<Meeting>& met, const FinderView& view) const;
  void forget(const std::vector<Meeting>& met);
  /// Least distance between contacts, from the edges of the soft body there and the roundness of the mesh.
  [[nodiscard]] double apartOnSoft(const Meeting& meeting, double edge_u, const FinderView& view, bool isFirst);
  /// Whether a body has no contact yet in this answer: then the next one says how wide its patches are.
  [[nodiscard]] static bool isFirstOn(int body, const FoundContacts& found);
  void choose(const Meeting& meeting, PlaceRoom room, const FinderView& view, FoundContacts& found);
  void chooseOfSoft(const Meeting& meeting, PlaceRoom room, const FinderView& view, FoundContacts& found);
  void watch(const Meeting& meeting);

  std::vector<FinderMesh> meshes_; ///< that in the hand first
  int held_;
  std::size_t most_;
  std::vector<Body> bodies_;
  FoundContacts last_;
};

} // namespace palpate
