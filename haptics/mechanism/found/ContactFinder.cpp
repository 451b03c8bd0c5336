// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/found/ContactFinder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "haptics/core/PoseMath.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/mechanism/found/MeshRoundness.h"
#include "haptics/mechanism/found/PlacesByArea.h"

namespace palpate
{
namespace
{

/// Of the distance between contacts: so much nearer is another one that takes the place of one that was chosen before,
/// or another plane of the mesh.
constexpr double kept = 0.005;
constexpr double wider = 1.25;
/// Edges of the soft body that a mesh may go beyond where it touches first.
constexpr double strides = 2.0;
constexpr int mostWidenings = 30;
/// The same of a ball's contact, of its radius (Hertz: 3 F / (4 E* a) deep).
constexpr double tipOfBall = 0.6587 / 0.75;
/// Of the edges around: no patch is smaller, so that a force that begins has some.
constexpr double leastTip = 0.1;
/// In edges of the soft body, and in radii of its last contact: so far it is looked at whether a mesh is as round as a
/// ball.
constexpr double seenEdges = 2.0, seenOfBall = 2.5;
/// Of how far a mesh is looked at: a larger radius is that of a flat mesh with rounding.
constexpr double flatFrom = 1e4;
/// Periods until an answer is in use, in the middle: it comes a period later and is used for one.
constexpr double usedAfter = 1.5;
/// Radii of a ball's contact between contacts: within them the ball is one.
constexpr double acrossBall = 2.2;
/// Of the size of the mesh in the hand: contacts with a mesh that stands are no further apart, however large the
/// triangles of that are.
constexpr double apartOfHeld = 0.1;
/// Of the share of a tick's contacts for two soft bodies: that of a rigid mesh with another body.
constexpr std::size_t weightOfMesh = 2;
/// Of a mesh's size: pairs with a loose body that are no further apart touch, or will soon.
constexpr double nearlyTouching = 0.01;

ChosenPlaces spread(const std::vector<NearPlace>& sorted, PlaceRoom room, double apart_u, double touches_u)
{
  ChosenPlaces chosen;
  chosen.apart_u = apart_u;
  for (const NearPlace& near : sorted)
  {
    if (!standsApart(near, chosen.places, apart_u))
    {
      continue;
    }
    if (near.gap_u <= touches_u || chosen.places.size() < room.apart)
    {
      chosen.places.push_back(near);
    }
  }
  return chosen;
}

/// The vertex becomes the point, and the plane is the mesh's. `mesh_B`: pose of the mesh in the other's frame.
void turnRound(const Pose& mesh_B, FoundContact& contact)
{
  std::swap(contact.mesh, contact.body);
  std::swap(contact.point_A, contact.place_B.x_W);
  contact.normal_B = mesh_B.q.conjugate() * Vec3(-contact.normal_B);
}

/// Leaves a vertex of the soft body on the plane of the mesh that it had in the last answer while another plane is
/// hardly nearer. Where two of the mesh's facets meet bluntly, the vertex goes along the plane that it has beyond their
/// edge, where the other one is nearer: the next answer would lead it back, and so on.
void keepPlanes(const FoundContacts& before, const Quat& turned, const Pose& mesh_W, std::vector<NearPlace>& near)
{
  const auto end = before.contacts.begin() + before.count;
  for (NearPlace& place : near)
  {
    FoundContact& contact = place.contact;
    const auto was =
      std::find_if(before.contacts.begin(), end, [&](const FoundContact& other) { return other.name == contact.name; });
    if (was == end || !contact.isAtVertexOfOther())
    {
      continue;
    }
    const Vec3 normal_W = turned * was->normal_B, on_W = mesh_W * contact.point_A;
    const double gap_u = normal_W.dot(mesh_W * was->point_A - on_W + place.gap_u * contact.normal_B);
    if (std::abs(gap_u - place.gap_u) > kept * was->apart_u || normal_W.dot(contact.normal_B) < FoundContact::alike)
    {
      continue;
    }
    const Vec3 onPlane_W = on_W + normal_W.dot(mesh_W * was->point_A - on_W) * normal_W;
    contact.point_A = into(mesh_W, onPlane_W);
    contact.normal_B = normal_W;
    place.gap_u = gap_u;
    place.free_u = normal_W.dot(onPlane_W - place.without_W);
  }
}

double forceOn(int soft, int from, std::span<const MechanismPress> presses)
{
  Vec3 sum_N = Vec3::Zero();
  for (const MechanismPress& press : presses)
  {
    sum_N += press.soft == soft && press.from == from ? press.force_N : Vec3(Vec3::Zero());
  }
  return sum_N.norm();
}

} // namespace

bool standsApart(const NearPlace& near, const std::vector<NearPlace>& chosen, double apart_u)
{
  return std::ranges::none_of(chosen,
    [&](const NearPlace& other)
    {
      const Vec3 way_u = near.contact.place_B.x_W - other.contact.place_B.x_W;
      return way_u.norm() < apart_u && near.contact.normal_B.dot(other.contact.normal_B) > FoundContact::alike;
    });
}

ChosenPlaces choosePlaces(
  const std::vector<NearPlace>& near, PlaceRoom room, double apart_u, double touches_u, const FoundContacts& before)
{
  const auto wasChosen = [&before](const NearPlace& place)
  {
    return std::any_of(before.contacts.begin(), before.contacts.begin() + before.count,
      [&place](const FoundContact& other) { return other.name == place.contact.name; });
  };
  std::vector<std::tuple<bool, double, std::uint64_t, std::size_t>> order;
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    const bool apart = near[i].gap_u > touches_u;
    const double bonus_u = wasChosen(near[i]) ? kept * apart_u : 0.0;
    order.emplace_back(apart, (apart ? near[i].gap_u : near[i].free_u) - bonus_u, near[i].contact.name, i);
  }
  std::ranges::sort(order);
  std::vector<NearPlace> sorted;
  std::ranges::transform(
    order, std::back_inserter(sorted), [&near](const auto& key) { return near[std::get<3>(key)]; });
  ChosenPlaces chosen = spread(sorted, room, apart_u, touches_u);
  for (int left = mostWidenings; left > 0 && chosen.places.size() > room.most; --left)
  {
    chosen = spread(sorted, room, wider * chosen.apart_u, touches_u);
  }
  if (chosen.places.size() > room.most)
  {
    chosen.leftOut = static_cast<int>(chosen.places.size() - room.most);
    chosen.places.resize(room.most);
  }
  return chosen;
}

ContactFinder::ContactFinder(std::vector<FinderMesh> meshes, int held, std::size_t most)
  : meshes_(std::move(meshes)), held_(held), most_(std::min(most, static_cast<std::size_t>(FoundContacts::most)))
{
  std::ranges::stable_partition(this->meshes_, [held](const FinderMesh& mesh) { return mesh.body == held; });
}

void ContactFinder::add(int body, const PressedBody& atRest, double stiffness, double friction)
{
  this->bodies_.push_back({ body, makeSided(atRest.scene->surfaces()[atRest.touch.surface].tree), stiffness, friction,
    0.0, std::vector<Ball>(this->meshes_.size()), {}, {} });
}

const SidedSurface* ContactFinder::held() const noexcept
{
  return !this->meshes_.empty() && this->isHeld(0) ? this->meshes_.front().surface.get() : nullptr;
}

bool ContactFinder::meets(std::size_t mesh, std::size_t other) const noexcept
{
  const FinderMesh &one = this->meshes_[mesh], &two = this->meshes_[other];
  return mesh != other && (this->isHeld(mesh) || (one.loose && !this->isHeld(other) && (!two.loose || mesh < other)));
}

bool ContactFinder::isOfLoose(const Meeting& meeting) const noexcept
{
  const bool rigid = meeting.other >= this->bodies_.size();
  return rigid && (this->meshes_[meeting.mesh].loose || this->meshes_[meeting.other - this->bodies_.size()].loose);
}

double ContactFinder::reachOf(std::size_t mesh, const FinderView& view) const
{
  const FinderMesh& of = this->meshes_[mesh];
  return this->isHeld(mesh) ? view.held.reach_u
         : of.loose         ? view.loose_u[static_cast<std::size_t>(of.body)]
                            : view.standing.reach_u;
}

std::vector<ContactFinder::Meeting> ContactFinder::meetings(const FinderView& view) const
{
  std::vector<Meeting> met;
  int pair = 0;
  // Contacts of the mesh in the hand are judged on the body without any force. A body comes to a standing mesh only as
  // the hand bends it, so that there the forces of other meshes count.
  const auto look = [&](std::size_t m, std::size_t other, const SidedSurface& surface, const PressedBody* soft)
  {
    const Pose& mesh_W = view.pose_W[static_cast<std::size_t>(this->meshes_[m].body)];
    Meeting meeting{ m, other, {}, this->reachOf(m, view), mesh_W };
    const Quat turned = this->isHeld(m) ? mesh_W.q * this->last_.held_W.q.conjugate() : Quat::Identity();
    const bool loose = this->isOfLoose(meeting);
    if (loose)
    {
      const FinderMesh& two = this->meshes_[other - this->bodies_.size()];
      meeting.mesh_B = into(view.pose_W[static_cast<std::size_t>(two.body)], mesh_W);
      meeting.reach_u += two.loose ? this->reachOf(other - this->bodies_.size(), view) : 0.0;
    }
    meeting.near = nearPlaces({ *this->meshes_[m].surface, meeting.mesh_B, surface, soft, pair++,
      this->isHeld(m) ? -1 : this->meshes_[m].body, static_cast<int>(other), meeting.reach_u, view.presses, loose });
    if (!loose)
    {
      keepPlanes(this->last_, turned, mesh_W, meeting.near);
    }
    if (!meeting.near.empty())
    {
      met.push_back(std::move(meeting));
    }
  };
  for (std::size_t m = 0; m < this->meshes_.size(); ++m)
  {
    for (std::size_t s = 0; s < this->bodies_.size(); ++s)
    {
      if (view.soft[s] != nullptr)
      {
        look(m, s, *this->bodies_[s].surface, view.soft[s]);
      }
    }
    for (std::size_t other = 0; other < this->meshes_.size(); ++other)
    {
      if (this->meets(m, other))
      {
        look(m, this->bodies_.size() + other, *this->meshes_[other].surface, nullptr);
      }
    }
  }
  for (std::size_t first = 0; first < this->bodies_.size(); ++first)
  {
    for (std::size_t second = first + 1; second < this->bodies_.size(); ++second)
    {
      if (Meeting meeting = this->meetingOfSoft(first, second, pair++, view); !meeting.near.empty())
      {
        met.push_back(std::move(meeting));
      }
    }
  }
  return met;
}

/// A soft body that the mesh in the hand is near has patches for that mesh: other contacts are as far apart as these
/// patches are wide.
double ContactFinder::apartOnSoft(const Meeting& meeting, double edge_u, const FinderView& view, bool isFirst)
{
  Body& body = this->bodies_[meeting.other];
  const int mesh = this->meshes_[meeting.mesh].body;
  const double force_N = forceOn(static_cast<int>(meeting.other), mesh, view.presses);
  Ball& ball = body.balls[meeting.mesh];
  Roundness round = roundness(meeting.near, view.pose_W[static_cast<std::size_t>(mesh)],
    std::max(seenEdges * edge_u, seenOfBall * ball.contact_u.value_or(0.0)));
  // A ball that does not press yet has a contact of no size, and a loose body may lie there from the first tick on.
  const bool flat = this->meshes_[meeting.mesh].loose && round.radius_u > flatFrom * round.seen_u;
  round.radius_u = flat ? std::numeric_limits<double>::infinity() : round.radius_u;
  const double deep_u = -std::ranges::min_element(meeting.near, {}, &NearPlace::free_u)->free_u;
  const double deeper_u = ball.deep_u ? deep_u - *ball.deep_u : 0.0;
  ball.deep_u = deep_u;
  ball.contact_u = ballContact(round, { force_N, deep_u, deep_u + usedAfter * deeper_u }, body.stiffness);
  return std::max({ edge_u, acrossBall * ball.contact_u.value_or(0.0), isFirst ? 0.0 : body.tip_u / tipOfPlace });
}

/// A soft body is the mesh of some of its contacts, and the other body of others.
bool ContactFinder::isFirstOn(int body, const FoundContacts& found)
{
  return std::none_of(found.contacts.begin(), found.contacts.begin() + found.count,
    [body](const FoundContact& contact) { return contact.body == body || contact.mesh == body; });
}

void ContactFinder::choose(const Meeting& meeting, PlaceRoom room, const FinderView& view, FoundContacts& found)
{
  const std::size_t m = meeting.mesh, other = meeting.other;
  const std::vector<NearPlace>& near = meeting.near;
  Body* const soft = other < this->bodies_.size() ? &this->bodies_[other] : nullptr;
  const FinderMesh* const standing = soft ? nullptr : &this->meshes_[other - this->bodies_.size()];
  const int body = soft ? soft->body : standing->body;
  const auto nearest = std::ranges::min_element(near, {}, &NearPlace::gap_u);
  const double edge_u = edgeAround(soft ? *soft->surface : *standing->surface, nearest->contact.place_B);
  const bool isFirst = isFirstOn(body, found);
  const bool loose = this->isOfLoose(meeting);
  const double apart_u = soft ? this->apartOnSoft(meeting, edge_u, view, isFirst)
                         : loose
                           ? apartOfHeld * std::min(this->meshes_[m].surface->diagonal_u, standing->surface->diagonal_u)
                           : std::min(edge_u, apartOfHeld * this->meshes_[m].surface->diagonal_u);
  const FinderReach& reach = this->isHeld(m) ? view.held : view.standing;
  const double touches_u = soft ? reach.touches_u : loose ? meeting.reach_u : std::max(reach.touches_u, reach.covers_u);
  const ChosenPlaces chosen = choosePlaces(near, room, apart_u, touches_u, this->last_);
  if (soft && isFirst)
  {
    const std::optional<double> ball_u = soft->balls[m].contact_u;
    soft->tip_u = ball_u ? std::max(leastTip * edge_u, tipOfBall * *ball_u) : tipOfPlace * chosen.apart_u;
  }
  if (this->isHeld(m))
  {
    // Beyond, places may touch that lie aside of those that are near now. At a mesh that stands, those that may touch
    // until the next answer have contacts already: no edge of a fine mesh slows the hand down.
    const double beyond_u = std::max(nearest->gap_u, 0.0) + strides * (soft ? edge_u : apart_u);
    found.reach_u = std::min(found.reach_u, soft ? beyond_u : std::max(beyond_u, touches_u));
  }
  found.leftOut += chosen.leftOut;
  for (const NearPlace& place : chosen.places)
  {
    FoundContact& contact = found.contacts[static_cast<std::size_t>(found.count++)];
    contact = place.contact;
    contact.mesh = this->meshes_[m].body;
    contact.body = body;
    contact.apart_u = chosen.apart_u;
    contact.friction = (standing ? *standing : this->meshes_[m]).friction;
    if (loose && contact.isAtVertexOfOther())
    {
      turnRound(meeting.mesh_B, contact);
    }
  }
}

/// Places are watched anew in each answer, and the depth of a mesh says nothing of its motion once an answer has missed
/// the mesh.
void ContactFinder::forget(const std::vector<Meeting>& met)
{
  for (std::size_t s = 0; s < this->bodies_.size(); ++s)
  {
    this->bodies_[s].watched.clear();
    this->bodies_[s].parts.clear();
    for (std::size_t m = 0; m < this->meshes_.size(); ++m)
    {
      const bool meets =
        std::ranges::any_of(met, [m, s](const Meeting& meeting) { return meeting.mesh == m && meeting.other == s; });
      std::optional<double>& deep_u = this->bodies_[s].balls[m].deep_u;
      deep_u = meets ? deep_u : std::nullopt;
    }
  }
}

/// Where bodies are loose, or two soft ones may meet, pairs that touch come first and share all the room: those that
/// only may meet take none of it.
std::size_t ContactFinder::touchingFirst(std::vector<Meeting>& met, const FinderView& view) const
{
  const bool loose = std::ranges::any_of(met, [this](const Meeting& meeting) { return this->isOfLoose(meeting); });
  const bool soft = std::ranges::any_of(met, [this](const Meeting& meeting) { return this->isOfSoft(meeting); });
  const auto touches = [&](const Meeting& meeting)
  {
    const double gap_u = std::ranges::min_element(meeting.near, {}, &NearPlace::gap_u)->gap_u;
    const double soon_u = (this->isHeld(meeting.mesh) ? view.held : view.standing).touches_u;
    const double nearly_u = nearlyTouching * this->surfaceOf(meeting.mesh).diagonal_u;
    return gap_u <= (loose ? nearly_u : std::max(nearly_u, soon_u));
  };
  const auto others = loose || soft ? std::stable_partition(met.begin(), met.end(), touches) : met.end();
  return static_cast<std::size_t>(others - met.begin());
}

const FoundContacts& ContactFinder::find(const FinderView& view)
{
  std::vector<Meeting> met = this->meetings(view);
  FoundContacts found;
  found.answer = this->last_.answer + 1;
  found.reach_u = std::numeric_limits<double>::infinity();
  if (this->held() != nullptr && view.held.reach_u >= 0.0)
  {
    found.reach_u = view.held.reach_u;
    found.held_W = view.pose_W[static_cast<std::size_t>(this->held_)];
  }
  this->forget(met);
  const std::size_t touching = this->touchingFirst(met, view);
  for (std::size_t i = 0; i < met.size(); ++i)
  {
    const Meeting& meeting = met[i];
    this->watch(meeting);
    // Pairs that follow have an even share at least, and all that is left over. Two soft bodies press parts, of which
    // fewer do as well.
    const auto weightOf = [this](const Meeting& of) { return this->isOfSoft(of) ? std::size_t{ 1 } : weightOfMesh; };
    std::size_t left = 0;
    for (std::size_t k = i; k < (i < touching ? touching : met.size()); ++k)
    {
      left += weightOf(met[k]);
    }
    const std::size_t share = weightOf(meeting) * (this->most_ - static_cast<std::size_t>(found.count)) / left;
    const PlaceRoom room{ share, i + 1 < met.size() ? (share + 1) / 2 : share };
    if (this->softMeshOf(meeting))
    {
      this->chooseOfSoft(meeting, room, view, found);
      continue;
    }
    this->choose(meeting, room, view, found);
  }
  this->last_ = found;
  return this->last_;
}

} // namespace palpate
