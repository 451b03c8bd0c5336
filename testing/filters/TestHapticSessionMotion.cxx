// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that move, bend, vanish and are replaced under a hand, in virtual time.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/support/Says.h"
#include "vtkCellArray.h"
#include "vtkHapticConversion.h"
#include "vtkHapticSession.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
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

class HapticSessionMotion : public ::testing::Test
{
protected:
  void start(double stiffness_N_per_m, vtkPolyData* surface, vtkMatrix4x4* matrix, double hand_z)
  {
    this->session_->SetSetting("VirtualTime", true);
    this->session_->SetSetting("Stiffness", stiffness_N_per_m);
    this->session_->SetSetting("Scale", scale);
    this->show(surface, matrix);
    ASSERT_TRUE(this->session_->FinishScene());
    this->session_->SetHandPosition(0.0, 0.0, hand_z);
    this->session_->TouchingOn();
    ASSERT_TRUE(this->session_->GetTouching()) << this->session_->GetProblem();
    this->session_->Step(ticksToEngage);
  }

  void show(vtkPolyData* surface, vtkMatrix4x4* matrix = nullptr)
  {
    this->session_->ClearSurfaces();
    ASSERT_TRUE(this->session_->AddSurface("plate", surface, matrix)) << this->session_->GetProblem();
    this->session_->CommitScene();
  }

  void place(vtkMatrix4x4* matrix)
  {
    ASSERT_TRUE(this->session_->SetSurfacePose("plate", matrix)) << this->session_->GetProblem();
    this->session_->CommitScene();
    this->session_->Update();
  }

  [[nodiscard]] Vec3 force() const { return Vec3(this->session_->GetForce()); }
  [[nodiscard]] Vec3 proxy_W() const { return Vec3(this->session_->GetProxyPosition()); }

  vtkNew<vtkHapticSession> session_;
};

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

TEST_F(HapticSessionMotion, TheHandGoesWithATimeSeriesOfTheSameTriangles)
{
  constexpr double stiffness = 100.0;
  const Vec3 hand_W(3.0, 20.0, -2.0);
  this->start(stiffness, makePlane(half, 0.1), nullptr, 5.0);
  this->session_->SetHandPosition(hand_W.x(), hand_W.y(), 5.0);
  this->session_->Step(100);
  this->session_->SetHandPosition(hand_W.data());
  this->session_->Step(100);
  for (const double tilt : { 0.2, 0.4, 0.1, 0.4 }) // of z = tilt y, one time step after another and back
  {
    this->show(makePlane(half, tilt));
    ASSERT_TRUE(this->session_->FinishScene());
    EXPECT_THAT(this->session_->GetSceneReport(), HasSubstr("refitted"));
    this->session_->Step(ticksToSettle);
    const Vec3 normal = Vec3(0.0, -tilt, 1.0).normalized();
    const double depth_m = -normal.dot(hand_W) / scale;
    ASSERT_GT(depth_m, 0.0);
    EXPECT_LT((this->force() - stiffness * depth_m * normal).norm(), 1e-9) << "tilt " << tilt;
  }
}

TEST_F(HapticSessionMotion, BetweenTwoTimeStepsTheSurfaceIsFeltOnItsStraightWayInEveryTick)
{
  constexpr double stiffness = 100.0;
  constexpr int ticks = 50; // a time step at 20 Hz
  const Vec3 hand_W(3.0, 20.0, -2.0);
  this->start(stiffness, makePlane(half, 0.1), nullptr, 5.0);
  this->session_->SetHandPosition(hand_W.x(), hand_W.y(), 5.0);
  this->session_->Step(100);
  this->session_->SetHandPosition(hand_W.data());
  this->session_->Step(ticksToSettle);
  this->show(makePlane(half, 0.1)); // the last one at rest: how long the first way takes
  ASSERT_TRUE(this->session_->FinishScene());
  this->session_->Step(ticks);
  double begin = 0.1;
  for (const double end : { 0.12, 0.2, 0.15, 0.15, 0.05 })
  {
    this->show(makePlane(half, end));
    ASSERT_TRUE(this->session_->FinishScene());
    for (int i = 1; i <= ticks; ++i)
    {
      this->session_->Step(1);
      const double tilt = begin + (end - begin) * i / ticks;
      const Vec3 normal = Vec3(0.0, -tilt, 1.0).normalized();
      const double depth_m = -normal.dot(hand_W) / scale;
      ASSERT_LT((this->force() - stiffness * depth_m * normal).norm(), 1e-9) << "to tilt " << end << ", tick " << i;
    }
    begin = end;
  }
  this->session_->Step(1200); // at rest for more than a second: the tree has no room for ways any more
  this->session_->FinishScene();
  this->session_->Step(10);
  EXPECT_FALSE(this->session_->GetSceneMoves());
  const Vec3 normal = Vec3(0.0, -begin, 1.0).normalized();
  EXPECT_LT((this->force() - stiffness * (-normal.dot(hand_W) / scale) * normal).norm(), 1e-9);
}

namespace
{
/// One frame of an actor that moves while its mesh deforms.
struct Frame
{
  double tilt = 0.0;      ///< its mesh is the plane z = tilt y
  double angle_rad = 0.0; ///< its actor is turned by about z
  Vec3 shift_W = Vec3::Zero();
};

vtkSmartPointer<vtkMatrix4x4> matrixOf(const Frame& frame)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  const double c = std::cos(frame.angle_rad), s = std::sin(frame.angle_rad);
  const double turn[2][2] = { { c, -s }, { s, c } };
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; row < 2 && column < 2; ++column)
    {
      matrix->SetElement(row, column, turn[row][column]);
    }
    matrix->SetElement(row, 3, frame.shift_W[row]);
  }
  return matrix;
}

/// Between two frames: everything evenly but the turn, which is that of the mean of two unit quaternions about z.
Frame between(const Frame& begin, const Frame& end, double share)
{
  const auto even = [share](const auto& a, const auto& b) { return (1.0 - share) * a + share * b; };
  const double half_rad = std::atan2(even(std::sin(begin.angle_rad / 2), std::sin(end.angle_rad / 2)),
    even(std::cos(begin.angle_rad / 2), std::cos(end.angle_rad / 2)));
  return { even(begin.tilt, end.tilt), 2 * half_rad, even(begin.shift_W, end.shift_W) };
}

/// On a resting hand [N].
Vec3 forceOf(const Frame& frame, double stiffness_N_per_m, const Vec3& hand_W)
{
  const Vec3 n = Vec3(0.0, -frame.tilt, 1.0).normalized();
  const double c = std::cos(frame.angle_rad), s = std::sin(frame.angle_rad);
  const Vec3 normal_W(c * n.x() - s * n.y(), s * n.x() + c * n.y(), n.z());
  return stiffness_N_per_m * normal_W.dot(frame.shift_W - hand_W) / scale * normal_W;
}
} // namespace

/// Whether a script has moved the actor before its mesh begins to deform.
class MovingActor
  : public HapticSessionMotion
  , public ::testing::WithParamInterface<bool>
{
};

TEST_P(MovingActor, WhoseMeshDeformsInTheSameFramesIsFeltUnderBothInEveryTick)
{
  constexpr double stiffness = 100.0;
  constexpr int ticks = 50; // a time step at 20 Hz
  const Vec3 hand_W(3.0, 20.0, -2.0);
  Frame begin{ 0.1, 0.2 }; // at the origin: what moves is W as it was baked, and turns about that
  this->start(stiffness, makePlane(half, begin.tilt), GetParam() ? nullptr : matrixOf(begin).Get(), 15.0);
  if (GetParam())
  {
    this->place(matrixOf(begin));
  }
  this->session_->SetHandPosition(hand_W.x(), hand_W.y(), 15.0);
  this->session_->Step(300);
  this->session_->SetHandPosition(hand_W.data());
  this->session_->Step(300);
  this->show(makePlane(half, begin.tilt), matrixOf(begin)); // the last one at rest: how long the first way takes
  ASSERT_TRUE(this->session_->FinishScene());
  this->session_->Step(ticks);
  const Frame frames[] = { { 0.12, 0.3, { 2.5, 1.0, 0.8 } }, { 0.2, 0.7, { 1.0, 0.0, 1.5 } },
    { 0.15, 0.7, { 1.0, 0.0, 1.5 } }, { 0.15, 0.4, { 0.0, -2.0, 1.0 } }, { 0.05, -0.1, { 3.0, 0.0, 0.2 } } };
  for (const Frame& end : frames)
  {
    this->show(makePlane(half, end.tilt), matrixOf(end));
    ASSERT_TRUE(this->session_->FinishScene());
    for (int i = 1; i <= ticks; ++i)
    {
      this->session_->Step(1);
      const Vec3 expected = forceOf(between(begin, end, static_cast<double>(i) / ticks), stiffness, hand_W);
      ASSERT_LT((this->force() - expected).norm(), 1e-9) << "to angle " << end.angle_rad << ", tick " << i;
    }
    begin = end;
  }
  this->session_->Step(1200); // at rest for more than a second: poses are baked, and felt where they were
  this->session_->FinishScene();
  this->session_->Step(10);
  EXPECT_FALSE(this->session_->GetSceneMoves());
  EXPECT_LT((this->force() - forceOf(begin, stiffness, hand_W)).norm(), 1e-9);
  EXPECT_STREQ(this->session_->GetFaultText(), "");
}

INSTANTIATE_TEST_SUITE_P(ByAScript, MovingActor, ::testing::Bool());

TEST_F(HapticSessionMotion, ATimeSeriesOfPolygonsKeepsItsTriangles)
{
  const auto squares = [](double shear)
  {
    const vtkSmartPointer<vtkPolyData> surface = makePlane(half);
    vtkNew<vtkCellArray> polygons;
    polygons->InsertNextCell({ 0, 1, 2, 3 });
    surface->SetPolys(polygons);
    for (vtkIdType i = 0; i < 4; ++i)
    {
      Vec3 p(surface->GetPoint(i));
      p.x() += shear * p.y();
      surface->GetPoints()->SetPoint(i, p.data());
    }
    return surface;
  };
  this->start(100.0, squares(0.4), nullptr, 5.0);
  this->show(squares(-0.4)); // its shorter diagonal is the other one
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_THAT(this->session_->GetSceneReport(), HasSubstr("refitted"));
}

TEST_F(HapticSessionMotion, AnEmptyTimeStepLetsGoWithASentenceAndTheSurfaceComesBack)
{
  constexpr double stiffness = 100.0;
  this->start(stiffness, makePlane(half), nullptr, 1.0);
  this->session_->SetHandPosition(0.0, 0.0, -2.0);
  this->session_->Step(100);
  ASSERT_GT(this->force().z(), 0.1);
  this->session_->ClearSurfaces();
  vtkNew<vtkPolyData> empty;
  const auto errors =
    errorsOf(this->session_, [&] { EXPECT_FALSE(this->session_->AddSurface("plate", empty, nullptr)); });
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_THAT(errors[0], HasSubstr("plate: it has no polygons"));
  this->session_->CommitScene();
  EXPECT_FALSE(this->session_->FinishScene());
  EXPECT_TRUE(test::says(this->session_->GetSceneReport(), { "not touched: plate", "no polygons" }));
  this->session_->Step(60); // the ramp takes 50 ms
  EXPECT_EQ(this->session_->GetForceMagnitude(), 0.0);
  EXPECT_STRNE(this->session_->GetFaultText(), "");
  this->session_->SetHandPosition(0.0, 0.0, 1.0);
  this->session_->Step(10);
  this->show(makePlane(half));
  ASSERT_TRUE(this->session_->FinishScene());
  this->session_->Step(ticksToEngage);
  EXPECT_STREQ(this->session_->GetFaultText(), "");
  this->session_->SetHandPosition(0.0, 0.0, -2.0);
  this->session_->Step(100);
  EXPECT_NEAR(this->force().z(), stiffness * 2.0 / scale, 1e-9);
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
