// SPDX-License-Identifier: GPL-3.0-or-later
// The part of built scenes that a session feels: all of it at first, simpler surfaces when they are proven, and
// motions.
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/FedDevice.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/scene/FeltScene.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

using ::testing::HasSubstr;

constexpr double period_s = 1e-3;
constexpr double felt_u_per_m = 1000.0;

SimplifyPlan planOf(AutoChoice choice, double scale = felt_u_per_m)
{
  return simplifyPlan(choice, scale, DeviceInfo());
}

class FeltSceneTest : public ::testing::Test
{
protected:
  void start()
  {
    HapticParameters parameters;
    parameters.map.scale_u_per_m = felt_u_per_m;
    ASSERT_EQ(this->session_.setParameters(parameters), "");
    auto device = std::make_unique<FedDevice>();
    device->feed({});
    SessionOptions options;
    options.virtualTime = true;
    ASSERT_EQ(this->session_.start(std::move(device), options), "");
  }

  void commit(const std::shared_ptr<const TriangleMesh>& mesh, double stamp_s, const Vec3& at_W = Vec3::Zero())
  {
    SceneSurface surface;
    surface.input.name = "surface";
    surface.input.mesh = mesh;
    surface.input.pose_WS.p = at_W;
    this->felt_.beforeCommit();
    this->felt_.worker().commit({ surface }, "", stamp_s);
  }

  HapticSession session_;
  FeltScene felt_{ session_, period_s };
  std::shared_ptr<const TriangleMesh> sphere_ = std::make_shared<const TriangleMesh>(makeIcosphere(5, 50.0));
};

TEST_F(FeltSceneTest, AllTrianglesAreFeltFirstAndSimplerOnesOnceTheyAreFound)
{
  const SimplifyPlan plan = planOf(AutoChoice::On);
  EXPECT_FALSE(this->felt_.takeBuilt(plan, 0.0));
  this->commit(this->sphere_, 0.25);
  EXPECT_TRUE(this->felt_.takeBuilt(plan, 1.0, true));
  const auto full = this->felt_.built().scene;
  EXPECT_EQ(this->session_.scene(), full);
  EXPECT_EQ(this->felt_.handOver_s(), 0.75);
  EXPECT_FALSE(this->felt_.isSimpler());
  this->felt_.takeSimpler(true);
  ASSERT_TRUE(this->felt_.isSimpler());
  EXPECT_EQ(this->session_.scene(), this->felt_.built().scene);
  ASSERT_EQ(this->felt_.choices().size(), 1u);
  EXPECT_LE(2 * this->felt_.choices()[0].felt, this->felt_.choices()[0].triangles);
  EXPECT_THAT(this->felt_.built().report, HasSubstr("triangles are used"));
  this->felt_.follow(plan); // nothing has changed
  EXPECT_TRUE(this->felt_.isSimpler());
  this->felt_.follow(planOf(AutoChoice::Off));
  EXPECT_EQ(this->session_.scene(), full);
  EXPECT_EQ(this->felt_.choices()[0].reason, "simpler surfaces are off");
  this->felt_.takeSimpler(true);
  EXPECT_FALSE(this->felt_.isSimpler());
}

TEST_F(FeltSceneTest, AnotherScaleOfTheHandBringsAllTrianglesBackUntilItIsProvenAnew)
{
  this->commit(this->sphere_, 0.0);
  EXPECT_TRUE(this->felt_.takeBuilt(planOf(AutoChoice::On), 0.0, true));
  const auto full = this->session_.scene();
  this->felt_.takeSimpler(true);
  EXPECT_NE(this->session_.scene(), full);
  this->felt_.follow(planOf(AutoChoice::On, 0.5 * felt_u_per_m));
  EXPECT_EQ(this->session_.scene(), full);
}

TEST_F(FeltSceneTest, ACommitEndsTheSearchForWhatItReplaces)
{
  this->commit(this->sphere_, 0.0);
  EXPECT_TRUE(this->felt_.takeBuilt(planOf(AutoChoice::On), 0.0, true));
  this->commit(this->sphere_, 1.0, Vec3(1.0, 0.0, 0.0));
  this->felt_.takeSimpler(true);
  EXPECT_FALSE(this->felt_.isSimpler());
}

TEST_F(FeltSceneTest, WhatMovesTakesAsLongAsFromCommitToCommitAndRestsASecondLater)
{
  this->start();
  const SimplifyPlan plan = planOf(AutoChoice::Off);
  this->commit(this->sphere_, 0.0);
  EXPECT_TRUE(this->felt_.takeBuilt(plan, 0.0, true));
  EXPECT_FALSE(this->felt_.isTaken());
  this->session_.step(1);
  EXPECT_TRUE(this->felt_.isTaken());
  EXPECT_FALSE(this->felt_.rests()); // nothing moved
  this->commit(this->sphere_, 0.05, Vec3(1.0, 0.0, 0.0));
  EXPECT_TRUE(this->felt_.takeBuilt(plan, 0.05, true));
  EXPECT_EQ(this->session_.scene()->motion_s(), 0.05);
  const int way = 50, rest = 1000; // ticks
  this->session_.step(way + rest);
  EXPECT_FALSE(this->felt_.rests());
  this->session_.step(2); // the tick that takes a scene has age 0
  EXPECT_TRUE(this->felt_.rests());
  this->commit(this->sphere_, 9.0, Vec3(2.0, 0.0, 0.0));
  EXPECT_TRUE(this->felt_.takeBuilt(plan, 9.0, true));
  EXPECT_EQ(this->session_.scene()->motion_s(), 0.2); // it was a rest, not a motion
  this->session_.stop();
}

TEST_F(FeltSceneTest, WithoutASessionThatRunsNothingMovesAndNothingRests)
{
  this->commit(this->sphere_, 0.0);
  EXPECT_TRUE(this->felt_.takeBuilt(planOf(AutoChoice::Off), 0.0, true));
  this->commit(this->sphere_, 0.05, Vec3(1.0, 0.0, 0.0));
  EXPECT_TRUE(this->felt_.takeBuilt(planOf(AutoChoice::Off), 0.05, true));
  EXPECT_EQ(this->session_.scene()->motion_s(), 0.0); // it is there at once
  EXPECT_TRUE(this->felt_.isTaken());
  EXPECT_FALSE(this->felt_.rests());
}

} // namespace
} // namespace palpate::test
