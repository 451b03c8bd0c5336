// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "devices/FedDevice.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/SessionWorkers.h"
#include "testing/haptics/compliance/Blocks.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{

inline constexpr double firm_N_per_m = 1e4, ball_m = 0.03;

inline SurfaceInput surfaceOf(const std::string& name, const TriangleMesh& mesh, const Pose& pose_WS = {})
{
  SurfaceInput input;
  input.name = name;
  input.mesh = std::make_shared<const TriangleMesh>(mesh);
  input.pose_WS = pose_WS;
  return input;
}

inline SoftChoice padChoice()
{
  SoftBodyInput input = pad(8);
  input.poisson = 0.4;
  input.model = ElasticModel::Linear;
  return { std::make_shared<const SoftBodyInput>(input), "block", 30.0 };
}

/// A mesh of which nothing is known, so that it is not felt as the ball that it is.
inline ToolChoice toolOf(const TriangleMesh& mesh)
{
  auto tool = std::make_shared<ToolMesh>(makeTool(mesh).value);
  tool->simple.reset();
  return { std::move(tool), 0.0 };
}

inline const ToolChoice& ballTool()
{
  static const ToolChoice tool = toolOf(makeIcosphere(4, ball_m));
  return tool;
}

/// Not over a vertex of the block, so far above its top.
inline Pose above(double height_m, const Quat& turn = Quat::Identity())
{
  return { middleOfPad() + Vec3(1.1e-3, 0.8e-3, height_m), turn };
}

inline DeviceSample sampleAt(const Pose& hand)
{
  DeviceSample sample;
  sample.pose_D = hand;
  return sample;
}

/// A fed hand in virtual time.
class PressingHand
{
public:
  explicit PressingHand(const std::string& file = {})
  {
    HapticParameters parameters;
    parameters.stiffness_N_per_m = firm_N_per_m;
    parameters.limitStiffness = false;
    parameters.contact.radius_u = ball_m;
    parameters.safety = SafetyLimits::none();
    EXPECT_EQ(this->session.setParameters(parameters), "");
    this->session.choose<SoftTask>(padChoice());
    SessionOptions options;
    options.virtualTime = true;
    options.recordFile = file;
    auto device = std::make_unique<FedDevice>();
    device->feed(sampleAt(above(2.0 * ball_m)));
    EXPECT_EQ(this->session.start(std::move(device), options), "");
  }

  const HapticState& hold(const Pose& hand, int ticks = 1)
  {
    static_cast<FedDevice*>(this->session.device())->feed(sampleAt(hand));
    EXPECT_EQ(this->session.step(ticks), ticks);
    return this->session.state();
  }

  /// From half a millimetre above the top down to that depth of a ball, .01 mm a tick, and at rest there.
  const HapticState& press(double depth_m)
  {
    this->hold(above(ball_m + 0.5e-3), 100);
    for (double z = 0.5e-3; z > -depth_m; z -= 1e-5)
    {
      this->hold(above(ball_m + z));
    }
    return this->hold(above(ball_m - depth_m), 1500);
  }

  HapticSession session;
};

} // namespace palpate::test
