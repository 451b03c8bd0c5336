// SPDX-License-Identifier: GPL-3.0-or-later
// Simpler surfaces are looked for on another thread: only what was asked for last arrives, once.

#include <cstdint>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "testing/support/Meshes.h"
#include "vtkHapticSimplerScene.h"

using namespace palpate;

namespace
{
SimplifyRules Rules()
{
  SimplifyRules rules;
  rules.touch.scale_u_per_m = 1000.0;
  rules.leastTriangles = 0;
  return rules;
}

std::shared_ptr<const Scene> Sphere(double radius)
{
  return test::sceneOf(test::makeIcosphere(5, radius)); // 20,480 triangles
}

bool Follow(vtkHapticSimplerScene& simpler, const std::shared_ptr<const Scene>& scene, std::uint64_t revision)
{
  return simpler.Follow(scene, chooseAtFirst(*scene, {}, Rules()), Rules(), revision);
}
} // namespace

TEST(HapticSimplerScene, ArrivesOnceAndWithTheRevisionThatWasAskedFor)
{
  vtkHapticSimplerScene simpler;
  EXPECT_FALSE(simpler.Wait());
  EXPECT_FALSE(Follow(simpler, Sphere(50.0), 7));
  const auto found = simpler.Wait();
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->scene) << found->choices[0].reason;
  EXPECT_EQ(found->scene->revision(), 7u);
  EXPECT_GT(found->LargestRadius_u, 0.0);
  EXPECT_FALSE(simpler.Poll());
  EXPECT_FALSE(simpler.Wait());
}

TEST(HapticSimplerScene, OfManyOrdersOnlyTheLastArrives)
{
  vtkHapticSimplerScene simpler;
  const std::uint64_t last = 12;
  for (std::uint64_t revision = 2; revision <= last; ++revision)
  {
    Follow(simpler, Sphere(50.0 - static_cast<double>(revision)), revision);
    if (const auto early = revision < last ? simpler.Poll() : std::nullopt) // on a fast machine it is done already
    {
      ASSERT_TRUE(early->scene) << early->choices[0].reason;
      EXPECT_EQ(early->scene->revision(), revision) << "an order that was replaced arrived";
    }
  }
  const auto found = simpler.Wait();
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->scene) << found->choices[0].reason;
  EXPECT_EQ(found->scene->revision(), last);
  EXPECT_FALSE(simpler.Wait());
}

TEST(HapticSimplerScene, WhatIsDoneAndNotFetchedIsDroppedWhenAnotherSceneIsFollowed)
{
  vtkHapticSimplerScene simpler;
  const auto first = Sphere(50.0);
  Follow(simpler, first, 2);
  ASSERT_TRUE(simpler.Wait());
  EXPECT_TRUE(Follow(simpler, first, 3)); // known, and done, but nobody fetches it
  Follow(simpler, Sphere(40.0), 4);
  const auto found = simpler.Wait();
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->scene) << found->choices[0].reason;
  EXPECT_EQ(found->scene->revision(), 4u);
}

TEST(HapticSimplerScene, WhatIsKnownIsThereAtOnce)
{
  vtkHapticSimplerScene simpler;
  const auto scene = Sphere(50.0);
  Follow(simpler, scene, 2);
  const auto first = simpler.Wait();
  ASSERT_TRUE(first && first->scene);
  EXPECT_TRUE(Follow(simpler, scene, 3));
  const auto again = simpler.Poll();
  ASSERT_TRUE(again && again->scene);
  EXPECT_EQ(again->scene->surfaces()[0].tree, first->scene->surfaces()[0].tree);
}

TEST(HapticSimplerScene, CancelledNothingArrivesAndTheNextOrderStillDoes)
{
  vtkHapticSimplerScene simpler;
  Follow(simpler, Sphere(50.0), 2);
  simpler.Cancel();
  EXPECT_FALSE(simpler.Wait());
  Follow(simpler, Sphere(40.0), 3);
  const auto found = simpler.Wait();
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->scene) << found->choices[0].reason;
  EXPECT_EQ(found->scene->revision(), 3u);
}

TEST(HapticSimplerScene, MayGoWhileItIsLooking)
{
  const auto scene = Sphere(50.0);
  {
    vtkHapticSimplerScene simpler;
    Follow(simpler, scene, 2);
  }
  EXPECT_EQ(scene.use_count(), 1); // nobody looks any more
}
