// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of a wire from lists that are kept, against a search that keeps nothing and looks at every triangle.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/mechanism/wire/SegmentDistance.h"
#include "haptics/mechanism/wire/WireVessel.h"
#include "testing/support/Random.h"
#include "testing/support/WireTube.h"

namespace palpate::test
{
namespace
{

constexpr double far_mm = std::numeric_limits<double>::infinity();
/// Normals of two walls, no two nearest places of one; as the rules of contacts have them.
constexpr double oneWall = 0.99996, nearly = 0.02, bulge = 1e-6, atNode = 1e-3;

auto orderOf(const WireContact& c)
{
  const Vec3& n = c.normal_M;
  return std::tuple(c.gap_u, c.at_M.x(), c.at_M.y(), c.at_M.z(), c.share, n.x(), n.y(), n.z());
}

auto bitsOf(const WireContact& c)
{
  return std::tuple(
    c.beam, c.share, c.gap_u, c.at_M.x(), c.at_M.y(), c.at_M.z(), c.normal_M.x(), c.normal_M.y(), c.normal_M.z());
}

/// The contacts of one beam by all triangles.
class PlainSearch
{
public:
  PlainSearch(const WirePlan& plan, double reach_mm) : plan_(plan), reach_mm_(reach_mm) {}

  std::vector<WireContact> contacts;
  std::vector<double> away_mm;

  void run(const WirePlaces& places_M)
  {
    const auto isOut = [](const Pose& node) { return node.p.x() > 0.0; };
    const auto nodes = this->plan_.wire.nodes();
    const auto out = std::find_if(places_M.begin(), places_M.begin() + nodes, isOut) - places_M.begin();
    for (int b = 0; b < this->plan_.wire.count; ++b)
    {
      const Vec3 &a = places_M[b].p, &c = places_M[b + 1].p;
      const bool inside = b + 1 < out || (b < out && c.x() <= 0.0);
      const double from = b < out ? -a.x() / (c.x() - a.x()) : 0.0;
      this->away_mm.push_back(far_mm);
      if (!inside && from < 1.0 - 1e-6)
      {
        this->away_mm.back() = this->plan_.radius_u + this->reach_mm_;
        this->beam(b, a + from * (c - a), c, from);
      }
    }
  }

private:
  [[nodiscard]] WireContact at(int beam, double share, const Vec3& axis, const Vec3& wall) const
  {
    const Vec3 off = axis - wall;
    return { beam, share, off.norm() - this->plan_.radius_u, wall, off / off.norm() };
  }

  void beam(int b, const Vec3& first, const Vec3& second, double from)
  {
    std::vector<WireContact> ends, betweens;
    const SurfaceData& vessel = this->plan_.vessel->data();
    const double r = this->plan_.radius_u;
    for (std::uint32_t t = 0; t < vessel.mesh.triangles.size(); ++t)
    {
      const auto corner = vessel.cornersOf(t);
      if (awayFromTriangle(first, second, corner) > r + this->reach_mm_)
      {
        continue;
      }
      double& away = this->away_mm.back();
      ends.push_back(this->at(b, 1.0, second, nearestOnTriangle(second, corner[0], corner[1], corner[2])));
      away = std::min(
        { away, ends.back().gap_u + r, (nearestOnTriangle(first, corner[0], corner[1], corner[2]) - first).norm() });
      for (int k = 0; k < 3; ++k)
      {
        if ((vessel.plane(t).owned & ownsEdge0 << k) == 0)
        {
          continue; // the other triangle's: from its other end the same edge has other last bits
        }
        const SegmentPair pair = nearestOfSegments(first, second, corner[k], corner[(k + 1) % 3]);
        away = std::min(away, pair.away_u);
        if (pair.along > atNode && pair.along < 1.0 - atNode)
        {
          betweens.push_back(
            this->at(b, from + pair.along * (1.0 - from), first + pair.along * (second - first), pair.on));
        }
      }
    }
    this->choose(this->pick(ends, 3), this->pick(betweens, 2));
  }

  /// The nearest one, then the nearest one of another wall while the one before is within reach.
  [[nodiscard]] std::vector<WireContact> pick(std::vector<WireContact>& all, std::size_t most) const
  {
    std::ranges::sort(all, [](const auto& a, const auto& b) { return orderOf(a) < orderOf(b); });
    std::vector<WireContact> picked;
    for (const WireContact& c : all)
    {
      const bool other =
        std::ranges::all_of(picked, [&](const auto& p) { return p.normal_M.dot(c.normal_M) < oneWall; });
      const bool more = picked.empty() || picked.back().gap_u <= this->reach_mm_;
      if (picked.size() < most && other && more)
      {
        picked.push_back(c);
      }
    }
    return picked;
  }

  [[nodiscard]] bool isOnStraightWall(const WireContact& between, const std::vector<WireContact>& ends) const
  {
    return std::ranges::any_of(this->contacts,
      [&](const WireContact& before)
      {
        const double line_mm = (1.0 - between.share) * before.gap_u + between.share * ends[0].gap_u;
        return before.beam == between.beam - 1 && before.share == 1.0 &&
               before.normal_M.dot(between.normal_M) > oneWall && ends[0].normal_M.dot(between.normal_M) > oneWall &&
               between.gap_u >= line_mm - bulge * this->plan_.radius_u;
      });
  }

  void choose(const std::vector<WireContact>& ends, const std::vector<WireContact>& betweens)
  {
    const double r = this->plan_.radius_u;
    std::vector<WireContact> chosen;
    for (std::size_t i = 0; i < betweens.size(); ++i)
    {
      const double most_mm = i == 0 ? this->reach_mm_ : nearly * r;
      const bool second = !chosen.empty(); // beside another one it stays, also on a straight wall
      if (betweens[i].gap_u <= most_mm && (second || !this->isOnStraightWall(betweens[i], ends)))
      {
        chosen.push_back(betweens[i]);
      }
    }
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      const double turns = ends[0].normal_M.cross(ends[i].normal_M).norm();
      const bool opposite = ends[0].normal_M.dot(ends[i].normal_M) < 0.0;
      const double most_mm = i == 0 || opposite ? this->reach_mm_ : turns * this->reach_mm_ + nearly * r;
      if (ends[i].gap_u <= most_mm)
      {
        chosen.push_back(ends[i]);
      }
    }
    this->contacts.insert(this->contacts.end(), chosen.begin(), chosen.end());
  }

  const WirePlan& plan_;
  double reach_mm_;
};

void expectBitsOfPlain(const WirePlan& plan, const WirePlaces& places_M, double reach_mm, const WireContacts& found)
{
  PlainSearch plain(plan, reach_mm);
  plain.run(places_M);
  ASSERT_EQ(found.crowded, 0);
  ASSERT_EQ(found.count, static_cast<int>(plain.contacts.size()));
  for (int i = 0; i < found.count; ++i)
  {
    ASSERT_EQ(bitsOf(found.all[i]), bitsOf(plain.contacts[i])) << i;
  }
  for (int b = 0; b < plan.wire.count; ++b)
  {
    ASSERT_EQ(found.away_u[b], plain.away_mm[b]) << b;
  }
}

constexpr double perTick_mm = 0.1; // a tick: .1 m/s

TEST(WireVessel, PushedTurnedAndPulledItsContactsAreBitForBitThoseOfAllTriangles)
{
  WireDescription bent = nitinolWire(80.0, 20, 0.1);
  bent.shape.tip = WireTip::Angled;
  bent.shape.tip_u = 8.0;
  const Tube tube{ .first_mm = 12.0, .angle_rad = 0.5 * std::numbers::pi, .last_mm = 10.0, .around = 16 };
  PushedWire wire(bent, tube.mesh());
  wire.turning_Nmm_per_rad = 0.5;
  const auto kept = std::make_unique<WireVessel>();
  const auto found = std::make_unique<WireContacts>();
  int most = 0;
  constexpr int pushed = 380, turned = 150, pulled = 300;
  for (int i = 0; i < pushed + turned + pulled; ++i)
  {
    const int out = std::min(i, pushed) - std::max(i - pushed - turned, 0);
    static_cast<void>(wire.tick(perTick_mm * out, 0.02 * std::clamp(i - pushed, 0, turned)));
    const double reach_mm = i % 10 == 9 ? 0.3 : 0.15;
    const WirePlaces& places_M = wire.ticks.state().places_M;
    kept->find(*wire.planned.plan, places_M, { reach_mm, reach_mm }, *found);
    most = std::max(most, found->count);
    if (i % 3 == 0)
    {
      ASSERT_NO_FATAL_FAILURE(expectBitsOfPlain(*wire.planned.plan, places_M, reach_mm, *found)) << i;
    }
  }
  EXPECT_GT(most, 20);
}

/// In the middle of four walls that mirror one another.
TEST(WireVessel, OfPlacesThatAreAllAsNearItTakesTheSmallestOne)
{
  const PushedWire wire(nitinolWire(20.0, 5, 0.0), Tube{ .first_mm = 25.0, .around = 4 }.mesh());
  WirePlaces places_M{};
  for (int i = 0; i <= 5; ++i)
  {
    places_M[i].p = Vec3(0.5 + 4.0 * i, 0.0, 0.0);
  }
  const auto kept = std::make_unique<WireVessel>();
  const auto found = std::make_unique<WireContacts>();
  kept->find(*wire.planned.plan, places_M, { 0.55, 0.55 }, *found);
  EXPECT_GT(found->count, 5);
  ASSERT_NO_FATAL_FAILURE(expectBitsOfPlain(*wire.planned.plan, places_M, 0.55, *found));
}

/// Nodes at random in the part of a straight tube of flat walls where no beam goes through one.
struct RandomNodes
{
  const Tube& tube;
  Random& random;
  double along_mm = 0.0;
  std::array<Vec3, 6> off{};

  WirePlaces move()
  {
    const double most_mm = 0.99 * this->tube.radius_mm * std::cos(std::numbers::pi / this->tube.around);
    const bool jump = this->random.below(8) == 0;
    const double last_mm = this->tube.first_mm - 1e-3;
    this->along_mm = std::clamp(this->along_mm + this->random.uniform(-0.4, 0.7), -9.0, last_mm - 20.0);
    WirePlaces places_M{};
    for (int i = 0; i <= 5; ++i)
    {
      Vec3& o = this->off[i];
      o = jump ? Vec3(2.0 * most_mm * this->random.direction()) : Vec3(o + this->random.inCube(0.02));
      o.x() = 0.0;
      o *= std::min(1.0, most_mm / std::max(o.norm(), 1e-9));
      places_M[i].p = Vec3(this->along_mm + 4.0 * i, o.y(), o.z());
    }
    return places_M;
  }
};

TEST(WireVessel, ForNodesAtRandomInStraightTubesItsContactsAreThoseOfAllTriangles)
{
  Random random(testSeed(41));
  const auto found = std::make_unique<WireContacts>();
  const auto kept = std::make_unique<WireVessel>();
  int contacts = 0;
  for (std::size_t k = 0; k < testCount(60); ++k)
  {
    const Tube tube{ .radius_mm = k % 2 == 0 ? 1.0 : 4.0,
      .first_mm = 14.0,
      .blind = true,
      .around = 4 + static_cast<int>(random.below(9)),
      .ring_mm = k % 3 == 0 ? 19.0 : 1.0 };
    const PushedWire wire(nitinolWire(20.0, 5, 0.0), tube.mesh());
    RandomNodes nodes{ tube, random };
    kept->forget();
    for (int i = 0; i < 60; ++i)
    {
      const WirePlaces places_M = nodes.move();
      const double reach_mm = random.uniform(0.1, 0.4);
      kept->find(*wire.planned.plan, places_M, { reach_mm, reach_mm }, *found);
      ASSERT_NO_FATAL_FAILURE(expectBitsOfPlain(*wire.planned.plan, places_M, reach_mm, *found)) << k << " " << i;
      contacts += found->count;
    }
  }
  EXPECT_GT(contacts, 1000);
}

/// Two triangles of a flat wall, 5 mm behind the mouth to 14 mm before it, whose diagonal the wire crosses at 4.5 mm.
/// The diagonal is nearer to the beam from 4 to 8 mm than its second node is, but not nearer than the line between
/// both.
TEST(WireVessel, AlongAStraightWallOnlyNodesTouchAlsoWhereTheNextOneIsOutOfReach)
{
  const PushedWire wire(
    nitinolWire(20.0, 5, 0.0), Tube{ .radius_mm = 4.0, .first_mm = 14.0, .around = 4, .ring_mm = 19.0 }.mesh());
  constexpr double wall_mm = 4.0 * std::numbers::sqrt2 / 2.0, reach_mm = 0.103;
  constexpr std::array gap_mm{ 0.08, 0.09, 0.1, 0.11, 0.12, 0.13 };
  WirePlaces places_M{};
  for (int i = 0; i <= 5; ++i)
  {
    const double off_mm = (wall_mm - wire.planned.plan->radius_u - gap_mm[i]) * std::numbers::sqrt2 / 2.0;
    places_M[i].p = Vec3(4.0 * (i - 1), off_mm, off_mm);
  }
  const auto kept = std::make_unique<WireVessel>();
  const auto found = std::make_unique<WireContacts>();
  kept->find(*wire.planned.plan, places_M, { reach_mm, reach_mm }, *found);
  ASSERT_EQ(found->count, 1);
  EXPECT_EQ(found->all[0].beam, 1);
  EXPECT_EQ(found->all[0].share, 1.0);
  EXPECT_NEAR(found->all[0].gap_u, 0.1, 1e-12);
  ASSERT_NO_FATAL_FAILURE(expectBitsOfPlain(*wire.planned.plan, places_M, reach_mm, *found));
}

/// A wire of 64 beams that slides through a bend of 19,000 triangles.
struct Slide
{
  static constexpr int ticks = 1700;

  PushedWire wire{ nitinolWire(250.0, 64, 0.1),
    Tube{ .angle_rad = 0.75 * std::numbers::pi, .last_mm = 60.0, .around = 24, .ring_mm = 0.5 }.mesh() };

  const WireResult& tick(int i) { return this->wire.tick(perTick_mm * i); }
};

TEST(WireVessel, AnswersDoNotDependOnTheQuestionsBefore)
{
  Slide slide;
  const auto kept = std::make_unique<WireVessel>(), fresh = std::make_unique<WireVessel>();
  const auto found = std::make_unique<WireContacts>(), again = std::make_unique<WireContacts>();
  for (int i = 0; i < Slide::ticks; ++i)
  {
    static_cast<void>(slide.tick(i));
    const WirePlaces& places_M = slide.wire.ticks.state().places_M;
    kept->find(*slide.wire.planned.plan, places_M, { 0.15, 0.15 }, *found);
    if (i % 5 == 0)
    {
      fresh->forget();
      fresh->find(*slide.wire.planned.plan, places_M, { 0.15, 0.15 }, *again);
      ASSERT_EQ(found->count, again->count) << i;
      ASSERT_EQ(found->away_u, again->away_u) << i;
      for (int k = 0; k < found->count; ++k)
      {
        ASSERT_EQ(bitsOf(found->all[k]), bitsOf(again->all[k])) << i;
      }
    }
  }
}

TEST(WireVessel, ATickAsksTheTreeForAFewBeamsAndLooksAtFewTriangles)
{
  Slide slide;
  std::vector<int> queries, looked;
  for (int i = 0; i < Slide::ticks; ++i)
  {
    const WireResult& result = slide.tick(i);
    queries.push_back(result.queries);
    looked.push_back(result.looked);
  }
  std::ranges::sort(queries);
  std::ranges::sort(looked);
  constexpr int half = Slide::ticks / 2, most = 99 * Slide::ticks / 100;
  RecordProperty("queries", std::to_string(queries[half]) + " " + std::to_string(queries[most]));
  RecordProperty("looked", std::to_string(looked[half]) + " " + std::to_string(looked[most]));
  EXPECT_LE(queries[half], 5);
  EXPECT_LE(queries[most], 10);
  EXPECT_LE(looked[half], 1200);
  EXPECT_LE(looked[most], 4000) << "two steps of 60 beams: 33 for each";
  EXPECT_GT(looked[half], 100);
}

} // namespace
} // namespace palpate::test
