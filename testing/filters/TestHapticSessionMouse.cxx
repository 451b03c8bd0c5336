// SPDX-License-Identifier: GPL-3.0-or-later
// Requests of the mouse in a view to a session.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;

namespace
{

// A fine sphere allows only a small ball. Its path ends where the ball that touches would be stopped: so far above the
// pole, where the facets of n slices of half a turn lie below the sphere by their sagitta at most.
TEST(HapticSessionMouse, AWayIsBarredForTheBallThatTouchesNotForALargerOneThatIsAskedFor)
{
  constexpr double radius = 50.0, pi = 3.14159265358979323846;
  constexpr int resolution = 200;
  const double sagitta = radius * (1.0 - std::cos(pi / resolution));
  vtkNew<vtkHapticSession> session;
  session->SetSetting("Simplify", vtkHapticSession::Off);
  session->AddSurface("sphere", makeSphere(radius, resolution), nullptr);
  session->CommitScene();
  ASSERT_TRUE(session->FinishScene());
  const double limit = session->GetRadiusLimit();
  ASSERT_TRUE(std::isfinite(limit));
  ASSERT_GT(limit, 10 * sagitta);
  session->SetSetting("Radius", 2 * limit);
  ASSERT_EQ(session->GetRadiusUsed(), limit);
  const Vec3 from_W(0, 0, 3 * radius), to_W(0, 0, 0);
  Vec3 ball_W, normal_W;
  ASSERT_TRUE(session->GetSight()->PickSurface(from_W.data(), to_W.data(), ball_W.data(), normal_W.data()));
  EXPECT_NEAR(ball_W.z(), radius + limit, sagitta);
  session->SetSetting("LimitRadius", false);
  ASSERT_TRUE(session->GetSight()->PickSurface(from_W.data(), to_W.data(), ball_W.data(), normal_W.data()));
  EXPECT_NEAR(ball_W.z(), radius + 2 * limit, sagitta);
}

TEST(HapticSessionMouse, ADepthIsWithinWhatTheMouseCanPressOrRefused)
{
  vtkNew<vtkHapticSession> session;
  constexpr double least_m = 5e-5, largest_m = 0.05;
  for (const double depth_m : { least_m, largest_m })
  {
    session->SetSetting("PressDepth", depth_m);
    EXPECT_EQ(session->GetSetting("PressDepth"), depth_m);
  }
  for (const double depth_m : { 0.99 * least_m, 1.01 * largest_m })
  {
    EXPECT_THAT(errorsOf(session, [&] { session->SetSetting("PressDepth", depth_m); }), ::testing::SizeIs(1));
    EXPECT_EQ(session->GetSetting("PressDepth"), largest_m);
    EXPECT_THAT(session->GetProblem(), ::testing::HasSubstr("of m, 5e-05 to 0.05, not"));
  }
}

} // namespace
