// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that move, bend, vanish and are replaced under a hand, in virtual time.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "MovingPlate.h"
#include "VtkScenes.h"
#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/support/Says.h"
#include "vtkHapticConversion.h"
#include "vtkHapticSession.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;

namespace
{

vtkSmartPointer<vtkMatrix4x4> shiftTo(double z)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  matrix->SetElement(2, 3, z);
  return matrix;
}

vtkSmartPointer<vtkMatrix4x4> scaledBy(double x, double y, double z)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  matrix->SetElement(0, 0, x);
  matrix->SetElement(1, 1, y);
  matrix->SetElement(2, 2, z);
  return matrix;
}

/// The square of makePlane() at a height, cut into cells^2 squares along one diagonal or the other.
vtkSmartPointer<vtkPolyData> makeGrid(std::uint32_t cells, bool otherDiagonal, double z)
{
  TriangleMesh mesh;
  for (std::uint32_t row = 0; row <= cells; ++row)
  {
    for (std::uint32_t column = 0; column <= cells; ++column)
    {
      mesh.vertices_W.emplace_back(2 * half * column / cells - half, 2 * half * row / cells - half, z);
    }
  }
  for (std::uint32_t row = 0; row < cells; ++row)
  {
    for (std::uint32_t column = 0; column < cells; ++column)
    {
      const std::uint32_t a = row * (cells + 1) + column, b = a + 1, c = b + cells + 1, d = c - 1;
      mesh.triangles.push_back(otherDiagonal ? std::array{ a, b, d } : std::array{ a, b, c });
      mesh.triangles.push_back(otherDiagonal ? std::array{ b, c, d } : std::array{ a, c, d });
    }
  }
  return vtkHapticToPolyData(mesh);
}

/// Speed of a platform [m/s], up at a hand above it or down at one below.
class Platform
  : public HapticSessionMotion
  , public ::testing::WithParamInterface<double>
{
};
} // namespace

TEST_P(Platform, ThatComesAtARestingHandPushesByItsDepthAndIsNeverPassed)
{
  constexpr double stiffness = 20.0; // the force of the fastest platform rises slower than the rise limit
  constexpr int ticks = 16;          // between snapshots
  const double speed_u_per_s = GetParam() * scale, side = std::copysign(1.0, speed_u_per_s);
  const double start_z = -side * 20.0;
  this->start(stiffness, makePlane(half), shiftTo(start_z), 0.0);
  this->place(shiftTo(start_z)); // the last snapshot at rest: how long the first motion takes
  this->session_->Step(ticks);
  const int snapshots = std::min(60, static_cast<int>(100.0 / std::abs(speed_u_per_s * ticks * period_s)));
  double before_z = start_z;
  for (int n = 1; n <= snapshots; ++n)
  {
    const double now_z = start_z + speed_u_per_s * ticks * period_s * n;
    this->place(shiftTo(now_z));
    for (int tick = 1; tick <= ticks; ++tick)
    {
      this->session_->Step(1);
      const double plate_z = before_z + (now_z - before_z) * tick / ticks; // one snapshot late, never ahead
      const double depth_m = std::max(0.0, side * plate_z) / scale;
      ASSERT_NEAR(side * this->force().z(), stiffness * depth_m, 1e-9) << "snapshot " << n << ", tick " << tick;
      ASSERT_LE(side * plate_z, side * this->proxy_W().z() + 1e-9);
      if (tick < ticks)
      {
        ASSERT_NEAR(this->session_->GetMotionLag(), ticks * period_s, 1e-12);
      }
    }
    before_z = now_z;
  }
  EXPECT_STREQ(this->session_->GetFaultText(), "");
}

INSTANTIATE_TEST_SUITE_P(Speeds, Platform, ::testing::Values(0.02, 0.5, 5.0, -0.5, -5.0));

TEST_F(HapticSessionMotion, ASnapshotThatComesEarlyGoesOnFromWhereThePlateIsFelt)
{
  constexpr double stiffness = 100.0;
  this->start(stiffness, makePlane(half), nullptr, 1.0);
  this->session_->SetHandPosition(0.0, 0.0, -1.0);
  this->session_->Step(200);
  this->place(shiftTo(4.0)); // after a rest: in 0.2 s
  double last_N = this->force().z();
  for (int i = 0; i < 50; ++i)
  {
    this->session_->Step(1);
    EXPECT_NEAR(this->force().z() - last_N, stiffness * 4.0 / scale / 200, 1e-9);
    last_N = this->force().z();
  }
  this->place(shiftTo(5.0)); // 50 ms later, 1 u up: on to there in 50 ms
  for (int i = 0; i < 50; ++i)
  {
    this->session_->Step(1);
    EXPECT_NEAR(this->force().z() - last_N, stiffness * (5.0 - 1.0) / scale / 50, 1e-9);
    last_N = this->force().z();
  }
  EXPECT_NEAR(last_N, stiffness * 6.0 / scale, 1e-9);
}

TEST_F(HapticSessionMotion, AMovedSurfaceAtRestCostsNoMoreThanOneThatNeverMoved)
{
  constexpr double stiffness = 100.0;
  this->start(stiffness, makePlane(half), nullptr, 5.0);
  EXPECT_FALSE(this->session_->GetSceneMoves());
  this->session_->SetHandPosition(0.0, 0.0, 2.0);
  this->session_->Step(10);
  vtkNew<vtkMatrix4x4> pose; // up by 3, turned by the angle of a 3-4-5 triangle
  const double turn[2][2] = { { 0.8, -0.6 }, { 0.6, 0.8 } };
  pose->SetElement(0, 0, turn[0][0]);
  pose->SetElement(0, 1, turn[0][1]);
  pose->SetElement(1, 0, turn[1][0]);
  pose->SetElement(1, 1, turn[1][1]);
  pose->SetElement(2, 3, 3.0);
  this->place(pose);
  EXPECT_TRUE(this->session_->GetSceneMoves());
  const double force_N = stiffness * (3.0 - 2.0) / scale;
  for (int i = 0; i < 1400; ++i)
  {
    this->session_->Step(1);
    if (i > 200)
    {
      ASSERT_NEAR(this->force().z(), force_N, 1e-9);
    }
  }
  this->session_->FinishScene();
  this->session_->Step(100);
  EXPECT_FALSE(this->session_->GetSceneMoves());
  EXPECT_EQ(this->session_->GetMotionLag(), 0.0);
  EXPECT_NEAR(this->force().z(), force_N, 1e-9);
  this->place(shiftTo(4.0)); // and it can move again
  EXPECT_TRUE(this->session_->GetSceneMoves());
  this->session_->Step(250);
  EXPECT_NEAR(this->force().z(), stiffness * (4.0 - 2.0) / scale, 1e-9);
}

TEST_F(HapticSessionMotion, AChangeThatIsNotRigidIsBakedAndTheHandStaysOnItsSide)
{
  constexpr double stiffness = 100.0;
  this->start(stiffness, makePlane(half), shiftTo(1.0), 2.0);
  this->session_->SetHandPosition(0.0, 0.0, -1.0);
  this->session_->Step(100);
  const vtkSmartPointer<vtkMatrix4x4> mirrored = scaledBy(2.0, 0.5, -1.0);
  mirrored->SetElement(2, 3, 3.0);
  this->place(mirrored);
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_FALSE(this->session_->GetSceneMoves());
  double bounds[6];
  ASSERT_TRUE(this->session_->GetSceneBounds(bounds));
  EXPECT_THAT(bounds, ::testing::ElementsAre(-2 * half, 2 * half, -half / 2, half / 2, 3.0, 3.0));
  this->session_->Step(ticksToSettle);
  EXPECT_NEAR(this->force().z(), stiffness * 4.0 / scale, 1e-9);
}

TEST_F(HapticSessionMotion, AMatrixThatPutsASurfaceNowhereIsRefusedByNameAndItStays)
{
  this->start(100.0, makePlane(half), nullptr, 1.0);
  const vtkSmartPointer<vtkMatrix4x4> wild = shiftTo(std::numeric_limits<double>::quiet_NaN());
  const vtkSmartPointer<vtkMatrix4x4> flat = scaledBy(1.0, 1.0, 0.0);
  const vtkSmartPointer<vtkMatrix4x4> perspective = shiftTo(1.0);
  perspective->SetElement(3, 0, 0.5);
  const std::pair<vtkMatrix4x4*, const char*> bad[] = { { wild, "plate: its transform is not finite" },
    { flat, "plate: its transform is singular" }, { perspective, "plate: its transform is a perspective" } };
  for (const auto& [matrix, reason] : bad)
  {
    const auto errors =
      errorsOf(this->session_, [&, m = matrix] { EXPECT_FALSE(this->session_->SetSurfacePose("plate", m)); });
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_THAT(errors[0], HasSubstr(reason));
    EXPECT_THAT(this->session_->GetProblem(), HasSubstr(reason));
  }
  const auto errors =
    errorsOf(this->session_, [&] { EXPECT_FALSE(this->session_->SetSurfacePose("saucer", shiftTo(1.0))); });
  EXPECT_TRUE(test::says(errors.at(0), { "saucer", "no surface of that name" }));
  this->session_->CommitScene();
  ASSERT_TRUE(this->session_->FinishScene());
  double bounds[6];
  ASSERT_TRUE(this->session_->GetSceneBounds(bounds));
  EXPECT_EQ(bounds[5], 0.0);
  EXPECT_FALSE(this->session_->GetSceneMoves());
}

/// Whether the worker is waited for, or works while ticks go on.
class SwapWhilePressed
  : public HapticSessionMotion
  , public ::testing::WithParamInterface<bool>
{
};

TEST_P(SwapWhilePressed, AtTenHertzForAMinuteTheForceStepsByATenthOfANewtonAtMost)
{
  constexpr double stiffness = 500.0, hand_z = -2.0;
  constexpr int swaps = 600, ticks = 100;
  this->start(stiffness, makeGrid(4, false, 0.0), nullptr, 1.0);
  this->session_->SetHandPosition(0.3, 0.2, 1.0);
  this->session_->Step(10);
  this->session_->SetHandPosition(0.3, 0.2, hand_z);
  this->session_->Step(200);
  double last_N = this->force().z(), largestStep_N = 0.0;
  int through = 0;
  for (int swap = 0; swap < swaps; ++swap)
  {
    const vtkSmartPointer<vtkPolyData> next[] = { makeGrid(4, false, 0.0), makeGrid(4, false, 1.0),
      makeGrid(8, false, 0.0), makeGrid(4, true, 0.0) };
    this->show(next[swap % 4]);
    if (GetParam() ||
        swap % 61 == 60) // beside the ticks too, now and then: else a busy computer might show nothing at all
    {
      this->session_->FinishScene();
    }
    for (int i = 0; i < ticks; ++i)
    {
      this->session_->Step(1);
      largestStep_N = std::max(largestStep_N, std::abs(this->force().z() - last_N));
      last_N = this->force().z();
      through += this->proxy_W().z() < -1e-9;
    }
  }
  EXPECT_EQ(through, 0);
  EXPECT_LE(largestStep_N, 0.1);
  EXPECT_GE(largestStep_N, stiffness * 1.0 / scale * period_s / (0.03 + period_s) * 0.5); // 1 mm was felt, blended
  EXPECT_EQ(this->session_->GetCappedTicks(), 0);
  EXPECT_STREQ(this->session_->GetFaultText(), "");
}

INSTANTIATE_TEST_SUITE_P(Worker, SwapWhilePressed, ::testing::Bool(),
  [](const auto& info) { return info.param ? "WaitedFor" : "BesideTheTicks"; });

TEST_F(HapticSessionMotion, TimeStaysVirtualUntilTouchingEndsWhateverIsChosenForTheNextTime)
{
  constexpr int ticks = 16; // between snapshots
  this->start(20.0, makePlane(half), shiftTo(-20.0), 0.0);
  this->place(shiftTo(-20.0));
  this->session_->Step(ticks);
  this->session_->SetSetting("VirtualTime", false);
  this->place(shiftTo(-10.0));
  this->session_->Step(1);
  EXPECT_NEAR(this->session_->GetMotionLag(), ticks * period_s, 1e-12);
  EXPECT_FALSE(this->session_->IsOn("VirtualTime"));
}
