// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/wire/BeamContacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/geometry/tree/SurfaceData.h"
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
/// Of the radius: a node touches a second wall of much the same direction within that distance.
constexpr double almost = 0.02;
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
  const auto key = [](const WireContact& c)
  {
    const Vec3 &at = c.at_M, &n = c.normal_M;
    return std::array{ at.x(), at.y(), at.z(), c.share, n.x(), n.y(), n.z() };
  };
  return a.gap_u != b.gap_u ? a.gap_u < b.gap_u : key(a) < key(b);
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

void add(const WireContact& contact, double reach_u, WireContacts& contacts) noexcept
{
  if (contact.gap_u <= reach_u)
  {
    contacts.all[contacts.count++] = contact;
  }
}

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

/// No place of a plane is nearer to the segment from a to b.
double beyondPlane(const Vec3& a, const Vec3& b, const Vec3& on, const Vec3& normal) noexcept
{
  const double first_u = normal.dot(a - on), second_u = normal.dot(b - on);
  return first_u * second_u > 0.0 ? std::min(std::abs(first_u), std::abs(second_u)) : 0.0;
}

/// One search.
class BeamSearch
{
public:
  BeamSearch(const BeamPlace& beam, const BeamTriangles& near, BeamScratch& room) noexcept
    : beam_(beam), near_(near), room_(room), needed_u_(beam.radius_u + beam.reach_u)
  {
    room.ends = room.betweens = 0;
    std::ranges::for_each(this->nearest_.end, isFar);
    std::ranges::for_each(this->nearest_.between, isFar);
  }

  void run(WireContacts& contacts, double& nodeAway_u) noexcept
  {
    double& away_u = contacts.away_u[this->beam_.beam];
    this->lookAtFirst(nodeAway_u, away_u);
    nodeAway_u = this->lookAtSecond(away_u);
    this->lookBetween(away_u);
    for (int i = 1; i < 3 && this->nearest_.end[i - 1].gap_u <= this->beam_.reach_u; ++i)
    {
      this->takeOtherEnd(i);
    }
    if (this->nearest_.between[0].gap_u <= this->beam_.reach_u)
    {
      this->takeOtherBetween();
      this->takeFarEnd(contacts);
    }
    contacts.looked += this->looked_;
    addNearest(this->beam_.radius_u, this->beam_.reach_u, this->nearest_, contacts);
  }

private:
  static void isFar(WireContact& c) noexcept { c.gap_u = std::numeric_limits<double>::infinity(); }

  [[nodiscard]] WireContact endAt(const Vec3& wall_M) const noexcept
  {
    return contactAt(this->beam_.beam, 1.0, this->beam_.second_M, wall_M, this->beam_.radius_u);
  }

  [[nodiscard]] WireContact betweenAt(const SegmentPair& pair) const noexcept
  {
    const BeamPlace& b = this->beam_;
    return contactAt(b.beam, b.from + pair.along * (1.0 - b.from), b.first_M + pair.along * (b.second_M - b.first_M),
      pair.on, b.radius_u);
  }

  [[nodiscard]] bool isWithin(const BeamTriangle& t) noexcept
  {
    ++this->looked_;
    return awayFromTriangle(this->beam_.first_M, this->beam_.second_M, t.corner_M) <= this->needed_u_;
  }

  void lookAtFirst(double known_u, double& away_u) noexcept
  {
    away_u = std::min(away_u, known_u);
    for (int i = 0; i < this->near_.count && std::isnan(known_u); ++i)
    {
      const BeamTriangle& t = this->near_.all[i];
      if (t.first_u <= away_u)
      {
        ++this->looked_;
        const auto& c = t.corner_M;
        const Vec3& first_M = this->beam_.first_M;
        away_u = std::min(away_u, (nearestOnTriangle(first_M, c[0], c[1], c[2]) - first_M).norm());
      }
    }
  }

  /// The answer: distance of the wall from the second node, where some wall is within reach of it.
  double lookAtSecond(double& away_u) noexcept
  {
    const Vec3& second_M = this->beam_.second_M;
    double nodeAway_u = std::numeric_limits<double>::infinity();
    for (int i = 0; i < this->near_.count; ++i)
    {
      const BeamTriangle& t = this->near_.all[i];
      if (t.second_u > this->needed_u_ + almost * this->beam_.radius_u)
      {
        continue;
      }
      ++this->looked_;
      const Vec3 wall_M = nearestOnTriangle(second_M, t.corner_M[0], t.corner_M[1], t.corner_M[2]);
      const WireContact end = this->endAt(wall_M);
      nodeAway_u = std::min(nodeAway_u, (wall_M - second_M).norm());
      away_u = std::min(away_u, end.gap_u + this->beam_.radius_u);
      const bool counts = end.gap_u <= this->beam_.reach_u + almost * this->beam_.radius_u;
      if (end.gap_u <= this->beam_.reach_u || (counts && this->isWithin(t)))
      {
        this->room_.end[this->room_.ends++] = end;
        this->nearest_.end[0] = isNearer(end, this->nearest_.end[0]) ? end : this->nearest_.end[0];
      }
    }
    return nodeAway_u;
  }

  /// Those of the least bounds first, so that most of the others are too far away.
  void lookBetween(double& away_u) noexcept
  {
    const auto begin = this->near_.all.begin(), end = begin + this->near_.count;
    double least_u = std::numeric_limits<double>::infinity();
    std::for_each(begin, end, [&](const BeamTriangle& t) { least_u = std::min(least_u, t.away_u); });
    const double soon_u = least_u + almost * this->beam_.radius_u;
    for (const bool soon : { true, false })
    {
      for (auto t = begin; t != end; ++t)
      {
        if ((t->away_u <= soon_u) == soon && this->mayCount(*t))
        {
          this->lookAtEdges(*t, away_u);
        }
      }
    }
  }

  [[nodiscard]] double pressing_u() const noexcept { return this->beam_.radius_u * (1.0 + 2.0 * almost); }

  /// Whether an edge can be the nearest one, or nearly touch the wire.
  [[nodiscard]] bool mayCount(const BeamTriangle& t) const noexcept
  {
    const BeamPlace& b = this->beam_;
    const double nearest_u = std::min(this->needed_u_, this->nearest_.between[0].gap_u + b.radius_u);
    const double most_u = std::max(nearest_u, this->pressing_u());
    return t.away_u <= most_u && beyondPlane(b.first_M, b.second_M, t.corner_M[0], *t.normal_M) <= most_u;
  }

  void lookAtEdges(const BeamTriangle& t, double& away_u) noexcept
  {
    const BeamPlace& b = this->beam_;
    WireContact& nearest = this->nearest_.between[0];
    ++this->looked_;
    for (int k = 0; k < 3; ++k)
    {
      if ((t.owned & ownsEdge0 << k) == 0)
      {
        continue; // no further away than the edge is the other triangle, which is looked at, too
      }
      const SegmentPair pair = nearestOfSegments(b.first_M, b.second_M, t.corner_M[k], t.corner_M[(k + 1) % 3]);
      away_u = std::min(away_u, pair.away_u);
      if (!(pair.along > inside && pair.along < 1.0 - inside))
      {
        continue;
      }
      if (pair.away_u - b.radius_u <= nearest.gap_u)
      {
        const WireContact between = this->betweenAt(pair);
        nearest = isNearer(between, nearest) ? between : nearest;
      }
      if (pair.away_u <= this->pressing_u())
      {
        this->room_.between[this->room_.betweens++] = pair;
      }
    }
  }

  void takeOtherEnd(int i) noexcept
  {
    Nearest& nearest = this->nearest_;
    for (int k = 0; k < this->room_.ends; ++k)
    {
      const WireContact& end = this->room_.end[k];
      nearest.end[i] = isOther(end, nearest.end, i) && isNearer(end, nearest.end[i]) ? end : nearest.end[i];
    }
  }

  /// Of those that nearly touch: others do not count.
  void takeOtherBetween() noexcept
  {
    Nearest& nearest = this->nearest_;
    for (int k = 0; k < this->room_.betweens; ++k)
    {
      const WireContact other = this->betweenAt(this->room_.between[k]);
      const bool counts = isOther(other, nearest.between, 1) && isNearer(other, nearest.between[1]);
      nearest.between[1] = counts ? other : nearest.between[1];
    }
  }

  /// Where a straight wall leads away from the beam, its place at the second node is out of reach.
  void takeFarEnd(const WireContacts& contacts) noexcept
  {
    const bool before = contacts.count > 0 && contacts.all[contacts.count - 1].beam == this->beam_.beam - 1;
    WireContact& nearest = this->nearest_.end[0];
    for (int i = 0; i < this->near_.count && before && this->room_.ends == 0; ++i)
    {
      const BeamTriangle& t = this->near_.all[i];
      if (t.second_u <= nearest.gap_u + this->beam_.radius_u && this->isWithin(t))
      {
        const auto& c = t.corner_M;
        const WireContact end = this->endAt(nearestOnTriangle(this->beam_.second_M, c[0], c[1], c[2]));
        nearest = isNearer(end, nearest) ? end : nearest;
      }
    }
  }

  const BeamPlace& beam_;
  const BeamTriangles& near_;
  BeamScratch& room_;
  double needed_u_;
  Nearest nearest_;
  int looked_ = 0;
};

} // namespace

void addContactsOfBeam(const BeamPlace& beam, const BeamTriangles& near, BeamScratch& room, WireContacts& contacts,
  double& nodeAway_u) noexcept
{
  BeamSearch(beam, near, room).run(contacts, nodeAway_u);
}

} // namespace palpate
