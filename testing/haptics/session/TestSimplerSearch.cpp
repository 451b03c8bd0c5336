// SPDX-License-Identifier: GPL-3.0-or-later
// Simpler surfaces are looked for on another thread: only the last request arrives, once.

#include <cstdint>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "haptics/session/scene/SimplerSearch.h"
#include "testing/support/Meshes.h"

using namespace palpate;

namespace
{
SimplifyRules rulesOf()
{
  SimplifyRules rules;
  rules.touch.scale_u_per_m = 1000.0;
  rules.leastTriangles = 0;
  return rules;
}

std::shared_ptr<const Scene> sphere(double radius)
{
  return test::sceneOf(test::makeIcosphere(5, radius)); // 20,480 triangles
}

bool follow(SimplerSearch& simpler, const std::shared_ptr<const Scene>& scene, std::uint64_t revision)
{
  return simpler.follow(scene, chooseAtFirst(*scene, {}, rulesOf()), rulesOf(), revision);
}
} // namespace

TEST(SimplerSearch, ArrivesOnceAndWithTheRevisionThatWasAskedFor)
{
  SimplerSearch simpler;
  EXPECT_FALSE(simpler.wait());
  EXPECT_FALSE(follow(simpler, sphere(50.0), 7));
  const auto found = simpler.wait();
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->scene) << found->choices[0].reason;
  EXPECT_EQ(found->scene->revision(), 7u);
  EXPECT_GT(found->largestRadius_u, 0.0);
  EXPECT_FALSE(simpler.poll());
  EXPECT_FALSE(simpler.wait());
}

TEST(SimplerSearch, OfManyOrdersOnlyTheLastArrives)
{
  SimplerSearch simpler;
  const std::uint64_t last = 12;
  for (std::uint64_t revision = 2; revision <= last; ++revision)
  {
    follow(simpler, sphere(50.0 - static_cast<double>(revision)), revision);
    if (const auto early = revision < last ? simpler.poll() : std::nullopt) // on a fast machine it is done already
    {
      ASSERT_TRUE(early->scene) << early->choices[0].reason;
      EXPECT_EQ(early->scene->revision(), revision) << "an order that was replaced arrived";
    }
  }
  const auto found = simpler.wait();
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->scene) << found->choices[0].reason;
  EXPECT_EQ(found->scene->revision(), last);
  EXPECT_FALSE(simpler.wait());
}

TEST(SimplerSearch, WhatIsDoneAndNotFetchedIsDroppedWhenAnotherSceneIsFollowed)
{
  SimplerSearch simpler;
  const auto first = sphere(50.0);
  follow(simpler, first, 2);
  ASSERT_TRUE(simpler.wait());
  EXPECT_TRUE(follow(simpler, first, 3)); // known, and done, but nobody fetches it
  follow(simpler, sphere(40.0), 4);
  const auto found = simpler.wait();
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->scene) << found->choices[0].reason;
  EXPECT_EQ(found->scene->revision(), 4u);
}

TEST(SimplerSearch, WhatIsKnownIsThereAtOnce)
{
  SimplerSearch simpler;
  const auto scene = sphere(50.0);
  follow(simpler, scene, 2);
  const auto first = simpler.wait();
  ASSERT_TRUE(first && first->scene);
  EXPECT_TRUE(follow(simpler, scene, 3));
  const auto again = simpler.poll();
  ASSERT_TRUE(again && again->scene);
  EXPECT_EQ(again->scene->surfaces()[0].tree, first->scene->surfaces()[0].tree);
}

TEST(SimplerSearch, CancelledNothingArrivesAndTheNextOrderStillDoes)
{
  SimplerSearch simpler;
  follow(simpler, sphere(50.0), 2);
  simpler.cancel();
  EXPECT_FALSE(simpler.wait());
  follow(simpler, sphere(40.0), 3);
  const auto found = simpler.wait();
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->scene) << found->choices[0].reason;
  EXPECT_EQ(found->scene->revision(), 3u);
}

TEST(SimplerSearch, MayGoWhileItIsLooking)
{
  const auto scene = sphere(50.0);
  {
    SimplerSearch simpler;
    follow(simpler, scene, 2);
  }
  EXPECT_EQ(scene.use_count(), 1); // nobody looks any more
}
