// SPDX-License-Identifier: GPL-3.0-or-later
// The guide to a plane in a closed loop: every simulated device that moves in space, in every hand, in planes of any
// direction, at 1 kHz and 125 Hz. K = 200 N/m or the stable stiffness of device and rate, at most 2 N.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/core/PoseMath.h"
#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/session/DeviceAdaptation.h"
#include "haptics/tick/ForceRenderer.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

constexpr double scale_u_per_m = 1000.0;

/// A plane world with a hand in it: lines so far away that nothing but the guide is felt.
class Led
{
public:
  Led(
    const DeviceModel& model, const HandModel& hand, const Pose& plane_WP, double height_m, double T, double push_N = 0)
    : parameters(parametersOf(infoOf(model), plane_WP, T)), normal_D_(plane_WP.q * Vec3::UnitZ()),
      foot_D_(plane_WP.p / scale_u_per_m), T_(T), scene_(test::sceneOf(raiseWalls(farAway(), 8.0, plane_WP))),
      device_(model, hand, { { Vec3(this->foot_D_ + height_m * this->normal_D_) } },
        { .period_s = T, .push_D = push_N * this->normal_D_ })
  {
    EXPECT_EQ(this->device_.open(), "");
  }

  const TickOutput& tick()
  {
    TickInput input;
    input.tick = ++this->tick_;
    input.dt_s = this->T_;
    input.status = this->device_.read(this->T_ * static_cast<double>(this->tick_), input.sample);
    input.scene = this->scene_.get();
    HapticEvent engage;
    engage.kind = EventKind::Engage;
    if (this->tick_ == 1)
    {
      input.events = { &engage, 1 };
    }
    this->last = renderTick(input, this->parameters, this->state_);
    this->device_.write(this->last.command);
    return this->last;
  }

  void run(double time_s)
  {
    for (double t_s = 0.0; t_s < time_s; t_s += this->T_)
    {
      this->tick();
    }
  }

  [[nodiscard]] double height_m() const { return this->normal_D_.dot(this->device_.position_D() - this->foot_D_); }
  [[nodiscard]] double speed_m_per_s() const { return this->normal_D_.dot(this->device_.speed_D()); }
  [[nodiscard]] const Vec3& normal_D() const { return this->normal_D_; }
  [[nodiscard]] double stiffness_N_per_m() const
  {
    return std::min(this->parameters.guide.stiffness_N_per_m, this->parameters.stiffnessLimit_N_per_m);
  }

  HapticParameters parameters;
  TickOutput last;

private:
  static CurveSet farAway() { return { { { -900, -900 }, { 900, -900 }, { 900, 900 } }, { { 0, 1 }, { 1, 2 } } }; }

  static HapticParameters parametersOf(const DeviceInfo& info, const Pose& plane_WP, double T)
  {
    HapticParameters parameters;
    parameters.passivity.enabled = true;
    parameters.map.scale_u_per_m = scale_u_per_m;
    parameters.safety = SafetyLimits::forDevice(info);
    parameters.guide.on = true;
    parameters.guide.point_W = plane_WP.p;
    parameters.guide.normal_W = plane_WP.q * Vec3::UnitZ();
    return adaptToDevice(parameters, info, stabilityLimits(info, loopSettings(parameters, T)));
  }

  Vec3 normal_D_, foot_D_;
  double T_;
  std::shared_ptr<const Scene> scene_;
  SimulatedDevice device_;
  RendererState state_;
  std::uint64_t tick_ = 0;
};

/// Across the device's z, its x, and turned by chance.
std::vector<Pose> planes()
{
  test::Random random(test::testSeed(661));
  std::vector<Pose> planes(3);
  planes[1].q = shortestTurn(Vec3::UnitZ(), Vec3::UnitX());
  planes[2].q = shortestTurn(Vec3::UnitZ(), random.direction());
  for (Pose& plane_WP : planes)
  {
    plane_WP.p = random.inCube(5.0);
  }
  return planes;
}

template<class Check>
void everyDeviceHandAndPlane(const Check& check)
{
  for (const DeviceModel& model : deviceModels())
  {
    for (const HandModel& hand : handModels())
    {
      for (const Pose& plane_WP : model.planar ? std::vector<Pose>{} : planes())
      {
        SCOPED_TRACE(model.name + ", hand " + hand.name + ", normal " +
                     std::to_string((plane_WP.q * Vec3::UnitZ()).x()) + " " +
                     std::to_string((plane_WP.q * Vec3::UnitZ()).z()));
        check(model, hand, plane_WP);
      }
    }
  }
}

// A hand of stiffness k led to a place at height h, pushed with f, rests where k (h - x) + f = K x. Friction may hold
// it by c along each axis, c |n|_1 along the normal, and the encoder hides a step D along each, K D |n|_1. A free
// handle is only slowed by K T / 2: 2 m / (K T / 2) to lose all but 1 / e.
TEST(GuideInLoop, EveryHandComesToRestWhereItBalancesTheGuideAndIsNeverPulledHarderThanTheLimit)
{
  for (const double T : { 1e-3, 8e-3 })
  {
    everyDeviceHandAndPlane(
      [T](const DeviceModel& model, const HandModel& hand, const Pose& plane_WP)
      {
        constexpr double height_m = 0.008;
        const bool held = hand.stiffness_N_per_m > 0.0;
        const double push_N = held ? 0.3 : 0.0;
        Led led(model, hand, plane_WP, height_m, T, push_N);
        const double K = led.stiffness_N_per_m();
        ASSERT_LE(K, stabilityLimits(infoOf(model), loopSettings(led.parameters, T)).largest_N_per_m);
        double strongest_N = 0.0;
        for (int i = 0; i * T < 4.0; ++i)
        {
          strongest_N = std::max(strongest_N, led.tick().command.wrench_D.force.norm());
        }
        const double mass_kg = model.mass_kg + hand.mass_kg, none = model.damping_Ns_per_m + hand.damping_Ns_per_m;
        const double slowest_s = 2 * mass_kg / (none + 0.5 * K * T);
        const double left_m = height_m * std::exp(-2.5 / slowest_s); // of 4 s the ramps take 1.5 s
        const double sum = K + hand.stiffness_N_per_m, turned = led.normal_D().lpNorm<1>();
        const double rest_m = (hand.stiffness_N_per_m * height_m + push_N) / sum;
        const double free_m = (model.friction_N + K * model.encoderStep_m) * turned / sum;
        EXPECT_NEAR(led.height_m(), rest_m, free_m + left_m + 1e-6);
        EXPECT_LE(std::fabs(led.speed_m_per_s()), left_m * std::sqrt(sum / mass_kg) + 1e-4);
        EXPECT_LE(strongest_N, led.parameters.guide.largest_N * (1 + 1e-12));
        EXPECT_LE(strongest_N, led.parameters.safety.maxForce_N * (1 + 1e-12));
        EXPECT_EQ(led.last.state.fault, Fault::None);
        EXPECT_EQ(led.last.state.guideShare, 1.0);
      });
  }
}

// Energy m v^2 / 2 + K x^2 / 2 of a device that nobody holds, after the ramps: the largest of a second is never more
// than that of the second before, so nothing feeds it, with not even a damping of its own.
TEST(GuideInLoop, WhatNobodyHoldsNeverGainsEnergyFromTheGuide)
{
  for (const DeviceModel& model : deviceModels())
  {
    for (const Pose& plane_WP : model.planar ? std::vector<Pose>{} : planes())
    {
      Led led(model, *handModel("none"), plane_WP, 0.008, 1e-3);
      led.run(1.6);
      const double K = led.stiffness_N_per_m();
      double before_J = std::numeric_limits<double>::infinity();
      for (int second = 0; second < 3; ++second)
      {
        double most_J = 0.0;
        for (int i = 0; i < 1000; ++i)
        {
          led.tick();
          const double v = led.speed_m_per_s(), x_m = led.height_m();
          most_J = std::max(most_J, 0.5 * model.mass_kg * v * v + 0.5 * K * x_m * x_m);
        }
        EXPECT_LE(most_J, before_J) << model.name << ", second " << second;
        before_J = most_J;
      }
    }
  }
}

// 25 mm away the guide is at its limit: it comes with its ramp and that of the engagement, no faster than a force may
// rise, and goes as slowly when it is switched off; from there on there is exactly nothing.
TEST(GuideInLoop, EngagedFarFromThePlaneItComesWithTheRampsAndSwitchedOffItIsExactlyNothing)
{
  everyDeviceHandAndPlane(
    [](const DeviceModel& model, const HandModel& hand, const Pose& plane_WP)
    {
      constexpr double T = 1e-3;
      Led led(model, hand, plane_WP, 0.025, T);
      double before_N = 0.0, steepest_N_per_s = 0.0;
      const auto watch = [&](double time_s)
      {
        for (int i = 0; i * T < time_s; ++i)
        {
          const double now_N = led.tick().command.wrench_D.force.norm();
          steepest_N_per_s = std::max(steepest_N_per_s, (now_N - before_N) / T);
          before_N = now_N;
        }
      };
      led.tick();
      EXPECT_EQ(led.last.state.engage, EngageState::Engaged);
      EXPECT_LE(led.last.command.wrench_D.force.norm(), led.parameters.guide.largest_N * T / 0.5);
      watch(2.0);
      EXPECT_EQ(led.last.state.guideShare, 1.0);
      led.parameters.guide.on = false;
      watch(led.parameters.guide.ramp_s + 2 * T);
      EXPECT_LE(steepest_N_per_s, led.parameters.safety.maxRise_N_per_s * (1 + 1e-9));
      for (int i = 0; i < 200; ++i)
      {
        ASSERT_EQ(led.tick().command.wrench_D.force, Vec3(Vec3::Zero()));
        ASSERT_EQ(led.last.state.guideShare, 0.0);
      }
    });
}

// A hand moved across the plane meets nothing there: the guide alone, and not the contact's damper, may pull.
TEST(GuideInLoop, AFootThatStaysWhereItIsButForRoundingIsNoContact)
{
  for (const Pose& plane_WP : planes())
  {
    Led led(*deviceModel("simulated-generic"), *handModel("none"), plane_WP, 0.02, 1e-3);
    for (int i = 0; i < 3000; ++i)
    {
      led.tick();
      ASSERT_EQ(led.last.state.stabiliser_D, Vec3(Vec3::Zero())) << i;
      ASSERT_EQ(led.last.state.contacts, 0);
    }
  }
}

} // namespace
} // namespace palpate
