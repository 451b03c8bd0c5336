// SPDX-License-Identifier: GPL-3.0-or-later
// What moves beside a body that gives way.
#include <gtest/gtest.h>

#include "SoftInLoop.h"
#include "haptics/geometry/scene/SceneMotion.h"
#include "haptics/session/scene/FeltScene.h"
#include "testing/support/Meshes.h"

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
  this->hold(Vec3(0, 0, 0.02), 200); // its way, and until the next packet brought it
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
  this->session.setSoft(choice);
  for (int i = 0; i < 100; ++i)
  {
    EXPECT_EQ(this->hold(Vec3(0, 0, 0.02)).motionLag_s, 0.0) << i; // of what is under way: the whole time of its way
  }
}

} // namespace
} // namespace palpate::test
