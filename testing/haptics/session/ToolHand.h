// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "devices/FedDevice.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/tool/ToolChoice.h"

namespace palpate::test
{

inline constexpr double springOfTool = 1000.0;

/// A fed hand with a tool, in virtual time, that feels everything from the first tick on.
class ToolHand
{
public:
  void begin(const std::shared_ptr<const Scene>& scene, const ToolChoice& tool, const std::string& file = {})
  {
    HapticParameters parameters;
    parameters.stiffness_N_per_m = springOfTool;
    parameters.limitStiffness = false;
    parameters.safety = SafetyLimits::none();
    ASSERT_EQ(this->session.setParameters(parameters), "");
    this->session.setScene(scene);
    this->session.choose<ToolTask>(tool);
    SessionOptions options;
    options.virtualTime = true;
    options.recordFile = file;
    ASSERT_EQ(this->session.start(std::make_unique<FedDevice>(), options), "");
  }

  const HapticState& hold(const Pose& hand, int ticks = 1)
  {
    DeviceSample sample;
    sample.pose_D = hand;
    static_cast<FedDevice*>(this->session.device())->feed(sample);
    EXPECT_EQ(this->session.step(ticks), ticks);
    return this->session.state();
  }

  const HapticState& hold(double z, int ticks = 1) { return this->hold({ Vec3(0, 0, z), Quat::Identity() }, ticks); }

  HapticSession session;
};

} // namespace palpate::test
