// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that come around a hand do not swallow it, whatever they come from.
#include <cmath>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/FedDevice.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/scene/FeltScene.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"
#include "testing/support/Says.h"

namespace palpate::test
{
namespace
{

using ::testing::HasSubstr;

constexpr double scale_u_per_m = 1000.0, stiffness_N_per_m = 500.0;

std::shared_ptr<const TriangleMesh> ball(double radius_u, int levels = 4)
{
  return std::make_shared<const TriangleMesh>(makeIcosphere(levels, radius_u));
}

/// An icosphere's faces lie this much of its radius below the sphere at most: four levels halve 63.4 degrees to 4.
double sagitta(double radius_u)
{
  return 0.002 * radius_u;
}

class CameAroundTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    HapticParameters parameters;
    parameters.map.scale_u_per_m = scale_u_per_m;
    parameters.stiffness_N_per_m = stiffness_N_per_m;
    parameters.contact.radius_u = this->radius_u_;
    ASSERT_EQ(this->session_.setParameters(parameters), "");
    auto device = std::make_unique<FedDevice>();
    this->device_ = device.get();
    this->hold(Vec3(0.0, 0.0, 70.0));
    SessionOptions options;
    options.virtualTime = true;
    ASSERT_EQ(this->session_.start(std::move(device), options), "");
    this->session_.step(2000); // engaged
  }

  /// u.
  void hold(const Vec3& p_W)
  {
    DeviceSample sample;
    sample.pose_D.p = p_W / scale_u_per_m;
    this->device_->feed(sample);
    this->hand_W_ = p_W;
  }

  void goTo(const Vec3& p_W)
  {
    constexpr int ticks = 500;
    const Vec3 from_W = this->hand_W_;
    for (int i = 1; i <= ticks; ++i)
    {
      this->hold(from_W + (p_W - from_W) * i / ticks);
      this->session_.step(1);
    }
  }

  void show(const std::vector<std::pair<std::string, std::shared_ptr<const TriangleMesh>>>& surfaces)
  {
    std::vector<SceneSurface> all;
    for (const auto& [name, mesh] : surfaces)
    {
      all.emplace_back().input.name = name;
      all.back().input.mesh = mesh;
    }
    this->felt_.beforeCommit();
    this->felt_.worker().commit(all, "", 1e-3 * static_cast<double>(this->session_.state().tick));
    ASSERT_TRUE(this->felt_.takeBuilt(simplifyPlan(AutoChoice::Off, scale_u_per_m, DeviceInfo()),
      1e-3 * static_cast<double>(this->session_.state().tick), true));
  }

  Vec3 proxy() { return this->session_.state().proxy_W.p; }

  double radius_u_ = 0.0;
  HapticSession session_;
  FeltScene felt_{ session_, 1e-3 };
  FedDevice* device_ = nullptr;
  Vec3 hand_W_ = Vec3::Zero();
};

TEST_F(CameAroundTest, AClosedSurfaceThatAppearsAroundAPressingHandHasItOutside)
{
  const double small_u = 45.0, large_u = 60.0;
  this->show({ { "small", ball(small_u) } });
  this->goTo(Vec3(0.0, 0.0, small_u - 1.0));
  ASSERT_NEAR(this->proxy().norm(), small_u, sagitta(small_u));
  this->show({ { "small", ball(small_u) }, { "large", ball(large_u) } });
  ASSERT_TRUE(this->felt_.cameAround());
  EXPECT_EQ(this->felt_.cameAround()->surface, "large");
  this->session_.step(100);
  EXPECT_NEAR(this->proxy().norm(), large_u, sagitta(large_u));
  this->goTo(Vec3(0.0, 0.0, large_u + 5.0)); // free air is free
  this->session_.step(500);                  // the blended step has faded
  EXPECT_EQ(this->session_.state().contacts, 0);
  EXPECT_LT(this->session_.state().force_W.norm(), 1e-9);
  this->goTo(Vec3(0.0, 0.0, large_u - 2.0)); // and it is felt from outside: K d
  this->session_.step(500);
  EXPECT_NEAR(this->session_.state().force_W.z(), stiffness_N_per_m * 2.0 / scale_u_per_m,
    stiffness_N_per_m * sagitta(large_u) / scale_u_per_m);
}

TEST_F(CameAroundTest, AHandInFreeAirIsOutsideOfWhatAppearsAroundIt)
{
  this->goTo(Vec3(3.0, -2.0, 20.0));
  this->show({ { "first of all", ball(60.0) } });
  ASSERT_TRUE(this->felt_.cameAround());
  this->session_.step(1);
  EXPECT_GT(this->proxy().norm(), 60.0 - sagitta(60.0));
}

// With nothing shown the hand is free to be where the surface was; a surface that appears again finds it there.
TEST_F(CameAroundTest, ASurfaceThatWasGoneAndComesBackHasTheHandOutside)
{
  const double radius_u = 60.0;
  const auto surface = ball(radius_u);
  this->show({ { "box", surface } });
  this->goTo(Vec3(0.0, 0.0, radius_u - 3.0));
  this->show({});
  this->session_.step(100);
  ASSERT_NEAR(this->proxy().norm(), radius_u - 3.0, 1e-9);
  this->show({ { "box", surface } });
  this->session_.step(100);
  EXPECT_NEAR(this->proxy().norm(), radius_u, sagitta(radius_u));
}

// Its faces are others than before, so that nothing says where the old ones went.
TEST_F(CameAroundTest, ASurfaceThatGrowsFurtherThanTheHandIsDeepKeepsTheContact)
{
  const double before_u = 45.0, after_u = 55.0;
  this->show({ { "contour", ball(before_u, 4) } });
  this->goTo(Vec3(0.0, 0.0, before_u - 1.0));
  ASSERT_EQ(this->session_.state().contacts, 1);
  this->show({ { "contour", ball(after_u, 3) } });
  this->session_.step(500);
  EXPECT_GE(this->session_.state().contacts, 1);
  EXPECT_NEAR(this->proxy().norm(), after_u, 4.0 * sagitta(after_u));
  EXPECT_GT(this->session_.state().force_W.z(), 0.0);
}

TEST_F(CameAroundTest, AHandThatWasPutIntoASurfaceStaysThereWhenThatIsMadeAnew)
{
  this->goTo(Vec3(0.0, 0.0, 10.0));
  this->session_.stop();
  this->show({ { "skull", ball(60.0, 4) } });
  auto device = std::make_unique<FedDevice>();
  this->device_ = device.get();
  this->hold(Vec3(0.0, 0.0, 10.0)); // touch begins inside
  SessionOptions options;
  options.virtualTime = true;
  ASSERT_EQ(this->session_.start(std::move(device), options), "");
  this->session_.step(10);
  this->show({ { "skull", ball(61.0, 3) } });
  EXPECT_FALSE(this->felt_.cameAround());
  this->session_.step(10);
  EXPECT_LT((this->proxy() - Vec3(0.0, 0.0, 10.0)).norm(), 1e-9);
}

// In a closed room the way out ends at the walls: outside of the new ball, inside of the room.
TEST_F(CameAroundTest, InARoomTheHandStaysInTheRoom)
{
  this->show({ { "room", std::make_shared<const TriangleMesh>(makeBox(Vec3::Constant(-500), Vec3::Constant(500))) } });
  this->session_.step(10);
  ASSERT_NEAR(this->proxy().z(), 500.0, 1e-6); // it moved over the hand too
  this->session_.stop();
  auto device = std::make_unique<FedDevice>();
  this->device_ = device.get();
  this->hold(Vec3(1.0, 2.0, 20.0));
  SessionOptions options;
  options.virtualTime = true;
  ASSERT_EQ(this->session_.start(std::move(device), options), "");
  this->session_.step(10);
  this->show({ { "room", std::make_shared<const TriangleMesh>(makeBox(Vec3::Constant(-500), Vec3::Constant(500))) },
    { "ball", ball(60.0) } });
  ASSERT_TRUE(this->felt_.cameAround());
  EXPECT_EQ(this->felt_.cameAround()->surface, "ball");
  this->session_.step(10);
  EXPECT_GT(this->proxy().norm(), 60.0 - sagitta(60.0));
  EXPECT_LT(this->proxy().norm(), 61.0);
}

using Box = std::pair<Vec3, Vec3>;

std::shared_ptr<const TriangleMesh> mesh(const Box& box)
{
  return std::make_shared<const TriangleMesh>(makeBox(box.first, box.second));
}

/// u; negative outside.
double depthIn(const Box& box, const Vec3& p_W)
{
  return std::min((p_W - box.first).minCoeff(), (box.second - p_W).minCoeff());
}

// Two faces that close on a ball leave no place for it between them: in the end it is outside of both, as it was
// before.
TEST_F(CameAroundTest, ABallBetweenTwoBoxesThatMeetComesOutOfBoth)
{
  const Box floor(Vec3(-50, -50, -60), Vec3(50, 50, 0)), above(Vec3(-40, -40, 20), Vec3(40, 40, 60));
  const Vec3 down(0.0, 0.0, -45.0);
  const Box within(above.first + down, above.second + down);
  this->show({ { "floor", mesh(floor) } });
  this->goTo(Vec3(3.0, 5.0, -4.0));
  this->show({ { "floor", mesh(floor) }, { "lid", mesh(above) } });
  this->session_.step(200);
  ASSERT_NEAR(this->proxy().z(), 0.0, 1e-6);
  EXPECT_FALSE(this->felt_.takeOutSqueezed());
  this->show({ { "floor", mesh(floor) }, { "lid", mesh(within) } });
  this->session_.step(500);
  ASSERT_TRUE(this->felt_.takeOutSqueezed());
  this->session_.step(500);
  EXPECT_LT(depthIn(floor, this->proxy()), 1e-6);
  EXPECT_LT(depthIn(within, this->proxy()), 1e-6);
  EXPECT_FALSE(this->felt_.takeOutSqueezed());
}

// From behind the face that holds it: no face that it sees takes it along.
TEST_F(CameAroundTest, ABallOnABoxThroughWhichAnotherComesUpIsOutsideOfBoth)
{
  const Box floor(Vec3(-50, -50, -60), Vec3(50, 50, 0)), below(Vec3(-40, -40, -200), Vec3(40, 40, -120));
  const Vec3 up(0.0, 0.0, 180.0);
  const Box through(below.first + up, below.second + up);
  this->show({ { "floor", mesh(floor) }, { "piston", mesh(below) } });
  this->goTo(Vec3(3.0, 5.0, -4.0));
  this->session_.step(200);
  ASSERT_NEAR(this->proxy().z(), 0.0, 1e-6);
  this->show({ { "floor", mesh(floor) }, { "piston", mesh(through) } });
  this->session_.step(500);
  (void)this->felt_.takeOutSqueezed();
  this->session_.step(500);
  EXPECT_LT(depthIn(floor, this->proxy()), 1e-6);
  EXPECT_LT(depthIn(through, this->proxy()), 1e-6);
}

TEST_F(CameAroundTest, ABallThatIsSqueezedInARoomComesOutIntoTheRoom)
{
  const Box room(Vec3::Constant(-100), Vec3::Constant(100));
  const Box floor(Vec3(-50, -50, -60), Vec3(50, 50, 0)), above(Vec3(-40, -40, 20), Vec3(40, 40, 60));
  const Vec3 down(0.0, 0.0, -45.0);
  const Box within(above.first + down, above.second + down);
  this->session_.stop();
  this->show({ { "room", mesh(room) }, { "floor", mesh(floor) }, { "lid", mesh(above) } });
  auto device = std::make_unique<FedDevice>();
  this->device_ = device.get();
  this->hold(Vec3(3.0, 5.0, 1.0));
  SessionOptions options;
  options.virtualTime = true;
  ASSERT_EQ(this->session_.start(std::move(device), options), "");
  this->session_.step(2000);
  this->goTo(Vec3(3.0, 5.0, -4.0));
  this->show({ { "room", mesh(room) }, { "floor", mesh(floor) }, { "lid", mesh(within) } });
  this->session_.step(500);
  ASSERT_TRUE(this->felt_.takeOutSqueezed());
  this->session_.step(500);
  EXPECT_LT(depthIn(floor, this->proxy()), 1e-6);
  EXPECT_LT(depthIn(within, this->proxy()), 1e-6);
  EXPECT_GT(depthIn(room, this->proxy()), -1e-6);
}

// A wall is around nothing; it hides a ball that an eye saw.
TEST_F(CameAroundTest, WhatComesBetweenTheEyeAndTheHandThatItSawStaysBehindTheHand)
{
  const auto wall = std::make_shared<const TriangleMesh>(makeBox(Vec3(-50, -50, 79), Vec3(50, 50, 80)));
  this->felt_.seeFrom(Vec3(0.0, 0.0, 300.0));
  this->show({ { "wall", wall } });
  ASSERT_TRUE(this->felt_.cameAround());
  this->session_.step(1);
  EXPECT_NEAR(this->proxy().z(), 80.0, 1e-6);
  this->felt_.seeFrom(Vec3(0.0, 0.0, -300.0)); // from behind, the next one hides nothing
  this->show({ { "wall", wall },
    { "second", std::make_shared<const TriangleMesh>(makeBox(Vec3(-50, -50, 89), Vec3(50, 50, 90))) } });
  EXPECT_FALSE(this->felt_.cameAround());
}

TEST_F(CameAroundTest, ABallThatFitsIsNotMovedByWhatAppearsBesideIt)
{
  this->show({ { "beside", ball(60.0) } });
  EXPECT_FALSE(this->felt_.cameAround());
  this->session_.step(1);
  EXPECT_EQ(this->proxy(), this->session_.state().device_W.p);
}

// Balls of any size around hands anywhere within the half of their radius, pressed or free, seen or not.
TEST_F(CameAroundTest, NoBallThatAppearsSwallowsAHand)
{
  Random random(testSeed(15));
  const std::size_t runs = testCount(40);
  for (std::size_t run = 0; run < runs; ++run)
  {
    const Vec3 at_W = random.inCube(20.0);
    const double large_u = random.uniform(40.0, 200.0);
    this->show({ { "far", std::make_shared<const TriangleMesh>(shifted(makeIcosphere(2, 1.0), Vec3(0, 0, 900))) } });
    this->session_.step(1);
    this->goTo(Vec3(0.0, 0.0, 300.0));
    this->goTo(at_W);
    this->felt_.seeFrom(run % 2 == 0 ? std::nullopt : std::optional(Vec3(0.0, -2000.0, 0.0)));
    this->show({ { "ball " + std::to_string(run), ball(large_u, 3) } });
    this->session_.step(20);
    ASSERT_GT(this->proxy().norm(), 0.98 * large_u) << "run " << run;
  }
}

class CameAroundABallTest : public CameAroundTest
{
protected:
  CameAroundABallTest() { this->radius_u_ = 3.0; }
};

// A ball that does not fit as it grows stays as it was, on its side, and grows once it fits.
TEST_F(CameAroundABallTest, ABallThatHasNoRoomToGrowDoesSoOnceItHas)
{
  const auto box = [](double low_z, double high_z)
  { return std::make_shared<const TriangleMesh>(makeBox(Vec3(-50, -50, low_z), Vec3(50, 50, high_z))); };
  this->goTo(Vec3(80.0, 0.0, 70.0));
  this->show({ { "floor", box(-40.0, 0.0) }, { "ceiling", box(8.0, 48.0) } });
  this->goTo(Vec3(80.0, 0.0, 4.0));
  this->goTo(Vec3(0.0, 0.0, 4.0));
  this->goTo(Vec3(0.0, 0.0, -5.0)); // pressed on the floor: the hand is within it
  ASSERT_NEAR(this->proxy().z(), 3.0, 1e-6);
  HapticParameters parameters = this->session_.parameters();
  parameters.contact.radius_u = 10.0;
  ASSERT_EQ(this->session_.setParameters(parameters), "");
  this->session_.step(50);
  EXPECT_NEAR(this->proxy().z(), 3.0, 1e-6);
  EXPECT_EQ(this->session_.state().fault, Fault::None);
  this->goTo(Vec3(0.0, 0.0, 4.0));
  this->goTo(Vec3(80.0, 0.0, 4.0));
  this->goTo(Vec3(80.0, 0.0, 70.0));
  this->goTo(Vec3(0.0, 0.0, 70.0));
  this->goTo(Vec3(0.0, 0.0, 55.0)); // on the ceiling's top, with the ball of 10 u
  EXPECT_NEAR(this->proxy().z(), 58.0, 1e-6);
}

TEST(StayOutside, AHandThatWouldBePushedHarderThanIsAllowedIsLetGoUntilItIsOut)
{
  HapticParameters parameters;
  parameters.map.scale_u_per_m = scale_u_per_m;
  parameters.stiffness_N_per_m = stiffness_N_per_m;
  parameters.safety.maxForce_N = 3.0; // 6 mm at 500 N/m
  const CameAround around{ "Sphere2", Vec3(0, 0, 100), Vec3(0, 0, 60) };
  const auto verdict = [&](HandHolder holder, double depth_u)
  { return stayOutside(around, holder, Vec3(0, 0, 60.0 - depth_u), parameters); };
  EXPECT_FALSE(verdict(HandHolder::Device, 5.9).letGo);
  EXPECT_TRUE(verdict(HandHolder::Device, 6.1).letGo);
  EXPECT_FALSE(verdict(HandHolder::Mouse, 6.1).letGo);
  EXPECT_FALSE(verdict(HandHolder::Program, 6.1).letGo);
  EXPECT_THAT(verdict(HandHolder::Device, 6.1).sentence, HasSubstr("Sphere2 now covers the hand"));
  EXPECT_TRUE(test::says(verdict(HandHolder::Mouse, 1.0).sentence, { "restarts", "front", "surface" }));
}

} // namespace
} // namespace palpate::test
