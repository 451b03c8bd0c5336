// SPDX-License-Identifier: GPL-3.0-or-later
// Where a tip comes into a body of tetrahedra, whose border has no outer side of its own. Judge: the box that the body
// is.
#include <array>

#include <gtest/gtest.h>

#include "haptics/mechanism/servo/TipPlace.h"
#include "haptics/session/soft/BodyMaker.h"
#include "testing/haptics/compliance/SoftPads.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

const Vec3 low_W(0.0, 0.0, 0.0), high_W(0.1, 0.1, 0.05); // of pad()

std::shared_ptr<const PressedBody> padAtRest()
{
  std::string refusal;
  const auto maker = BodyMaker::make(pad(6), "pad", 0, refusal);
  return maker ? maker->press({}, 0.0) : nullptr;
}

/// Where a straight segment enters the box, and the outer normal there.
std::pair<Vec3, Vec3> entryOf(const Vec3& from_W, const Vec3& to_W)
{
  double entry = 0.0;
  Vec3 normal_W = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    const double way = to_W[k] - from_W[k];
    const double at = ((way > 0.0 ? low_W : high_W)[k] - from_W[k]) / way;
    if (way != 0.0 && at > entry)
    {
      entry = at;
      normal_W = (way > 0.0 ? -1.0 : 1.0) * Vec3::Unit(k);
    }
  }
  return { from_W + entry * (to_W - from_W), normal_W };
}

Vec3 anyInside(Random& random)
{
  const Vec3 share(random.uniform(0.1, 0.9), random.uniform(0.1, 0.9), random.uniform(0.1, 0.9));
  return low_W + share.cwiseProduct(high_W - low_W);
}

} // namespace

TEST(TipPlace, ATipComesInWhereItsWayEntersTheBodyAndIsPushedOutThere)
{
  const auto body = padAtRest();
  ASSERT_TRUE(body);
  Random random(testSeed(2020));
  for (std::size_t i = 0; i < testCount(500); ++i)
  {
    const Vec3 to_W = anyInside(random), from_W = to_W + 0.3 * random.direction();
    ConstraintState state;
    ASSERT_TRUE(meetSurface(*body, from_W, to_W, state)) << i;
    const auto [entry_W, normal_W] = entryOf(from_W, to_W);
    EXPECT_LT((state.place_B.x_W - entry_W).norm(), 1e-9) << i;
    EXPECT_LT((state.normal_W - normal_W).norm(), 1e-9) << i;
  }
}

TEST(TipPlace, ATipThatIsInsideComesOutWithoutBeingMet)
{
  const auto body = padAtRest();
  ASSERT_TRUE(body);
  Random random(testSeed(2021));
  for (std::size_t i = 0; i < testCount(500); ++i)
  {
    const Vec3 from_W = anyInside(random);
    ConstraintState state;
    EXPECT_FALSE(meetSurface(*body, from_W, from_W + 0.3 * random.direction(), state)) << i;
  }
}

TEST(TipPlace, NoTipSlipsThroughAVertexOrAnEdge)
{
  const auto body = padAtRest();
  ASSERT_TRUE(body);
  const TriangleMesh& mesh = body->scene->surfaces()[body->touch.surface].tree->mesh();
  int onTop = 0;
  for (const auto& triangle : mesh.triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Vec3 &a_W = mesh.vertices_W[triangle[c]], &b_W = mesh.vertices_W[triangle[(c + 1) % 3]];
      for (const Vec3& p_W : { a_W, Vec3(0.5 * (a_W + b_W)) })
      {
        if (p_W.z() < high_W.z() || (p_W - Vec3(0.05, 0.05, 0.05)).cwiseAbs().maxCoeff() > 0.049)
        {
          continue; // beside the top, or on its rim
        }
        ConstraintState state;
        EXPECT_TRUE(meetSurface(*body, p_W + Vec3(0, 0, 0.02), p_W - Vec3(0, 0, 0.02), state)) << p_W.transpose();
        EXPECT_EQ(state.normal_W, Vec3::UnitZ()) << p_W.transpose();
        ++onTop;
      }
    }
  }
  EXPECT_GT(onTop, 0);
}

TEST(TipPlace, ATipSlidesAsFarAsTheSurfaceReachesAndNoFurther)
{
  const auto body = padAtRest();
  ASSERT_TRUE(body);
  Random random(testSeed(2022));
  for (std::size_t i = 0; i < testCount(500); ++i)
  {
    ConstraintState state;
    const Vec3 from_W = anyInside(random);
    ASSERT_TRUE(meetSurface(*body, Vec3(from_W.x(), from_W.y(), 0.1), from_W, state));
    const Vec3 aside_W(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0.0);
    const Vec3 to_W = state.place_B.x_W + aside_W;
    const bool on = (to_W - low_W).head<2>().minCoeff() > 0.0 && (high_W - to_W).head<2>().minCoeff() > 0.0;
    EXPECT_EQ(slideOnSurface(*body, aside_W, state), on) << i;
    EXPECT_LT((state.place_B.x_W - (on ? to_W : Vec3(to_W - aside_W))).norm(), 1e-9) << i;
    EXPECT_TRUE(!on || slideOnSurface(*body, Vec3::Zero(), state)) << "where it is, it stays";
  }
}

} // namespace palpate::test
