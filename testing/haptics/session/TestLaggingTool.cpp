// SPDX-License-Identifier: GPL-3.0-or-later
// A hand that is faster than contacts are looked for: the tool stays behind, follows without a leap, and goes through
// nothing. Judges: the hand's own spring, and exact predicates on the triangles.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "testing/haptics/session/PressingHand.h"
#include "testing/haptics/tool/CrossingJudge.h"

namespace palpate::test
{
namespace
{

/// A bone whose top is level with the block's, a centimetre beside it.
TriangleMesh boneBeside(int level)
{
  return shifted(makeIcosphere(level, 0.1), Vec3(0.2, 0.05, -0.05));
}

std::shared_ptr<const Scene> blockAndBone(int level)
{
  SurfaceInput block, beside;
  block.name = "block";
  block.mesh = std::make_shared<const TriangleMesh>(makeBox(Vec3::Zero(), Vec3(0.1, 0.1, 0.05)));
  beside.name = "bone";
  beside.mesh = std::make_shared<const TriangleMesh>(boneBeside(level));
  return SceneBuilder(1).build({ block, beside }).scene;
}

constexpr double spring_N_per_m = 1000.0;

/// Speed of the hand, and answers of the finder each second, an answer arriving as late as the next one begins.
struct Haste
{
  double speed_m_per_s = 0.0, rate_Hz = 0.0;
  bool lags = false; ///< the tool, where it is dragged
};

class LaggingTool : public testing::TestWithParam<Haste>
{
protected:
  void begin(PressingHand& hand, const TriangleMesh& tool, int levelOfBone, double turning_N_m_per_rad = 0.0)
  {
    HapticParameters parameters = hand.session.parameters();
    parameters.stiffness_N_per_m = spring_N_per_m;
    parameters.mechanismTurning_N_m_per_rad = turning_N_m_per_rad;
    parameters.contact.friction = { 0.2, 0.2 };
    ASSERT_EQ(hand.session.setParameters(parameters), "");
    SoftChoice soft = padChoice();
    soft.rate_Hz = GetParam().rate_Hz;
    hand.session.choose<SoftTask>(soft);
    hand.session.setScene(blockAndBone(levelOfBone));
    hand.session.choose<ToolTask>(toolOf(tool));
  }
};

TEST_P(LaggingTool, DraggedFromTissueOntoBoneAndBackTheForceHasNoStep)
{
  PressingHand hand;
  this->begin(hand, makeIcosphere(3, ball_m), 5);
  Pose at = above(ball_m + 1e-3);
  hand.hold(at, 300);
  for (int i = 0; i < 300; ++i)
  {
    at.p.z() -= 1e-5;
    hand.hold(at);
  }
  Vec3 before_N = hand.hold(at, 300).force_W;
  const double step_m = 1e-3 * GetParam().speed_m_per_s;
  const int there = static_cast<int>(0.15 / step_m);
  double most_N = 0.0, mostForce_N = 0.0;
  int lagged = 0;
  for (int i = 0; i < 2 * there + 1000; ++i)
  {
    at.p.x() += i < there ? step_m : i < 2 * there ? -step_m : 0.0;
    const HapticState& now = hand.hold(at);
    most_N = std::max(most_N, (now.force_W - before_N).norm());
    mostForce_N = std::max(mostForce_N, now.force_W.norm());
    before_N = now.force_W;
    lagged += now.mechanism.ahead;
  }
  EXPECT_GT(mostForce_N, 1.0);
  EXPECT_EQ(lagged > there / 25, GetParam().lags); // a tick that only slows the mesh down is no lag
  // The hand's own step, the catching up of a mesh that was behind, and the part of another answer's step that is felt
  // at once.
  EXPECT_LE(most_N, spring_N_per_m * step_m + 2.0 * ToolBlend::largestStep_N);
  EXPECT_FALSE(hand.session.state().mechanism.ahead) << "the hand waits";
}

/// The session holds a small tool weakly against turns: pressed on one of its corners, the tool rolls over.
TEST_P(LaggingTool, ThatIsSmallerThanTheEdgesOfABoneMeetsNoneOfItsTriangles)
{
  constexpr double radius_m = 0.004, way_m = 0.06;
  constexpr int levelOfBone = 4; // edges of 7 mm
  const TriangleMesh ball = makeIcosphere(2, radius_m);
  const ToolMesh whole = makeTool(ball).value;
  const CrossingJudge judge(*whole.shape_B, *makeToolScene(cleanMesh(boneBeside(levelOfBone)).mesh, whole), 0);
  const Vec3 middle(0.2, 0.05, -0.05);
  const double step_m = 1e-3 * GetParam().speed_m_per_s;
  double mostForce_N = 0.0;
  for (const Vec3& from : { Vec3(0.0, 0.0, 1.0), Vec3(0.6, 0.0, 0.8), Vec3(0.3, 0.5, 0.8) })
  {
    PressingHand hand;
    this->begin(hand, ball, levelOfBone);
    Pose at{ middle + 0.16 * from.normalized(), Quat::Identity() };
    hand.hold(at, 300);
    std::size_t crossings = 0;
    for (const Vec3& way : { Vec3(-from), Vec3(1.0, 0.3, 0.0), Vec3(-1.0, 0.2, -0.4) })
    {
      for (int i = 0; i < static_cast<int>(way_m / step_m); ++i)
      {
        at.p += step_m * way.normalized();
        const HapticState& now = hand.hold(at);
        mostForce_N = std::max(mostForce_N, now.force_W.norm());
        crossings += judge.crossings(now.proxy_W.p, now.proxy_W.q.toRotationMatrix());
      }
    }
    EXPECT_EQ(crossings, 0U) << from.transpose();
  }
  EXPECT_GT(mostForce_N, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Each, LaggingTool,
  testing::Values(
    Haste{ 0.05, 30.0, false }, Haste{ 0.2, 12.0, true }, Haste{ 0.2, 30.0, true }, Haste{ 0.5, 30.0, true }));

} // namespace
} // namespace palpate::test
