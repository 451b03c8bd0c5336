// SPDX-License-Identifier: GPL-3.0-or-later
// The force of a session on a soft body is that of the spring between the proxy and the hand.
#include <gtest/gtest.h>

#include "SoftInLoop.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/soft/SoftWorker.h"

namespace palpate::test
{
namespace
{

TEST_F(SoftInLoop, WithoutTheEnergyBalanceEveryTicksForceIsTheSpringsThoughPacketsChangeUnderIt)
{
  for (const double young_Pa : { 20e3, 10.0 }) // through the second the ball comes down to the fixed nodes
  {
    SoftBodyInput input = bumpyBlock(ElasticModel::NeoHookean);
    input.young_Pa = { young_Pa };
    this->begin({ std::make_shared<const SoftBodyInput>(input), "block", 25.0 });
    HapticParameters parameters = this->session.parameters();
    parameters.softBalances = false;
    ASSERT_EQ(this->session.setParameters(parameters), "");
    const double deep_m = young_Pa > 100.0 ? 0.006 : 0.055;
    int pressed = 0;
    for (int i = 0; i < 1000; ++i)
    {
      const double down = std::min(1.0, i / 100.0);
      const Vec3 from(0.03 * std::sin(0.0017 * i), 0.01 * std::sin(0.01 * i), 0.004 - down * (0.004 + deep_m));
      const HapticState& state = this->hold(from);
      const Vec3 spring_N = springInLoop * (state.proxy_W.p - state.device_W.p);
      pressed += state.soft.pressed && spring_N.norm() > 0.01;
      EXPECT_LE(
        (state.force_W - spring_N).norm(), roundingOfSpring_N(springInLoop, state.device_W.p.norm(), spring_N.norm()))
        << i;
    }
    EXPECT_GT(pressed, 800);
    EXPECT_GT(this->session.status<SoftTask>().snapshots, 20u);
    EXPECT_EQ(this->session.stop(), "");
  }
}

} // namespace
} // namespace palpate::test
