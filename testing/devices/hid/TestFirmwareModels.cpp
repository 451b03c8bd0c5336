// SPDX-License-Identifier: GPL-3.0-or-later
// The engine through the whole of a link, against models of public firmwares.
#include <cmath>

#include <gtest/gtest.h>

#include "testing/devices/hid/AdaptFfbJoyModel.h"
#include "testing/devices/hid/ModelCases.h"
#include "testing/devices/hid/PidRig.h"

namespace palpate
{
namespace
{

using test::FirmwareModel;
using test::ModelCase;

/// A firmware's model behind a link; the handle stands where it is put.
struct ModelRig : test::PidRig
{
  explicit ModelRig(const ModelCase& one) : PidRig(one.model, one.descriptor), firmware(*one.model)
  {
    EXPECT_EQ(this->device.open(), "") << one.name;
    this->run(20);
  }

  /// The motors' force at that place and speed, in D's test::directions [shares].
  Vec3 felt(const Vec3& at, const Vec3& speed = Vec3::Zero())
  {
    this->firmware.position = { at.x(), -at.y() };
    this->firmware.velocity = { speed.x(), -speed.y() };
    const auto force = this->firmware.force();
    return { force[0], -force[1], 0.0 };
  }

  FirmwareModel& firmware;
};

TEST(FirmwareModels, AForcePushesWhereItIsToAndAsHardToTwoPercent)
{
  for (const Vec3& direction : test::directions)
  {
    for (const ModelCase& one : test::modelCases())
    {
      ModelRig rig(one);
      rig.command.wrench_D.force = 2.0 * direction;
      rig.run(30);
      const Vec3 wanted = 2.0 / rig.scale().maxForce_N * direction;
      EXPECT_LT((rig.felt(Vec3::Zero()) - wanted).norm(), 0.02 * wanted.norm()) << one.name << direction.transpose();
      EXPECT_EQ(rig.firmware.badReports, 0) << one.name;
    }
  }
}

// A tenth of the half travel is full force; half of that is behind each wall. Also after the walls have moved.
TEST(FirmwareModels, HeldWallsPushBackFromEitherSideOfEachAxisAlsoAfterTheyMoved)
{
  for (const ModelCase& one : test::modelCases())
  {
    if (!one.holds)
    {
      continue;
    }
    ModelRig rig(one);
    for (const double half : { 0.3, 0.5 })
    {
      rig.command = test::corridors(rig.scale(), half);
      rig.run(test::ramped_ms);
      for (const Vec3& direction : test::directions)
      {
        EXPECT_LT((rig.felt((half + 0.05) * direction) + 0.5 * direction).norm(), 0.01) << one.name << half;
        EXPECT_LT(rig.felt((half - 0.05) * direction).norm(), 0.01) << one.name << half;
      }
    }
  }
}

TEST(FirmwareModels, OneHeldWallAloneLeavesTheOtherAxisFree)
{
  for (const ModelCase& one : test::modelCases())
  {
    for (const std::size_t wall : { 0U, 1U, 2U, 3U })
    {
      if (!one.holds)
      {
        continue;
      }
      ModelRig rig(one);
      rig.command = test::corridors(rig.scale(), 0.3);
      rig.command.walls[0] = rig.command.walls[wall];
      rig.command.wallCount = 1;
      rig.run(test::ramped_ms);
      const Vec3 inwards = rig.command.walls[0].normal_D, aside(inwards.y(), inwards.x(), 0.0);
      EXPECT_LT((rig.felt(-0.35 * inwards) - 0.5 * inwards).norm(), 0.01) << one.name << wall;
      EXPECT_LT(rig.felt(0.9 * inwards + 0.9 * aside).norm(), 0.01) << one.name << wall;
      rig.port.model->wipe();
    }
  }
}

TEST(FirmwareModels, AHeldDamperBrakesInBothDirectionsOfEachAxis)
{
  for (const ModelCase& one : test::modelCases())
  {
    if (!one.holds)
    {
      continue;
    }
    ModelRig rig(one);
    rig.command.viscosity_Ns_per_m = rig.scale().damperViscosity_Ns_per_m;
    rig.run(test::ramped_ms);
    for (const Vec3& direction : test::directions)
    {
      const double wanted = test::VirtualPidDevice::springGain * test::VirtualPidDevice::damperMetric * 0.1;
      EXPECT_LT((rig.felt(Vec3::Zero(), 0.1 * direction) + wanted * direction).norm(), 0.02 * wanted) << one.name;
    }
  }
}

// The library's walls push inside and not behind: whoever believes its descriptor lets the hand through.
TEST(FirmwareModels, WallsThatAreNotBelievedAreClosedByTheHostOnEveryFirmware)
{
  for (const ModelCase& one : test::modelCases())
  {
    ModelRig rig(one);
    rig.device.trust({});
    EXPECT_FALSE(rig.device.abilitiesNow().offersWalls()) << one.name;
    rig.command = test::corridors(rig.scale(), 0.3);
    for (const Vec3& direction : test::directions)
    {
      rig.firmware.velocity = {};
      rig.firmware.position = { 0.35 * direction.x(), -0.35 * direction.y() };
      for (int ms = 0; ms < 30; ++ms) // no hand: its place is set anew
      {
        rig.run(1);
        static_cast<void>(rig.felt(0.35 * direction));
      }
      const Vec3 wanted = -0.5 * direction;
      EXPECT_LT((rig.felt(0.35 * direction) - wanted).norm(), 0.02) << one.name << direction.transpose();
    }
  }
}

TEST(FirmwareModels, TheArduinoLibrarysOwnWallsDoNotHold)
{
  const ModelCase one = test::modelCases().back();
  ModelRig rig(one);
  rig.command = test::corridors(rig.scale(), 0.3);
  rig.run(test::ramped_ms);
  EXPECT_GT(rig.felt(Vec3(0.35, 0.0, 0.0)).x(), -0.25); // a half was asked for
}

/// The servo stands still, then goes on.
TEST(FirmwareModels, ForceEndsWithTheServoAndIsBackWithIt)
{
  for (const ModelCase& one : test::modelCases())
  {
    ModelRig rig(one);
    rig.command.wrench_D.force = { 2.0, 0.0, 0.0 };
    rig.run(60);
    for (int ms = 0; ms < 300; ++ms)
    {
      rig.pass();
      EXPECT_TRUE(ms < 25 || rig.felt(Vec3::Zero()).norm() == 0.0) << one.name << ms;
    }
    rig.run(20);
    EXPECT_NEAR(rig.felt(Vec3::Zero()).x(), 0.4, 0.008) << one.name;
  }
}

TEST(FirmwareModels, ADeadProgramLeavesNoForceNotEvenBehindAnyButton)
{
  for (const ModelCase& one : test::modelCases())
  {
    ModelRig rig(one);
    rig.command = test::corridors(rig.scale(), 0.3);
    rig.command.wrench_D.force = { 2.0, 2.0, 0.0 };
    rig.command.signal = Signal::Oscillation;
    rig.run(200);
    rig.bus->advance(250);
    EXPECT_EQ(rig.felt(Vec3(0.5, 0.5, 0.0)).norm(), 0.0) << one.name;
    rig.firmware.buttons = 0xFF;
    for (int ms = 0; ms < 300; ++ms)
    {
      rig.bus->advance(1);
      ASSERT_EQ(rig.felt(Vec3(0.5, 0.5, 0.0)).norm(), 0.0) << one.name << ms;
    }
  }
}

TEST(FirmwareModels, NothingPushesAfterClosing)
{
  for (const ModelCase& one : test::modelCases())
  {
    ModelRig rig(one);
    rig.command.wrench_D.force = { 2.0, 2.0, 0.0 };
    rig.run(60);
    rig.device.close();
    EXPECT_EQ(rig.felt(Vec3::Zero()).norm(), 0.0) << one.name;
  }
}

TEST(FirmwareModels, ASticksOwnSpringIsOffWhileItIsHeldAndBackAfterwards)
{
  for (const ModelCase& one : test::modelCases())
  {
    if (const auto stick = std::dynamic_pointer_cast<test::AdaptFfbJoyModel>(one.model))
    {
      EXPECT_TRUE(stick->centring());
      ModelRig rig(one);
      EXPECT_FALSE(stick->centring());
      rig.device.close();
      EXPECT_TRUE(stick->centring());
    }
  }
}

} // namespace
} // namespace palpate
