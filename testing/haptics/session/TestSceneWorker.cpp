// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes are built on another thread: only the last commit waits, and each scene arrives once.
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/contact/RadiusLimit.h"
#include "haptics/session/scene/SceneWorker.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr int fine = 4; // 5,120 triangles: a build that takes a while

SceneSurface surfaceOf(const TriangleMesh& mesh, const std::string& name)
{
  SceneSurface surface;
  surface.input.name = name;
  surface.input.mesh = std::make_shared<const TriangleMesh>(mesh);
  return surface;
}

SceneSurface wallsAcross(const Pose& plane_WP)
{
  SceneSurface walls = surfaceOf(makeBox(Vec3(-1.0, -1.0, -1.0), Vec3(1.0, 1.0, 1.0)), "walls");
  walls.plane_WP = plane_WP;
  return walls;
}

TEST(SceneWorker, ASceneArrivesOnceWithItsBoundsItsStampAndALineASurface)
{
  SceneWorker worker;
  EXPECT_FALSE(worker.wait());
  SceneSurface box = surfaceOf(makeBox(Vec3(-1.0, -2.0, -3.0), Vec3(1.0, 2.0, 3.0)), "box");
  box.materialNote = "of wood";
  worker.commit({ box }, "not touched: a point\n", 7.5);
  EXPECT_TRUE(worker.building());
  const auto built = worker.wait();
  ASSERT_TRUE(built && built->scene);
  EXPECT_EQ(built->stamp_s, 7.5);
  EXPECT_EQ(built->bounds, (std::array<double, 6>{ -1.0, 1.0, -2.0, 2.0, -3.0, 3.0 }));
  EXPECT_THAT(built->report, StartsWith("not touched: a point\nbox: "));
  EXPECT_THAT(built->report, HasSubstr("; material: of wood\n"));
  EXPECT_EQ(built->largestRadius_u, radiusLimit(*built->scene, {}).largest_u);
  EXPECT_FALSE(worker.building());
  EXPECT_FALSE(worker.poll());
  EXPECT_FALSE(worker.wait());
}

TEST(SceneWorker, OfCommitsThatComeWhileItBuildsOnlyTheNewestIsBuilt)
{
  SceneWorker worker;
  const int last = 5;
  for (int commit = 1; commit <= last; ++commit)
  {
    worker.commit({ surfaceOf(makeIcosphere(fine, commit), "sphere") }, "", commit);
  }
  const auto newest = worker.wait(); // waits for the one that waits, too
  ASSERT_TRUE(newest && newest->scene);
  EXPECT_EQ(newest->stamp_s, last);
  EXPECT_EQ(newest->bounds[1], last);
  EXPECT_EQ(newest->scene->revision(), 2u); // of the first and the last
  EXPECT_FALSE(worker.wait());
}

TEST(SceneWorker, WhatWaitsBeginsWhenWhatIsDoneIsFollowed)
{
  SceneWorker worker;
  worker.commit({ surfaceOf(makeIcosphere(fine, 1.0), "sphere") }, "", 1.0);
  worker.commit({ surfaceOf(makeIcosphere(fine, 2.0), "sphere") }, "", 2.0);
  std::optional<BuiltScene> first;
  while (!first)
  {
    first = worker.poll();
  }
  EXPECT_EQ(first->stamp_s, 1.0);
  EXPECT_FALSE(worker.building()); // it does not begin by itself: the first is to be felt, and to be come from
  worker.follow(first->scene);
  EXPECT_TRUE(worker.building());
  EXPECT_EQ(worker.wait()->stamp_s, 2.0);
}

TEST(SceneWorker, WhatIsCancelledGivesNothingAndTheNextCommitIsBuilt)
{
  SceneWorker worker;
  worker.commit({ surfaceOf(makeIcosphere(fine, 1.0), "unwanted") }, "", 1.0);
  worker.commit({ surfaceOf(makeIcosphere(fine, 2.0), "waits") }, "", 2.0);
  worker.cancel();
  worker.commit({ surfaceOf(makeIcosphere(fine, 3.0), "wanted") }, "", 3.0);
  const auto built = worker.wait();
  ASSERT_TRUE(built && built->scene);
  EXPECT_EQ(built->stamp_s, 3.0);
  EXPECT_LE(built->scene->revision(), 2u); // at most the first was done by then; never one that waited
  worker.cancel();                         // nothing is being built: nothing happens
  EXPECT_FALSE(worker.building());
  worker.commit({ surfaceOf(makeIcosphere(fine, 3.0), "again") }, "", 4.0);
  EXPECT_TRUE(worker.wait());
}

TEST(SceneWorker, ItSaysHowMuchOfACommitIsBuiltAndThatNeverLess)
{
  SceneWorker worker;
  EXPECT_EQ(worker.share(), 1.0); // nothing is to be done
  worker.commit({ surfaceOf(makeIcosphere(fine, 1.0), "one"), surfaceOf(makeIcosphere(fine, 2.0), "another"),
                  surfaceOf(makeIcosphere(fine, 3.0), "a third") },
    "", 1.0);
  double most = 0.0;
  std::optional<BuiltScene> built;
  while (!built)
  {
    const double share = worker.share();
    EXPECT_GE(share, most);
    EXPECT_LT(share, 1.0); // until it is there
    most = share;
    built = worker.poll();
  }
  EXPECT_EQ(worker.share(), 1.0);
}

TEST(SceneWorker, WhatOnlyMovesIsDoneAtOnceAndItsBallStaysAsLarge)
{
  SceneWorker worker;
  const SceneSurface sphere = surfaceOf(makeIcosphere(fine, 50.0), "sphere");
  worker.commit({ sphere }, "", 1.0);
  const auto before = worker.wait();
  SceneSurface moved = sphere;
  moved.input.pose_WS.p = Vec3(3.0, 0.0, 0.0);
  worker.commit({ moved }, "", 2.0);
  const auto after = worker.poll(); // nobody waited
  ASSERT_TRUE(after && after->scene);
  EXPECT_EQ(after->scene->surfaces()[0].tree, before->scene->surfaces()[0].tree);
  EXPECT_EQ(after->largestRadius_u, before->largestRadius_u);
}

TEST(SceneWorker, ASurfaceThatIsRefusedIsSaidAndNotInTheScene)
{
  SceneWorker worker;
  TriangleMesh flat;
  flat.vertices_W = { Vec3::Zero(), Vec3::Zero(), Vec3::Zero() };
  flat.triangles = { { 0, 1, 2 } };
  worker.commit({ surfaceOf(flat, "dot"), wallsAcross({}) }, "", 0.0);
  const auto built = worker.wait();
  ASSERT_TRUE(built && built->scene);
  EXPECT_THAT(built->report, StartsWith("dot: refused: "));
  ASSERT_EQ(built->traits.walls_WP.size(), 1u);
  EXPECT_TRUE(built->traits.walls_WP[0]); // the traits are those of the surfaces that are left
  worker.commit({}, "", 1.0);
  EXPECT_EQ(worker.wait()->scene, nullptr);
}

TEST(SceneWorker, AllWallsAcrossOnePlaneHaveItWhereTheyStandNow)
{
  const Quat turned(Eigen::AngleAxisd(0.5, Vec3::UnitX()));
  const Pose plane{ Vec3(0.0, 0.0, 2.0), turned };
  EXPECT_FALSE(commonPlane({}));
  SceneSurface walls = wallsAcross(plane);
  SceneSurface other = wallsAcross({ plane.p + turned * Vec3(5.0, -3.0, 0.0), turned }); // elsewhere in that plane
  ASSERT_TRUE(commonPlane({ walls, other }));
  EXPECT_EQ(commonPlane({ walls, other })->p, plane.p);
  EXPECT_FALSE(commonPlane({ walls, surfaceOf(makeIcosphere(0, 1.0), "sphere") }));
  EXPECT_FALSE(commonPlane({ walls, wallsAcross({ plane.p + turned * Vec3(0.0, 0.0, 1e-4), turned }) }));
  EXPECT_FALSE(commonPlane({ walls, wallsAcross({ plane.p, Quat::Identity() }) }));
  walls.input.pose_WS.p = Vec3(1.0, 0.0, 0.0);
  EXPECT_EQ(commonPlane({ walls })->p, plane.p + Vec3(1.0, 0.0, 0.0));
}

TEST(SceneWorker, MayGoWhileItBuilds)
{
  const SceneSurface sphere = surfaceOf(makeIcosphere(fine, 1.0), "sphere");
  const auto mesh = sphere.input.mesh;
  {
    SceneWorker worker;
    worker.commit({ sphere }, "", 0.0);
    worker.commit({ sphere }, "", 1.0);
  }
  EXPECT_EQ(mesh.use_count(), 2); // this one's and the surface's
}

} // namespace
} // namespace palpate::test
