// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "SoftBlock.h"
#include "devices/FedDevice.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/soft/SoftChoice.h"

namespace palpate::test
{

inline constexpr double springInLoop = 500.0;
inline constexpr double ballInLoop = 0.008;

inline SoftChoice blockOf20kPa(ElasticModel model = ElasticModel::NeoHookean)
{
  return { std::make_shared<const SoftBodyInput>(softBlock(model)), "block", 25.0 };
}

/// A hand on a soft block, in virtual time unless said.
class SoftInLoop : public testing::Test
{
protected:
  void begin(const SoftChoice& choice, const std::string& file = {}, bool virtualTime = true)
  {
    HapticParameters parameters;
    parameters.stiffness_N_per_m = springInLoop;
    parameters.limitStiffness = false;
    parameters.contact.radius_u = ballInLoop;
    parameters.safety = SafetyLimits::none();
    ASSERT_EQ(this->session.setParameters(parameters), "");
    this->session.choose<SoftTask>(choice);
    SessionOptions options;
    options.virtualTime = virtualTime;
    options.recordFile = file;
    auto device = std::make_unique<FedDevice>();
    this->feed(*device, Vec3(0, 0, 0.02));
    ASSERT_EQ(this->session.start(std::move(device), options), "");
  }

  /// Of a hand so far from where the ball would touch the middle of the top.
  static void feed(FedDevice& device, const Vec3& fromTop)
  {
    DeviceSample sample;
    sample.pose_D.p = topOfBlock() + Vec3(0, 0, ballInLoop) + fromTop;
    device.feed(sample);
  }

  const HapticState& hold(const Vec3& fromTop, int ticks = 1)
  {
    feed(*static_cast<FedDevice*>(this->session.device()), fromTop);
    EXPECT_EQ(this->session.step(ticks), ticks);
    return this->session.state();
  }

  /// Presses, slides and lets go, `seconds` long.
  template<class Visit>
  void play(double seconds, const Visit& visit)
  {
    for (int i = 0; i < static_cast<int>(1000.0 * seconds); ++i)
    {
      const double s = 1e-3 * i;
      visit(this->hold(Vec3(0.01 * std::sin(4.0 * s), 0.008 * std::sin(3.0 * s), 0.004 - 0.010 * std::sin(5.0 * s))));
    }
  }

  HapticSession session;
};

} // namespace palpate::test
