// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/wire/WireVessel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/core/Across.h"
#include "haptics/geometry/tree/TreeWalk.h"

namespace palpate
{
namespace
{

/// Of a beam: a list goes on so much further along its line than is needed.
constexpr double beyond = 0.6;
/// Of the radius: likewise across its line.
constexpr double aside = 0.5;
/// Of the radius: a list with no more left is renewed where no other one had to be.
constexpr double soon = 3.0;
/// Of a beam: less of it outside of the sheath has no direction.
constexpr double leastOutside = 1e-6;

constexpr float down = 1.0F - 1e-6F;

/// A line, and the part of it that is asked about.
struct Line
{
  const Vec3& from_M;
  const Vec3& along_M;
  std::array<Vec3, 2> across_M; ///< at right angles to it and to each other
  double low_u;
  double high_u;
};

struct LineBounds
{
  double away_u;
  double low_u;
  double high_u;
};

using Vec2 = Eigen::Vector2d;

/// Squared distance of the origin from the segment between two places of a plane through it.
double awayFromEdge2(const Vec2& a, const Vec2& b) noexcept
{
  const Vec2 edge = b - a;
  const double length2 = edge.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp(-a.dot(edge) / length2, 0.0, 1.0) : 0.0;
  return (a + share * edge).squaredNorm();
}

/// Whether a place of the ball around the box may be so near to the line.
bool mayBeNear(const Line& line, const Box& box, double reach_u) noexcept
{
  const Vec3 there = 0.5 * (box.low_W + box.high_W) - line.from_M;
  const double ball_u = 0.5 * (box.high_W - box.low_W).norm();
  const double along_u = line.along_M.dot(there);
  const double least_u = reach_u + ball_u;
  return (there - along_u * line.along_M).squaredNorm() <= least_u * least_u && along_u >= line.low_u - ball_u &&
         along_u <= line.high_u + ball_u;
}

/// Distance of a triangle from the whole line, and its interval along it; infinite where that is elsewhere.
LineBounds boundsOf(const Line& line, const std::array<Vec3, 3>& corner) noexcept
{
  const std::array<Vec3, 3> there{ corner[0] - line.from_M, corner[1] - line.from_M, corner[2] - line.from_M };
  const Vec3 along_u(line.along_M.dot(there[0]), line.along_M.dot(there[1]), line.along_M.dot(there[2]));
  LineBounds bounds{ std::numeric_limits<double>::infinity(), along_u.minCoeff(), along_u.maxCoeff() };
  if (bounds.low_u > line.high_u || bounds.high_u < line.low_u)
  {
    return bounds;
  }
  std::array<Vec2, 3> across;
  for (int k = 0; k < 3; ++k)
  {
    across[k] = Vec2(line.across_M[0].dot(there[k]), line.across_M[1].dot(there[k]));
  }
  double away2_u2 = std::numeric_limits<double>::infinity(), least = away2_u2, most = -away2_u2;
  for (int k = 0; k < 3; ++k)
  {
    const Vec2 &a = across[k], &b = across[(k + 1) % 3];
    const double turns = a.x() * b.y() - a.y() * b.x();
    least = std::min(least, turns);
    most = std::max(most, turns);
    away2_u2 = std::min(away2_u2, awayFromEdge2(a, b));
  }
  bounds.away_u = least >= 0.0 || most <= 0.0 ? 0.0 : std::sqrt(away2_u2);
  return bounds;
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

/// Keeps the nearest in a heap; the answer is the distance of the one that finds no room, or `all_u`.
template<class Near, std::size_t most>
void keep(const Near& near, int room, int& count, std::array<Near, most>& kept, double& all_u) noexcept
{
  const auto isNearer = [](const Near& a, const Near& b)
  { return a.away_u != b.away_u ? a.away_u < b.away_u : a.triangle < b.triangle; };
  const auto begin = kept.begin();
  if (count < room)
  {
    kept[count++] = near;
    std::push_heap(begin, begin + count, isNearer);
    return;
  }
  all_u = static_cast<double>(std::max(kept.front().away_u, near.away_u));
  if (isNearer(near, kept.front()))
  {
    std::pop_heap(begin, begin + count, isNearer);
    kept[count - 1] = near;
    std::push_heap(begin, begin + count, isNearer);
  }
}

Box boxAround(const Vec3& a, const Vec3& b, double reach_u) noexcept
{
  const Vec3 reach = Vec3::Constant(reach_u);
  return { a.cwiseMin(b) - reach, a.cwiseMax(b) + reach };
}

} // namespace

void WireVessel::forget() noexcept
{
  for (Around& around : this->around_)
  {
    around.known = around.crowded = false;
  }
}

WireVessel::Beside WireVessel::besideOf(const Around& around, const Axis& axis) noexcept
{
  const Vec3 first = axis.first_M - around.from_M, second = axis.second_M - around.from_M;
  Beside beside;
  beside.first_u = around.along_M.dot(first);
  beside.second_u = around.along_M.dot(second);
  beside.firstOff_u = (first - beside.first_u * around.along_M).norm();
  beside.secondOff_u = (second - beside.second_u * around.along_M).norm();
  return beside;
}

double WireVessel::leftOf(const Around& around, const Beside& beside, double needed_u) noexcept
{
  return std::min({ around.all_u - needed_u - std::max(beside.firstOff_u, beside.secondOff_u),
    std::min(beside.first_u, beside.second_u) - needed_u - around.low_u,
    around.high_u - needed_u - std::max(beside.first_u, beside.second_u) });
}

void WireVessel::askAroundLine(
  const WirePlan& plan, int beam, const Axis& axis, double needed_u, Around& around) noexcept
{
  const SurfaceData& vessel = plan.vessel->data();
  const Vec3 way = axis.second_M - axis.first_M;
  const double length_u = way.norm(), on_u = needed_u + beyond * plan.wire.beams[beam].length_u;
  around.known = true;
  around.count = 0;
  around.from_M = axis.first_M;
  around.along_M = way / length_u;
  around.low_u = -on_u;
  around.high_u = length_u + on_u;
  around.all_u = needed_u + aside * plan.radius_u;
  const Line line{ around.from_M, around.along_M, tangentsOf(around.along_M), around.low_u, around.high_u };
  const auto visit = [&](std::uint32_t triangle)
  {
    const LineBounds bounds = boundsOf(line, vessel.cornersOf(triangle));
    if (bounds.away_u < around.all_u)
    {
      const double slack_u = 1e-6 * (std::abs(bounds.low_u) + std::abs(bounds.high_u) + around.high_u);
      const Near near{ triangle, down * static_cast<float>(bounds.away_u), static_cast<float>(bounds.low_u - slack_u),
        static_cast<float>(bounds.high_u + slack_u) };
      keep(near, mostKept, around.count, around.near, around.all_u);
    }
  };
  const Box box = boxAround(axis.first_M - on_u * around.along_M, axis.second_M + on_u * around.along_M, around.all_u);
  forEachMeeting(
    vessel, [&](const Box& other) { return overlap(box, other) && mayBeNear(line, other, around.all_u); }, visit);
}

bool WireVessel::gatherFromLine(
  const WirePlan& plan, int beam, const Axis& axis, double needed_u, WireContacts& contacts) noexcept
{
  Around& around = this->around_[beam];
  Beside beside = besideOf(around, axis);
  double left_u = leftOf(around, beside, needed_u);
  if (!around.known || !(left_u >= 0.0))
  {
    this->askAroundLine(plan, beam, axis, needed_u, around);
    beside = besideOf(around, axis);
    left_u = leftOf(around, beside, needed_u);
    ++contacts.queries;
  }
  this->looked_.count = 0;
  const SurfaceData& vessel = plan.vessel->data();
  if (left_u < this->leastLeft_u_)
  {
    this->leastLeft_u_ = left_u;
    this->soonest_ = beam;
  }
  const double off_u = std::max(beside.firstOff_u, beside.secondOff_u);
  const double low_u = std::min(beside.first_u, beside.second_u), high_u = std::max(beside.first_u, beside.second_u);
  bool fits = left_u >= 0.0;
  for (int i = 0; i < around.count && fits; ++i)
  {
    const Near& near = around.near[i];
    if (near.away_u > needed_u + off_u || near.low_u > high_u + needed_u || near.high_u < low_u - needed_u)
    {
      continue;
    }
    fits = this->looked_.count < BeamTriangles::most;
    if (fits)
    {
      const auto from = [&near](double off, double low, double high) {
        return std::max({ near.away_u - off, near.low_u - high, low - near.high_u });
      };
      const FacePlane& plane = vessel.plane(near.triangle);
      this->looked_.all[this->looked_.count++] = { vessel.cornersOf(near.triangle), &plane.normal_W, plane.owned,
        from(off_u, low_u, high_u), from(beside.firstOff_u, beside.first_u, beside.first_u),
        from(beside.secondOff_u, beside.second_u, beside.second_u) };
    }
  }
  return fits;
}

/// The nearest ones of the beam as it is.
double WireVessel::gatherAroundBeam(const WirePlan& plan, const Axis& axis, double needed_u, Around& around) noexcept
{
  const SurfaceData& vessel = plan.vessel->data();
  double all_u = needed_u;
  around.known = false;
  around.count = 0;
  const auto visit = [&](std::uint32_t triangle)
  {
    const std::array<Vec3, 3> corners = vessel.cornersOf(triangle);
    const double away_u = leastAway(axis.first_M, axis.second_M, corners) < all_u
                            ? awayFromTriangle(axis.first_M, axis.second_M, corners)
                            : std::numeric_limits<double>::infinity();
    if (away_u < all_u)
    {
      keep({ triangle, down * static_cast<float>(away_u), 0.0F, 0.0F }, BeamTriangles::most, around.count, around.near,
        all_u);
    }
  };
  const Box box = boxAround(axis.first_M, axis.second_M, needed_u);
  forEachMeeting(
    vessel, [&box](const Box& other) { return overlap(box, other); }, visit);
  this->looked_.count = around.count;
  for (int i = 0; i < around.count; ++i)
  {
    const Near& near = around.near[i];
    const double away_u = near.away_u;
    const FacePlane& plane = vessel.plane(near.triangle);
    this->looked_.all[i] = { vessel.cornersOf(near.triangle), &plane.normal_W, plane.owned, away_u, away_u, away_u };
  }
  return all_u;
}

void WireVessel::findOf(
  const WirePlan& plan, int beam, const Axis& axis, double reach_u, WireContacts& contacts) noexcept
{
  const double needed_u = plan.radius_u + reach_u;
  Around& around = this->around_[beam];
  double all_u = needed_u;
  if (around.crowded || !this->gatherFromLine(plan, beam, axis, needed_u, contacts))
  {
    all_u = this->gatherAroundBeam(plan, axis, needed_u, around);
    around.crowded = all_u < needed_u;
    ++contacts.queries;
    contacts.crowded += around.crowded ? 1 : 0;
    this->nodeAway_u_ = std::numeric_limits<double>::quiet_NaN();
  }
  contacts.away_u[beam] = all_u;
  addContactsOfBeam({ plan.radius_u, reach_u, beam, axis.first_M, axis.second_M, axis.from }, this->looked_,
    this->room_, contacts, this->nodeAway_u_);
  this->nodeAway_u_ = around.crowded ? std::numeric_limits<double>::quiet_NaN() : this->nodeAway_u_;
}

void WireVessel::find(
  const WirePlan& plan, const WirePlaces& places_M, const WireReach& reach, WireContacts& contacts) noexcept
{
  contacts.count = contacts.queries = contacts.looked = contacts.crowded = 0;
  this->leastLeft_u_ = std::numeric_limits<double>::infinity();
  this->nodeAway_u_ = std::numeric_limits<double>::quiet_NaN();
  bool inSheath = true;
  for (int beam = 0; beam < plan.wire.count; ++beam)
  {
    const Vec3 &a = places_M[beam].p, &b = places_M[beam + 1].p;
    contacts.away_u[beam] = std::numeric_limits<double>::infinity();
    // Up to the first node before the mouth a wire is in the sheath; beams that have come back beside it are not.
    inSheath = inSheath && a.x() <= 0.0;
    const bool clips = inSheath && a.x() < 0.0;
    if (clips)
    {
      this->nodeAway_u_ = std::numeric_limits<double>::quiet_NaN();
    }
    if (clips && b.x() <= 0.0)
    {
      continue;
    }
    const double from = clips ? -a.x() / (b.x() - a.x()) : 0.0;
    if (from < 1.0 - leastOutside)
    {
      const double reach_u = beam + 1 < plan.wire.count ? reach.shaft_u : reach.tip_u;
      this->findOf(plan, beam, { a + from * (b - a), b, from }, reach_u, contacts);
    }
  }
  if (contacts.queries == 0 && this->leastLeft_u_ < soon * plan.radius_u)
  {
    this->around_[this->soonest_].known = false;
  }
}

} // namespace palpate
