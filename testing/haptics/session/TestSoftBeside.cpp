// SPDX-License-Identifier: GPL-3.0-or-later
// Moving surfaces beside a soft body.
#include <gtest/gtest.h>

#include "SoftInLoop.h"
#include "haptics/geometry/scene/SceneMotion.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/scene/FeltScene.h"
#include "haptics/session/soft/SoftChoice.h"
#include "testing/support/Meshes.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{
namespace
{

/// A small sphere far beside the block, and the same a millimetre on.
class SphereBeside
{
public:
  static constexpr double way_s = 0.1;

  [[nodiscard]] std::shared_ptr<const Scene> at(double x)
  {
    SurfaceInput input;
    input.name = "sphere";
    input.mesh = this->mesh_;
    input.pose_WS.p = Vec3(x, 0.0, 0.0);
    return this->builder_.build({ input }).scene;
  }

private:
  SceneBuilder builder_;
  std::shared_ptr<const TriangleMesh> mesh_ = std::make_shared<const TriangleMesh>(makeIcosphere(1, 0.01));
};

TEST_F(SoftInLoop, WhatMovesBesideItGoesItsWayOnceThoughEachPacketBringsAScene)
{
  for (const ElasticModel model : { ElasticModel::Linear, ElasticModel::NeoHookean })
  {
    SphereBeside sphere;
    const auto first = sphere.at(1.0);
    this->session.setScene(first);
    this->begin(blockOf20kPa(model));
    this->hold(Vec3(0, 0, 0.02), 200);
    EXPECT_EQ(this->session.state().sceneShare, 1.0);
    const auto second = movingFrom(*first, 1.0, sphere.at(1.001), SphereBeside::way_s);
    this->session.setScene(second);
    double age_s = 0.0, share = 0.0;
    for (int i = 0; i < 400; ++i)
    {
      const HapticState& state = this->hold(Vec3(0, 0, 0.02));
      if (state.sceneRevision != second->revision())
      {
        continue;
      }
      EXPECT_NEAR(state.sceneAge_s, age_s + 1e-3, 1e-9) << i;
      EXPECT_GE(state.sceneShare, share) << i;
      EXPECT_GE(state.sceneShare, std::min(1.0, state.sceneAge_s / SphereBeside::way_s) - 1e-9) << i;
      age_s = state.sceneAge_s;
      share = state.sceneShare;
    }
    EXPECT_GT(age_s, 0.3);
    EXPECT_EQ(share, 1.0);
    EXPECT_EQ(this->session.stop(), "");
  }
}

TEST_F(SoftInLoop, WhatHasMovedBesideItRestsASecondLater)
{
  FeltScene felt(this->session, 1e-3);
  const auto commit = [&](double x, double stamp_s)
  {
    SceneSurface surface;
    surface.input.name = "sphere";
    surface.input.mesh = std::make_shared<const TriangleMesh>(makeIcosphere(1, 0.01));
    surface.input.pose_WS.p = Vec3(x, 0.0, 0.0);
    felt.beforeCommit();
    felt.worker().commit({ surface }, "", stamp_s);
    EXPECT_TRUE(felt.takeBuilt(simplifyPlan(AutoChoice::Off, 1.0, DeviceInfo()), stamp_s, true));
  };
  this->begin(blockOf20kPa());
  commit(1.0, 0.0);
  this->hold(Vec3(0, 0, 0.02), 100);
  commit(1.001, SphereBeside::way_s);
  this->hold(Vec3(0, 0, 0.02), 1000);
  EXPECT_FALSE(felt.rests());
  this->hold(Vec3(0, 0, 0.02), 200); // its motion, and until the next snapshot brought it
  EXPECT_TRUE(felt.rests());
}

TEST_F(SoftInLoop, OfABodyThatIsComputedMoreOftenWhatIsBesideItStaysWhereItWent)
{
  SphereBeside sphere;
  const auto first = sphere.at(1.0);
  this->session.setScene(movingFrom(*first, 1.0, sphere.at(1.001), SphereBeside::way_s));
  SoftChoice choice = blockOf20kPa(ElasticModel::Linear);
  this->begin(choice);
  this->hold(Vec3(0, 0, 0.02), 400);
  choice.rate_Hz = 50.0;
  this->session.choose<SoftTask>(choice);
  for (int i = 0; i < 100; ++i)
  {
    EXPECT_EQ(this->hold(Vec3(0, 0, 0.02)).motionLag_s, 0.0) << i; // of a motion under way: its whole duration
  }
}

TEST_F(SoftInLoop, BesideAServersPartItIsFeltToTheRimOfThatAndTheBallWaitsThere)
{
  for (const ElasticModel model : { ElasticModel::Linear, ElasticModel::NeoHookean })
  {
    const TemporaryFolder folder;
    const std::string path = folder.file("beside");
    SphereBeside sphere;
    const auto part = sphere.at(1.0);
    this->session.setScene(part);
    this->begin(blockOf20kPa(model), path);
    HapticParameters parameters = this->session.parameters();
    constexpr double reach = 0.03;
    parameters.known = { part->geometryHash(), 0, topOfBlock(), reach };
    ASSERT_EQ(this->session.setParameters(parameters), "");
    this->hold(Vec3(0, 0, 0.002), 200);
    const Vec3 pressed(0, 0, -0.004);
    EXPECT_GT(this->hold(pressed, 400).force_W.z(), 0.1);
    EXPECT_FALSE(this->session.state().known.beyond);
    for (double x = 0.0; x < reach; x += 2e-4)
    {
      this->hold(pressed + Vec3(x, 0, 0));
    }
    const Vec3 beyond = pressed + Vec3(reach, 0, 0);
    const Vec3 waits_W = this->hold(beyond).proxy_W.p;
    const HapticState& out = this->hold(beyond, 700); // 17 snapshots
    EXPECT_TRUE(out.known.beyond);
    EXPECT_LE(out.force_W.norm(), 1e-9);
    EXPECT_EQ(out.proxy_W.p, waits_W);
    EXPECT_GT(this->hold(pressed, 700).force_W.z(), 0.1) << "it goes on from above the block";
    EXPECT_FALSE(this->session.state().known.beyond);
    EXPECT_EQ(this->session.stop(), "");
    const auto read = readRecording(path);
    ASSERT_TRUE(std::holds_alternative<Recording>(read));
    const ReplayResult again = replay(std::get<Recording>(read));
    EXPECT_EQ(again.problem + again.difference, "");
  }
}

} // namespace
} // namespace palpate::test
