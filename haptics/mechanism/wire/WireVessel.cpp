// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/wire/WireVessel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/geometry/tree/TreeWalk.h"
#include "haptics/mechanism/wire/SegmentDistance.h"

namespace palpate
{
namespace
{

/// Cosine between normals of one node that are two: half a degree.
constexpr double alike = 0.99996;
/// Of the radius: so much nearer than the straight line between two touching nodes a wall bulges out towards a beam.
constexpr double bulges = 1e-6;
/// A touch between a beam's nodes is no nearer to either of them, as a share of the beam: there the node touches.
constexpr double inside = 1e-3;
/// Of a beam: so much further than is needed triangles are kept. A wire that slides so far asks again.
constexpr double beyond = 0.3;
/// Of the radius: a node touches a second wall of much the same direction within that distance.
constexpr double almost = 0.02;
/// Of a beam: less of it outside of the sheath has no direction.
constexpr double leastOutside = 1e-6;

/// The nearest places of a beam that are contacts.
struct Nearest
{
  std::array<WireContact, 3> end;     ///< at the second node, in directions that differ
  std::array<WireContact, 2> between; ///< of both nodes, likewise
};

/// Whether a contact is in none of the directions of those before it.
template<std::size_t count>
bool isOther(const WireContact& contact, const std::array<WireContact, count>& others, int before) noexcept
{
  return std::all_of(others.begin(), others.begin() + before,
    [&contact](const WireContact& other) { return contact.normal_M.dot(other.normal_M) < alike; });
}

WireContact contactAt(int beam, double share, const Vec3& axis_M, const Vec3& wall_M, double radius_u) noexcept
{
  const Vec3 off_M = axis_M - wall_M;
  const double away_u = off_M.norm();
  return { beam, share, away_u - radius_u, wall_M, away_u > 0.0 ? Vec3(off_M / away_u) : Vec3(Vec3::UnitZ()) };
}

/// Whether a candidate is nearer; ties go to the smaller place, so that an order of visits does not matter.
bool isNearer(const WireContact& a, const WireContact& b) noexcept
{
  const auto key = [](const WireContact& c) {
    return std::array{ c.gap_u, c.at_M.x(), c.at_M.y(), c.at_M.z(), c.share };
  };
  return key(a) < key(b);
}

/// Along a straight wall both nodes say it all.
void leaveOutStraight(
  const WireContacts& contacts, const Nearest& nearest, double radius_u, WireContact& between) noexcept
{
  const auto along = [&](const WireContact& end) { return end.normal_M.dot(between.normal_M) > alike; };
  for (int i = contacts.count - 1; i >= 0 && contacts.all[i].beam == between.beam - 1; --i)
  {
    const WireContact& before = contacts.all[i];
    if (before.share == 1.0 && along(before) && along(nearest.end[0]))
    {
      const double line_u = (1.0 - between.share) * before.gap_u + between.share * nearest.end[0].gap_u;
      const bool bulge = between.gap_u < line_u - bulges * radius_u;
      between.gap_u = bulge ? between.gap_u : std::numeric_limits<double>::infinity();
    }
  }
}

/// No place of the triangle is nearer to the segment from a to b: by the ball around its corners.
double leastAway(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& corner) noexcept
{
  const Vec3 middle = (corner[0] + corner[1] + corner[2]) / 3.0;
  double ball2_u2 = 0.0;
  for (const Vec3& c : corner)
  {
    ball2_u2 = std::max(ball2_u2, (c - middle).squaredNorm());
  }
  const Vec3 along = b - a;
  const double share = std::clamp(along.dot(middle - a) / along.squaredNorm(), 0.0, 1.0);
  return (a + share * along - middle).norm() - std::sqrt(ball2_u2);
}

/// No place of a plane is nearer to the segment from a to b.
double beyondPlane(const Vec3& a, const Vec3& b, const Vec3& on, const Vec3& normal) noexcept
{
  const double first_u = normal.dot(a - on), second_u = normal.dot(b - on);
  return first_u * second_u > 0.0 ? std::min(std::abs(first_u), std::abs(second_u)) : 0.0;
}

void add(const WireContact& contact, double reach_u, WireContacts& contacts) noexcept
{
  if (contact.gap_u <= reach_u)
  {
    contacts.all[contacts.count++] = contact;
  }
}

/// The nearest places of a beam, by walks over the triangles near it.
struct NearestOfBeam
{
  double radius_u;
  double reach_u;
  int beam;
  const Vec3& first_M; ///< of the axis, clipped at the mouth
  const Vec3& second_M;
  double from; ///< share of the second node where it is clipped

  /// `each(take)`: calls `take` with the corners of each triangle. `away_u`: brought down to the nearest one.
  template<class Each>
  void find(const Each& each, Nearest& nearest, double& away_u) const noexcept
  {
    std::ranges::for_each(nearest.end, [](WireContact& c) { c.gap_u = std::numeric_limits<double>::infinity(); });
    std::ranges::for_each(nearest.between, [](WireContact& c) { c.gap_u = std::numeric_limits<double>::infinity(); });
    each([&](const std::array<Vec3, 3>& c) { this->takeFirst(c, nearest, away_u); });
    for (int i = 1; i < 3 && nearest.end[i - 1].gap_u <= this->reach_u; ++i)
    {
      each([&](const std::array<Vec3, 3>& c) { this->takeOtherEnd(c, i, nearest); });
    }
    if (nearest.between[0].gap_u <= this->reach_u)
    {
      each([&](const std::array<Vec3, 3>& c) { this->takeOtherBetween(c, nearest); });
    }
  }

private:
  [[nodiscard]] WireContact endAt(const std::array<Vec3, 3>& c) const noexcept
  {
    return contactAt(
      this->beam, 1.0, this->second_M, nearestOnTriangle(this->second_M, c[0], c[1], c[2]), this->radius_u);
  }

  [[nodiscard]] WireContact betweenAt(const SegmentPair& pair) const noexcept
  {
    return contactAt(this->beam, this->from + pair.along * (1.0 - this->from),
      this->first_M + pair.along * (this->second_M - this->first_M), pair.on, this->radius_u);
  }

  [[nodiscard]] static bool isBetween(const SegmentPair& pair) noexcept
  {
    return pair.along > inside && pair.along < 1.0 - inside;
  }

  void takeFirst(const std::array<Vec3, 3>& c, Nearest& nearest, double& away_u) const noexcept
  {
    const WireContact end = this->endAt(c);
    nearest.end[0] = isNearer(end, nearest.end[0]) ? end : nearest.end[0];
    for (int k = 0; k < 3; ++k)
    {
      const SegmentPair pair = nearestOfSegments(this->first_M, this->second_M, c[k], c[(k + 1) % 3]);
      away_u = std::min(away_u, pair.away_u);
      if (isBetween(pair))
      {
        const WireContact between = this->betweenAt(pair);
        nearest.between[0] = isNearer(between, nearest.between[0]) ? between : nearest.between[0];
      }
    }
    const double first_u = (nearestOnTriangle(this->first_M, c[0], c[1], c[2]) - this->first_M).norm();
    away_u = std::min({ away_u, end.gap_u + this->radius_u, first_u });
  }

  void takeOtherEnd(const std::array<Vec3, 3>& c, int i, Nearest& nearest) const noexcept
  {
    const WireContact end = this->endAt(c);
    nearest.end[i] = isOther(end, nearest.end, i) && isNearer(end, nearest.end[i]) ? end : nearest.end[i];
  }

  void takeOtherBetween(const std::array<Vec3, 3>& c, Nearest& nearest) const noexcept
  {
    for (int k = 0; k < 3; ++k)
    {
      const SegmentPair pair = nearestOfSegments(this->first_M, this->second_M, c[k], c[(k + 1) % 3]);
      const WireContact other = this->betweenAt(pair);
      const bool counts = isBetween(pair) && isOther(other, nearest.between, 1);
      nearest.between[1] = counts && isNearer(other, nearest.between[1]) ? other : nearest.between[1];
    }
  }
};

/// Those between the nodes first. A second one in much the same direction counts only where the wire nearly touches.
void addNearest(double radius_u, double reach_u, Nearest& nearest, WireContacts& contacts) noexcept
{
  for (WireContact& between : nearest.between)
  {
    leaveOutStraight(contacts, nearest, radius_u, between);
    const bool second = &between != nearest.between.data();
    add(between, second ? almost * radius_u : reach_u, contacts);
  }
  add(nearest.end[0], reach_u, contacts);
  for (int i = 1; i < 3 && nearest.end[i].gap_u < std::numeric_limits<double>::infinity(); ++i)
  {
    const double turns = nearest.end[0].normal_M.cross(nearest.end[i].normal_M).norm();
    const bool corner = nearest.end[0].normal_M.dot(nearest.end[i].normal_M) < 0.0;
    add(nearest.end[i], corner ? reach_u : turns * reach_u + almost * radius_u, contacts);
  }
}

} // namespace

void WireVessel::forget() noexcept
{
  for (Around& around : this->around_)
  {
    around.known = false;
  }
}

double WireVessel::movedSince(const Around& around, const Axis& axis) const noexcept
{
  return std::max((axis.first_M - around.first_M).norm(), (axis.second_M - around.second_M).norm());
}

void WireVessel::ask(const WirePlan& plan, const Axis& axis, double reach_u, Around& around) noexcept
{
  constexpr float down = 1.0F - 1e-6F;
  const SurfaceData& vessel = plan.vessel->data();
  const Vec3 reach = Vec3::Constant(reach_u);
  const Box box{ axis.first_M.cwiseMin(axis.second_M) - reach, axis.first_M.cwiseMax(axis.second_M) + reach };
  around.known = true;
  around.count = 0;
  around.all_u = reach_u;
  around.first_M = axis.first_M;
  around.second_M = axis.second_M;
  const auto isNearer = [](const Near& a, const Near& b)
  { return a.away_u != b.away_u ? a.away_u < b.away_u : a.triangle < b.triangle; };
  const auto visit = [&](std::uint32_t triangle)
  {
    const std::array<Vec3, 3> corners = vessel.cornersOf(triangle);
    if (!(leastAway(axis.first_M, axis.second_M, corners) < around.all_u))
    {
      return;
    }
    const double away_u = awayFromTriangle(axis.first_M, axis.second_M, corners);
    if (!(away_u < around.all_u))
    {
      return;
    }
    const Near near{ triangle, down * static_cast<float>(away_u) };
    const auto begin = around.near.begin();
    if (around.count < mostNear)
    {
      around.near[around.count++] = near;
      std::push_heap(begin, begin + around.count, isNearer);
      return;
    }
    around.all_u = static_cast<double>(std::max(around.near.front().away_u, near.away_u));
    if (isNearer(near, around.near.front()))
    {
      std::pop_heap(begin, begin + around.count, isNearer);
      around.near[around.count - 1] = near;
      std::push_heap(begin, begin + around.count, isNearer);
    }
  };
  forEachMeeting(
    vessel, [&box](const Box& other) { return overlap(box, other); }, visit);
  std::sort_heap(around.near.begin(), around.near.begin() + around.count, isNearer);
}

double WireVessel::look(
  const WirePlan& plan, int beam, const Axis& axis, double needed_u, WireContacts& contacts) noexcept
{
  Around& around = this->around_[beam];
  const double moved_u = around.known ? this->movedSince(around, axis) : 0.0;
  if (around.known && around.all_u - moved_u >= needed_u)
  {
    return moved_u;
  }
  this->ask(plan, axis, needed_u + std::max(beyond * plan.wire.beams[beam].length_u, 2.0 * plan.radius_u), around);
  ++contacts.queries;
  contacts.crowded += around.all_u < needed_u ? 1 : 0;
  return 0.0;
}

void WireVessel::findOf(
  const WirePlan& plan, int beam, const Axis& axis, double reach_u, WireContacts& contacts) noexcept
{
  const double needed_u = plan.radius_u + reach_u;
  const double moved_u = this->look(plan, beam, axis, needed_u, contacts);
  const Around& around = this->around_[beam];
  contacts.away_u[beam] = std::max(std::min(needed_u, around.all_u - moved_u), 0.0);
  const SurfaceData& vessel = plan.vessel->data();
  int count = 0;
  for (int i = 0; i < around.count && around.near[i].away_u - moved_u <= needed_u; ++i)
  {
    const std::uint32_t triangle = around.near[i].triangle;
    const std::array<Vec3, 3> corners = vessel.cornersOf(triangle);
    if (beyondPlane(axis.first_M, axis.second_M, corners[0], vessel.plane(triangle).normal_W) <= needed_u &&
        leastAway(axis.first_M, axis.second_M, corners) <= needed_u)
    {
      this->corners_[count++] = corners;
    }
  }
  const auto each = [this, count](const auto& take)
  { std::for_each(this->corners_.begin(), this->corners_.begin() + count, take); };
  Nearest nearest;
  NearestOfBeam{ plan.radius_u, reach_u, beam, axis.first_M, axis.second_M, axis.from }.find(
    each, nearest, contacts.away_u[beam]);
  addNearest(plan.radius_u, reach_u, nearest, contacts);
}

void WireVessel::find(const WirePlan& plan, const WirePlaces& places_M, double reach_u, WireContacts& contacts) noexcept
{
  contacts.count = contacts.queries = contacts.crowded = 0;
  for (int beam = 0; beam < plan.wire.count; ++beam)
  {
    const Vec3 &a = places_M[beam].p, &b = places_M[beam + 1].p;
    contacts.away_u[beam] = std::numeric_limits<double>::infinity();
    // Behind the mouth and on the axis a beam is in the sheath; one that has come back beside it is not.
    const bool clips = a.x() < 0.0;
    if (clips && b.x() <= 0.0)
    {
      continue;
    }
    const double from = clips ? -a.x() / (b.x() - a.x()) : 0.0;
    if (from < 1.0 - leastOutside)
    {
      this->findOf(plan, beam, { a + from * (b - a), b, from }, reach_u, contacts);
    }
  }
}

} // namespace palpate
