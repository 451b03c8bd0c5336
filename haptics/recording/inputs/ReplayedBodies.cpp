// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <utility>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "haptics/geometry/tree/SurfaceTree.h"
#include "haptics/mechanism/sided/StandingBody.h"
#include "haptics/mechanism/wire/WirePlan.h"
#include "haptics/recording/inputs/Mechanisms.h"
#include "haptics/recording/inputs/SceneLibrary.h"

namespace palpate
{
namespace
{

/// With the tree of the wire's vessel. False where the vessel is no surface.
bool completeWire(MechanismPlan& plan, const TriangleMesh& vessel_W)
{
  if (!plan.wire)
  {
    return true;
  }
  if (!refuseUnclean(vessel_W, false).empty())
  {
    return false;
  }
  auto wire = std::make_shared<WirePlan>(*plan.wire);
  wire->vessel = SurfaceTree::inOrder(vessel_W);
  plan.wire = std::move(wire);
  return true;
}

/// Whether surfaces are those of the mesh in the hand and of the meshes that stand, in the plan's order.
bool areMeshesOf(const MechanismPlan& plan, const Scene* surfaces)
{
  const auto standing = std::count_if(plan.bodies.begin(), plan.bodies.begin() + plan.bodyCount, isStandingMesh);
  return surfaces != nullptr && standing > 0 && surfaces->surfaces().size() == static_cast<std::size_t>(standing) + 1;
}

} // namespace

bool fits(const PressedBody& body, const Scene* scene)
{
  const std::uint32_t surface = body.touch.surface;
  return scene != nullptr && surface < scene->surfaces().size() &&
         scene->surfaces()[surface].tree->mesh().vertices_W.size() == body.snapshot->placeOf.size();
}

namespace input
{

std::string Bodies::Replay::take(const RecordedName& name, const Recorded& recorded, const ReplayPlace& place)
{
  const auto isIt = [&name](const auto& body) { return body->revision == name.id; };
  const auto found = std::find_if(recorded.bodies.begin(), recorded.bodies.end(), isIt);
  this->body_ = found != recorded.bodies.end() ? *found : nullptr;
  this->takeHeldFaces();
  const bool stops = !this->body_ || !this->body_->heldFaces || this->held_;
  return name.id != 0 && !(this->body_ && stops && fits(*this->body_, place.scene.get()))
           ? "the compliance of a soft body is missing in the recording, so that the recording cannot be recomputed"
           : "";
}

/// From snapshot to snapshot they stay, and so does the tree that they are found by.
void Bodies::Replay::takeHeldFaces()
{
  const auto now = this->body_ ? this->body_->heldFaces : nullptr;
  const bool same = now && this->heldFaces_ && now->vertices_W == this->heldFaces_->vertices_W &&
                    now->triangles == this->heldFaces_->triangles;
  this->held_ = same ? this->held_ : now ? sceneOfHeld(*now) : nullptr;
  this->heldFaces_ = now;
}

void Bodies::Replay::put(TickInput& tick, const ReplayPlace& place) noexcept
{
  tick.body = nullptr;
  if (this->body_ && fits(*this->body_, place.scene.get()))
  {
    this->now_ = *this->body_;
    this->now_.scene = place.scene;
    this->now_.held = this->held_;
    tick.body = &this->now_;
  }
}

/// The state of the tick before, if it is of the same plan, is followed into the bodies of this mechanism.
std::string Mechanisms::Replay::take(const RecordedName& name, const Recorded& recorded, const ReplayPlace& place)
{
  this->mechanism_.reset();
  if (name.id == 0)
  {
    return {};
  }
  const auto isIt = [&name](const RecordedMechanism& m) { return m.revision == name.id; };
  const auto found = std::find_if(recorded.mechanisms.begin(), recorded.mechanisms.end(), isIt);
  std::vector<std::shared_ptr<const PressedBody>> bodies;
  bool whole = found != recorded.mechanisms.end();
  for (std::size_t i = 0; whole && i < found->bodies.size(); ++i)
  {
    auto body = std::make_shared<PressedBody>(*found->bodies[i].body);
    body->scene = place.scenes.find(found->bodies[i].sceneHash, found->bodies[i].sceneRevision);
    if (!body->scene)
    {
      return SceneLibrary::missing;
    }
    whole = fits(*body, body->scene.get());
    bodies.push_back(std::move(body));
  }
  MechanismPlan plan = whole ? found->plan : MechanismPlan{};
  if (!whole || !fits(place.state.mechanism, *found) || !completeWire(plan, found->vessel_W))
  {
    return "a held mechanism is missing in the recording, so that the recording cannot be recomputed";
  }
  if (found->meshesHash == 0)
  {
    this->meshes_.reset();
  }
  else
  {
    const bool same = this->meshes_ && this->meshes_->scene()->contentHash() == found->meshesHash;
    const auto surfaces = same ? this->meshes_->scene() : place.scenes.find(found->meshesHash, found->meshesRevision);
    if (!areMeshesOf(plan, surfaces.get()))
    {
      return SceneLibrary::missing;
    }
    this->meshes_ = same ? this->meshes_ : makeStandingMeshes(surfaces);
  }
  this->mechanism_ =
    std::make_shared<const FeltMechanism>(name.id, plan, std::move(bodies), found->found, this->meshes_);
  return {};
}

} // namespace input
} // namespace palpate
