// SPDX-License-Identifier: GPL-3.0-or-later
// The force of a whole device fades to none towards the end of a joint and towards a singular posture: over 5 % of the
// joint's range and of the largest condition number that its plan allows. Both are computed here from the plan and from
// the model's own mechanics.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "testing/devices/arm/TwoDiyRig.h"
#include "testing/devices/arm/WoodenHapticsRig.h"

namespace palpate
{
namespace
{

using test::TwoDiyRig;
using test::WoodenHapticsRig;

constexpr double rad_per_deg = std::numbers::pi / 180.0;
constexpr double band = 0.05;
constexpr std::array<double, 3> shares{ 0.2, 0.5, 0.8 };
constexpr double ofThePlace = 0.01; ///< the Jacobian is that of the counted place

/// Ratio of the largest singular value of the model's way over its motors' joints to the least.
double conditionOf(const test::LedArm& model, int motors)
{
  const Eigen::VectorXd values = model.ways().topLeftCorner(motors, motors).jacobiSvd().singularValues();
  return values[0] / values[motors - 1];
}

/// The share of the force that the plan leaves with the model's joints there, from its condition number alone.
double shareByCondition(const test::LedArm& model, int motors, const ArmPlan& plan)
{
  return std::clamp((plan.maxCondition - conditionOf(model, motors)) / (band * plan.maxCondition), 0.0, 1.0);
}

/// Places the model on the way between two postures, of which the second is singular, where that share is left.
void placeWhere(test::LedArm& model, int motors, const ArmPlan& plan, const Vec3& from, const Vec3& to, double share)
{
  double near = 0.0, far = 1.0;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (near + far);
    model.place(from + middle * (to - from));
    (shareByCondition(model, motors, plan) > share ? near : far) = middle;
  }
}

/// By how much the force changes, at most, where the share and the torques are those of the place in whole counts [N].
double offByCounts_N(test::LedArm& model, int motors, const ArmPlan& plan, const Vec3& count_rad, const Vec3& asked_N)
{
  const Vec3 at = model.joints_rad();
  const double here = shareByCondition(model, motors, plan);
  double most_N = 0.0;
  for (int k = 0; k < motors; ++k)
  {
    model.place(at - count_rad[k] * Vec3::Unit(k));
    const double counted = shareByCondition(model, motors, plan);
    const Vec3 torque_Nm = counted * model.ways().transpose() * asked_N;
    model.place(at);
    most_N += (model.forceOf(torque_Nm) - here * asked_N).norm();
  }
  return most_N;
}

/// Of the joints that have a motor [rad].
Vec3 countsOf(const ArmPlan& plan, int motors)
{
  Vec3 count_rad = Vec3::Zero();
  for (int k = 0; k < motors; ++k)
  {
    const ArmJoint& joint = plan.joints[static_cast<std::size_t>(k)];
    count_rad[k] = 2.0 * std::numbers::pi / (joint.countsPerTurn * std::fabs(joint.gear));
  }
  return count_rad;
}

/// An end of one joint and a posture there in which the others keep the arm far from singular [deg].
struct FadingEnd
{
  int joint;
  Vec3 pose_deg;
};

TEST(WoodenHaptics, FadesItsForceOverTheLastTwentiethOfAJointsRange)
{
  const std::array<FadingEnd, 6> ends{ { { 0, { 100.0, 0.0, 90.0 } }, { 0, { -100.0, 0.0, 90.0 } },
    { 1, { 0.0, 80.0, 10.0 } }, { 1, { 0.0, -80.0, 150.0 } }, { 2, { 0.0, -60.0, 170.0 } },
    { 2, { 0.0, 60.0, -10.0 } } } };
  const Vec3 asked_N(0.0, 0.7, 0.0);
  for (const FadingEnd& end : ends)
  {
    for (const double share : shares)
    {
      WoodenHapticsRig rig;
      ASSERT_EQ(rig.open(), "");
      const ArmPlan& plan = *rig.kit.setup.plan;
      const ArmJoint& joint = plan.joints[static_cast<std::size_t>(end.joint)];
      const double width_rad = band * (joint.high_rad - joint.low_rad);
      const double sign = rad_per_deg * end.pose_deg[end.joint] > 0.5 * (joint.low_rad + joint.high_rad) ? 1.0 : -1.0;
      const Vec3 inwards = -sign * Vec3::Unit(end.joint);
      Vec3 pose_rad = rad_per_deg * end.pose_deg;
      pose_rad[end.joint] = sign > 0.0 ? joint.high_rad : joint.low_rad;
      rig.model->place(pose_rad + share * width_rad * inwards);
      ask(rig, asked_N);
      EXPECT_EQ(rig.status, DeviceStatus::Ok);
      const double count = countsOf(plan, 3)[end.joint] / width_rad;
      EXPECT_LE((rig.model->force_N() - share * asked_N).norm(),
        rig.model->halfStep_N() + (count + share * ofThePlace) * asked_N.norm())
        << "joint " << end.joint << " at " << pose_rad[end.joint] << ", " << share;
    }
  }
}

TEST(WoodenHaptics, FadesItsForceOverTheLastTwentiethOfTheConditionNumberThatItsPlanAllows)
{
  const Vec3 asked_N(0.0, 0.7, 0.3);
  // Upper link and forearm come into one line where their angles add up to half a turn.
  const Vec3 bent = rad_per_deg * Vec3(10.0, 20.0, 80.0), straight = rad_per_deg * Vec3(10.0, 20.0, 160.0);
  for (const double share : shares)
  {
    WoodenHapticsRig rig;
    ASSERT_EQ(rig.open(), "");
    const ArmPlan& plan = *rig.kit.setup.plan;
    placeWhere(*rig.model, 3, plan, bent, straight, share);
    ASSERT_NEAR(shareByCondition(*rig.model, 3, plan), share, 1e-6);
    ASSERT_LT(rig.model->joints_rad()[2], plan.joints[2].high_rad - band * (180.0 * rad_per_deg)) << "no joint ends";
    ask(rig, asked_N);
    EXPECT_EQ(rig.status, DeviceStatus::Ok);
    const double off_N = rig.model->halfStep_N() + offByCounts_N(*rig.model, 3, plan, countsOf(plan, 3), asked_N);
    ASSERT_LT(off_N, 0.15 * asked_N.norm()) << "counts tell the places apart";
    EXPECT_LE((rig.model->force_N() - share * asked_N).norm(), off_N) << share;
  }
}

TEST(TwoDiy, FadesItsForceOverTheLastTwentiethOfTheConditionNumberThatItsPlanAllows)
{
  const Vec3 asked_N(0.0, 0.4, 0.0);
  for (const double share : shares)
  {
    TwoDiyRig diy;
    ASSERT_EQ(diy.rig.device.open(), "");
    diy.setInPose();
    const ArmPlan plan = twoDiyArm().plan;
    ASSERT_TRUE(diy.model->lead({ 0.01, 0.085, 0.0 }));
    const Vec3 middle = diy.model->joints_rad();
    placeWhere(*diy.model, 2, plan, middle, rad_per_deg * Vec3(85.0, 95.0, 0.0), share); // its elbows nearly meet
    ASSERT_NEAR(shareByCondition(*diy.model, 2, plan), share, 1e-6);
    ask(diy.rig, asked_N);
    EXPECT_EQ(diy.rig.status, DeviceStatus::Ok);
    const double off_N = diy.model->step_N() + offByCounts_N(*diy.model, 2, plan, countsOf(plan, 2), asked_N);
    ASSERT_LT(off_N, 0.15 * asked_N.norm()) << "counts tell the places apart";
    EXPECT_LE((diy.model->force_N() - share * asked_N).norm(), off_N) << share;
  }
}

} // namespace
} // namespace palpate
