// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/mechanism/found/ContactFinder.h"
#include "haptics/mechanism/found/PlacesByArea.h"

namespace palpate
{
namespace
{

/// Places before one mesh that stands, or before another soft body, whose compliance is known: so many of a body's 192.
constexpr std::size_t mostWatched = 48;

/// Has the place of a contact on one of two soft bodies stand for a part, at the vertex that is nearest to it: at a
/// face that is flat the gap stays. A part without a vertex of that body, or at the vertex of another part, has the
/// patch of its place.
void pressPart(const std::vector<const NearPlace*>& members, SurfacePoint FoundContact::*place,
  const ComplianceSnapshot& snapshot, std::vector<PressedPart>& parts, FoundContact& contact)
{
  PressedPart part;
  double area_u2 = 0.0;
  for (const NearPlace* member : members)
  {
    const SurfacePoint& at = member->contact.*place;
    if (member->area_u2 > 0.0 && at.vertices[0] == at.vertices[1])
    {
      part.vertices.push_back(at.vertices[0]);
      part.shares.push_back(member->area_u2);
      area_u2 += member->area_u2;
    }
  }
  SurfacePoint& at = contact.*place;
  Eigen::Index corner = 0;
  at.weights.maxCoeff(&corner);
  part.at = at.vertices[static_cast<std::size_t>(corner)];
  if (part.vertices.empty() || std::ranges::find(parts, part.at, &PressedPart::at) != parts.end())
  {
    return;
  }
  std::ranges::for_each(part.shares, [area_u2](double& share) { share /= area_u2; });
  at = { { part.at, part.at, part.at }, Vec3::UnitX(), snapshot.free_W[part.at] };
  parts.push_back(std::move(part));
}

} // namespace

/// Neither of the two is judged by the forces between them: they would hide how deep the two are in one another.
ContactFinder::Meeting ContactFinder::meetingOfSoft(
  std::size_t first, std::size_t second, int pair, const FinderView& view) const
{
  const Body &one = this->bodies_[first], &two = this->bodies_[second];
  Meeting meeting{ this->meshes_.size() + first, second, {}, view.standing.reach_u, {} };
  if (view.soft[first] != nullptr && view.soft[second] != nullptr)
  {
    PairView both{ *one.surface, {}, *two.surface, view.soft[second], pair, one.body, static_cast<int>(second),
      meeting.reach_u, view.presses };
    both.softMesh = view.soft[first];
    both.softMesh_i = static_cast<int>(first);
    both.other_i = two.body;
    meeting.near = nearPlaces(both);
  }
  return meeting;
}

/// The patches of both bodies are as wide as the contacts are apart, where no other contact has made them so.
void ContactFinder::chooseOfSoft(const Meeting& meeting, PlaceRoom room, const FinderView& view, FoundContacts& found)
{
  const std::size_t first = meeting.mesh - this->meshes_.size();
  const std::array<Body*, 2> bodies{ &this->bodies_[first], &this->bodies_[meeting.other] };
  const FoundContact& nearest = std::ranges::min_element(meeting.near, {}, &NearPlace::gap_u)->contact;
  const std::array<SurfacePoint, 2> places{ nearest.place_A, nearest.place_B };
  std::array<bool, 2> isFirst{};
  double apart_u = 0.0;
  for (std::size_t side = 0; side < bodies.size(); ++side)
  {
    const Body& body = *bodies[side];
    isFirst[side] = isFirstOn(body.body, found);
    apart_u =
      std::max({ apart_u, edgeAround(*body.surface, places[side]), isFirst[side] ? 0.0 : body.tip_u / tipOfPlace });
  }
  PlacesByArea byArea = choosePlacesByArea(meeting.near, room, apart_u, view.standing.touches_u, this->last_);
  ChosenPlaces& chosen = byArea.chosen;
  for (std::size_t i = 0; i < byArea.parts.size(); ++i)
  {
    FoundContact& contact = chosen.places[i].contact;
    pressPart(byArea.parts[i], &FoundContact::place_A, *view.soft[first]->snapshot, bodies[0]->parts, contact);
    pressPart(byArea.parts[i], &FoundContact::place_B, *view.soft[meeting.other]->snapshot, bodies[1]->parts, contact);
    contact.point_A = contact.place_A.x_W;
  }
  for (std::size_t side = 0; side < bodies.size(); ++side)
  {
    bodies[side]->tip_u = isFirst[side] ? tipOfPlace * chosen.apart_u : bodies[side]->tip_u;
  }
  for (const NearPlace& place : chosen.places)
  {
    FoundContact& contact = found.contacts[static_cast<std::size_t>(found.count++)];
    contact = place.contact;
    contact.mesh = bodies[0]->body;
    contact.body = bodies[1]->body;
    contact.apart_u = chosen.apart_u;
    contact.friction = bodies[0]->friction;
  }
}

/// Places that the mesh in the hand does not come to: the snapshots look around those.
void ContactFinder::watch(const Meeting& meeting)
{
  const auto add = [&meeting](Body& body, SurfacePoint FoundContact::*place)
  {
    const std::vector<SurfacePoint> nearest = nearestPlaces(meeting.near, mostWatched, place);
    body.watched.insert(body.watched.end(), nearest.begin(), nearest.end());
  };
  if (!this->isHeld(meeting.mesh) && meeting.other < this->bodies_.size())
  {
    add(this->bodies_[meeting.other], &FoundContact::place_B);
  }
  if (Body* const mesh = this->softMeshOf(meeting))
  {
    add(*mesh, &FoundContact::place_A);
  }
}

} // namespace palpate
