// SPDX-License-Identifier: GPL-3.0-or-later
// Effect of a turn by a right angle or a mirror. Either is exact: coordinates change places and signs.
//
// Mirrors in y and z keep the order of the vertices, which is by x where no two are the same, and so nearly every
// operand of every operation but for its sign. The others change which corner a triangle is computed from and the order
// of sums: there exact predicates stay the same, and computed numbers stay the same to rounding.
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include <gtest/gtest.h>

#include "haptics/contact/GodObject.h"
#include "testing/support/Anywhere.h"
#include "testing/support/Families.h"
#include "testing/support/FeatureHand.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

/// A turn by right angles, a mirror, or both.
struct Turn
{
  std::array<int, 3> from{ 0, 1, 2 }; ///< which coordinate each one is
  std::array<double, 3> sign{ 1.0, 1.0, 1.0 };

  [[nodiscard]] Vec3 operator()(const Vec3& v) const
  {
    return { this->sign[0] * v[this->from[0]], this->sign[1] * v[this->from[1]], this->sign[2] * v[this->from[2]] };
  }
  [[nodiscard]] TriangleMesh operator()(TriangleMesh mesh) const
  {
    for (Vec3& v : mesh.vertices_W)
    {
      v = (*this)(v);
    }
    return mesh;
  }
};

std::vector<Turn> allTurns()
{
  std::vector<Turn> turns;
  std::array<int, 3> from{ 0, 1, 2 };
  do
  {
    for (int signs = 0; signs < 8; ++signs)
    {
      turns.push_back({ from, { signs & 1 ? -1.0 : 1.0, signs & 2 ? -1.0 : 1.0, signs & 4 ? -1.0 : 1.0 } });
    }
  } while (std::next_permutation(from.begin(), from.end()));
  return turns;
}

ContactPlan planOf(std::uint64_t round, double triangle_u, Random& random)
{
  ContactPlan plan;
  plan.radius_u = round % 2 == 0 ? 0.0 : random.uniform(0.01, 0.5) * triangle_u;
  plan.friction = round % 4 < 2 ? FrictionPlan{} : FrictionPlan{ 0.6, 0.4 };
  return plan;
}

/// So that no tie decides anything.
TriangleMesh someMesh(std::uint64_t round, Random& random)
{
  return Anywhere(random, 1.0)(families()[round % (families().size() - 1)].make(random)); // all but Scales
}

/// Differences by a turn in ticks that begin in the same place.
struct Changes
{
  std::uint64_t ticks = 0, held = 0;
  std::uint64_t inBits = 0;        ///< those whose end differs at all
  std::uint64_t pointsInPlace = 0; ///< by more than rounding, of points without friction
  std::uint64_t ballsInPlace = 0;  ///< the same of balls
  std::uint64_t roughInPlace = 0;  ///< the same of both under friction
};

/// One of the turns, and the same hand, on each of many surfaces.
Changes changesBy(const std::vector<Turn>& turns, std::uint64_t seed)
{
  Changes changes;
  const std::uint64_t meshes = testMeshes(44);
  for (std::uint64_t round = 0; round < meshes; ++round)
  {
    Random random(seed + 1000003 * round);
    const TriangleMesh mesh = someMesh(round, random);
    FeatureHand hand(mesh, random.next());
    const ContactPlan plan = planOf(round, hand.triangle_u(), random);
    const Turn turn = turns[random.below(static_cast<std::uint32_t>(turns.size()))];
    const auto scene = sceneOf(mesh), turnedScene = sceneOf(turn(mesh));
    for (std::uint64_t i = 0; i < testCount(22000) / meshes; ++i)
    {
      GodObjectState state, turned;
      const Vec3 p_W = hand.next();
      static_cast<void>(moveGodObject(*scene, plan, hand.outside_W(), state));
      static_cast<void>(moveGodObject(*turnedScene, plan, turn(hand.outside_W()), turned));
      const ContactResult felt = moveGodObject(*scene, plan, p_W, state);
      const ContactResult other = moveGodObject(*turnedScene, plan, turn(p_W), turned);
      if (felt.capped || other.capped)
      {
        continue;
      }
      ++changes.ticks;
      changes.held += state.x_W != p_W;
      changes.inBits += turned.x_W != turn(state.x_W);
      const bool rough = !plan.friction.none();
      std::uint64_t& inPlace =
        rough ? changes.roughInPlace : (plan.radius_u > 0.0 ? changes.ballsInPlace : changes.pointsInPlace);
      inPlace += (turned.x_W - turn(state.x_W)).norm() > 1e-9 * hand.size_u();
    }
  }
  std::cout << changes.ticks << " ticks, " << changes.held << " held; changed in bits " << changes.inBits
            << ", in place: points " << changes.pointsInPlace << ", balls " << changes.ballsInPlace
            << ", under friction " << changes.roughInPlace << std::endl;
  return changes;
}

TEST(Turned, MirrorsThatKeepTheOrderOfVerticesChangeNoPlace)
{
  const std::array<int, 3> same{ 0, 1, 2 };
  const Changes changes =
    changesBy({ { same, { 1, -1, 1 } }, { same, { 1, 1, -1 } }, { same, { 1, -1, -1 } } }, testSeed(2901));
  EXPECT_EQ(changes.pointsInPlace + changes.ballsInPlace + changes.roughInPlace, 0u);
}

// A point that meets a spike may go round it on either side, and friction holds it wherever it came to first: there
// rounding decides, and a turn is another rounding.
TEST(Turned, EveryTurnAndMirrorIsFeltTheSameButForTies)
{
  const Changes changes = changesBy(allTurns(), testSeed(2902));
  EXPECT_LE(changes.pointsInPlace + changes.ballsInPlace, changes.ticks / 1000);
}

} // namespace
} // namespace palpate::test
