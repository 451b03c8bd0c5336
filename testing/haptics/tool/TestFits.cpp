// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 30, 31, 61: a cube slides over triangles, a peg goes into a slot and jams in it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "Tools.h"
#include "haptics/tool/servo/ToolForce.h"
#include "haptics/tool/worker/ToolFollower.h"
#include "testing/support/Thread.h"

namespace palpate::test
{
namespace
{

constexpr double width_mm = 20.0;

/// Two blocks with a slot of 20 mm and the clearance between them, open at z = 0, along y.
TriangleMesh slot(double clearance_mm)
{
  const double half = 0.5 * (width_mm + clearance_mm);
  TriangleMesh mesh = makeBox(Vec3(-60, -60, -60), Vec3(-half, 60, 0));
  append(mesh, makeBox(Vec3(half, -60, -60), Vec3(60, 60, 0)));
  return mesh;
}

/// The same slot, its mouth widened by 1 mm on both sides within the first mm.
TriangleMesh chamferedSlot(double clearance_mm)
{
  constexpr double chamfer_mm = 1.0;
  TriangleMesh mesh = shifted(slot(clearance_mm), Vec3(0, 0, -chamfer_mm));
  const double half = 0.5 * (width_mm + clearance_mm);
  for (const double side : { -1.0, 1.0 })
  {
    const auto first = static_cast<std::uint32_t>(mesh.vertices_W.size());
    for (const double y : { -60.0, 60.0 })
    {
      mesh.vertices_W.emplace_back(side * half, y, -chamfer_mm);
      mesh.vertices_W.emplace_back(side * (half + chamfer_mm), y, 0.0);
      mesh.vertices_W.emplace_back(side * 60.0, y, 0.0);
    }
    for (const std::uint32_t k : { 0u, 1u })
    {
      mesh.triangles.push_back({ first + k, first + k + 1, first + k + 4 });
      mesh.triangles.push_back({ first + k, first + k + 4, first + k + 3 });
    }
  }
  return mesh;
}

TriangleMesh peg()
{
  return makeBox(Vec3(-0.5 * width_mm, -10, -30), Vec3(0.5 * width_mm, 10, 30));
}

/// The widest tilt of a peg in a slot that it reaches into by `inside`, measured along the peg:
/// W = w cos t + L sin t, by bisection.
double widestTilt(double clearance_mm, double inside_mm)
{
  double low = 0.0, high = std::atan(inside_mm / width_mm);
  for (int i = 0; i < 200; ++i)
  {
    const double middle = 0.5 * (low + high);
    const double wide = width_mm * std::cos(middle) + inside_mm * std::sin(middle);
    (wide < width_mm + clearance_mm ? low : high) = middle;
  }
  return low;
}

/// How far the peg reaches in, from the corner of the mouth that its side touches, along the peg.
double insideOf(const Pose& at_W, double clearance_mm, double mouth_mm)
{
  const Mat3 turn = at_W.q.toRotationMatrix();
  const Vec3 mouth(0.5 * (width_mm + clearance_mm), 0, mouth_mm), other(-mouth.x(), 0, mouth_mm);
  return 30.0 + std::max((turn.transpose() * (mouth - at_W.p)).z(), (turn.transpose() * (other - at_W.p)).z());
}

bool pressedFromBothSides(const ToolMove& move)
{
  bool left = false, right = false;
  for (const TouchRow& row : move.rows())
  {
    left = left || row.plane.n_W.x() > 0.5;
    right = right || row.plane.n_W.x() < -0.5;
  }
  return left && right;
}

} // namespace

TEST(Fits, ACubeOnTrianglesSlidesWithoutAnyForceAlongThemAtAnyScaleRow30)
{
  constexpr double stiffness_N_per_u = 1000.0;
  for (const double scale : { 1e-3, 1.0, 1e3 })
  {
    Random random(testSeed(3001));
    const double half = 20.0 * scale;
    const TriangleMesh plane = makeSheet({ 400.0 * scale, 400.0 * scale, 100, 100, 0.3 }, random);
    const ToolMesh tool = makeTool(makeBox(Vec3::Constant(-half), Vec3::Constant(half))).value;
    ToolMove move(tool, makeToolScene(cleanMesh(plane).mesh, tool), tool.gyration_u);
    ASSERT_EQ(move.place({ Vec3(0, 0, 1.1 * half), Quat::Identity() }), "");
    const double depth = 0.1 * half;
    for (int i = 0; i < 60; ++i)
    {
      const Pose device_W{ Vec3(0.11 * half * i - 3.3 * half, 0.03 * half * i, half - depth),
        turnBy(Vec3(0, 0, 0.01 * i)) };
      ASSERT_TRUE(settle(move, device_W));
      const Vec3 force_N = stiffness_N_per_u / scale * (move.pose_W().p - device_W.p);
      EXPECT_LE(force_N.head<2>().norm(), 1e-12 * force_N.z()) << "tick " << i << " scale " << scale;
      EXPECT_NEAR(force_N.z(), stiffness_N_per_u / scale * (depth + tool.restGap_u()), 1e-7 * force_N.z());
    }
  }
}

TEST(Fits, APegGoesIntoASlotThatIsWiderBy50MicrometresRow31)
{
  for (const double clearance_mm : { 0.05, 0.2 })
  {
    JudgedTool judged(peg(), slot(clearance_mm), 8);
    ASSERT_EQ(judged.move.place({ Vec3(0, 0, 31), Quat::Identity() }), "");
    Pose hand_W;
    for (int i = 0; i <= 100; ++i)
    {
      // Off by a tenth of the clearance and tilted by as much as the clearance lets a peg of 60 mm be, and less.
      hand_W = { Vec3(0.1 * clearance_mm, 0, 31 - 0.4 * i), turnBy(Vec3(0, 0.3 * clearance_mm / 60.0, 0)) };
      judged.move.update(hand_W, plenty);
    }
    EXPECT_TRUE(settle(judged.move, hand_W));
    EXPECT_LE((judged.move.pose_W().p - hand_W.p).norm(), 1e-4);
    EXPECT_EQ(judged.judge.found(), 0u) << "of " << judged.judge.judged();
  }
}

TEST(Fits, APegOf60MillimetresTurnedAboutItsMiddleGoesInAtTheTiltThatTheMouthAllowsAndWedgesBeyondRow61)
{
  constexpr double clearance_mm = 0.05, half_mm = 30.0, down_mm = 20.0;
  const double allowed = std::atan(0.5 * clearance_mm / half_mm); // 0.04775 degrees
  for (const double tilt : { 0.0470 * degree_rad, 0.0485 * degree_rad })
  {
    JudgedTool judged(peg(), slot(clearance_mm), 8);
    ASSERT_EQ(judged.move.place({ Vec3(0, 0, 31), turnBy(Vec3(0, tilt, 0)) }), "");
    for (int i = 0; i <= 40; ++i)
    {
      judged.move.update({ Vec3(0, 0, 31 - 0.525 * i), turnBy(Vec3(0, tilt, 0)) }, plenty);
    }
    const Pose hand_W{ Vec3(0, 0, half_mm - down_mm), turnBy(Vec3(0, tilt, 0)) };
    EXPECT_TRUE(settle(judged.move, hand_W));
    const double deep_mm = half_mm - judged.move.pose_W().p.z();
    if (tilt < allowed)
    {
      EXPECT_NEAR(deep_mm, down_mm, 1e-4);
    }
    else
    {
      EXPECT_LT(deep_mm, 0.5 * down_mm);
    }
    EXPECT_EQ(judged.judge.found(), 0u);
  }
}

TEST(Fits, WithAChamferOf1MillimetreAPegGoesInFromHalfAMillimetreAndOneDegreeOffAndJamsAtItsWidestTiltRow61)
{
  constexpr double clearance_mm = 0.05, inside_mm = 28.7, chamfer_mm = 1.0;
  JudgedTool judged(peg(), chamferedSlot(clearance_mm), 0);
  const Quat tilted = turnBy(Vec3(0, degree_rad, 0));
  ASSERT_EQ(judged.move.place({ Vec3(0.5, 0, 32), tilted }), "");
  Pose hand_W{ Vec3(0.5, 0, 32), tilted };
  for (; hand_W.p.z() > 30.0 - chamfer_mm - inside_mm; hand_W.p.z() -= 0.25)
  {
    judged.move.update(hand_W, plenty);
  }
  ASSERT_TRUE(settle(judged.move, hand_W));
  const Pose& at_W = judged.move.pose_W();
  const double deep_mm = 30.0 - chamfer_mm - at_W.p.z();
  EXPECT_GT(deep_mm, 0.9 * inside_mm) << "it is in";
  EXPECT_TRUE(pressedFromBothSides(judged.move));
  const double tilt = rotationVector(at_W.q).y();
  // Along the peg, from the narrow mouth's corner that its side touches.
  const double inside = insideOf(at_W, clearance_mm, -chamfer_mm);
  EXPECT_NEAR(tilt, widestTilt(clearance_mm - 2.0 * judged.tool.restGap_u(), inside), 1e-4 * tilt);
  EXPECT_NEAR(tilt, 0.0996 * degree_rad, 0.03 * 0.0996 * degree_rad) << "th_max(28.7 mm); it is in by " << inside;
  EXPECT_EQ(judged.judge.found(), 0u);
}

TEST(Fits, ANutThatIsPulledAlongItsScrewComesToRestWithTheUsualWorkOfAnUpdate)
{
  const ThreadSize screw{ 5.0, 2.0, 16.0 }, bore{ 5.2, 2.0, 5.0 };
  JudgedTool judged(threadMesh(bore, 64), threadMesh(screw, 64), 0);
  judged.judge.sparse(50);
  const Pose start_W{ judged.tool.centre_W, Quat::Identity() };
  ASSERT_EQ(judged.move.place(start_W), "");
  ToolUpdate last;
  for (int i = 1; i <= 60; ++i)
  {
    const Pose hand_W{ start_W.p + Vec3(0, 0, 0.03 * std::min(i, 50)), Quat::Identity() };
    last = judged.move.update(hand_W, ToolFollower::usualWork);
  }
  EXPECT_TRUE(last.converged) << "spent " << last.spent;
  // Flanks of 45 degrees give as much along the axis as along the radius, and a turn leads it on by hundredths.
  EXPECT_NEAR(judged.move.pose_W().p.z() - start_W.p.z(), 0.2, 0.01);
  EXPECT_EQ(judged.judge.found(), 0u);
}

TEST(Fits, APegInASlotTurnsUntilItsCornersJamRow31)
{
  int jammed = 0;
  for (const double clearance_mm : { 0.05, 0.1, 0.2, 0.5 })
  {
    for (const double depth_mm : { 10.0, 20.0, 40.0 })
    {
      JudgedTool judged(peg(), slot(clearance_mm), 0);
      ASSERT_EQ(judged.move.place({ Vec3(0, 0, 30 - depth_mm), Quat::Identity() }), "");
      const Pose hand_W{ Vec3(0, 0, 30 - depth_mm), turnBy(Vec3(0, 10 * degree_rad, 0)) };
      ASSERT_TRUE(settle(judged.move, hand_W)) << clearance_mm << " " << depth_mm;
      const Pose& at_W = judged.move.pose_W();
      const double tilt = rotationVector(at_W.q).y();
      const double inside = insideOf(at_W, clearance_mm, 0.0);
      if (pressedFromBothSides(judged.move)) // else it was levered out until it fits
      {
        ++jammed;
        const double left_mm = clearance_mm - 2.0 * judged.tool.restGap_u();
        EXPECT_NEAR(tilt, widestTilt(left_mm, inside), 1e-4 * tilt) << clearance_mm << " " << depth_mm;
      }
      EXPECT_EQ(judged.judge.found(), 0u);
    }
  }
  EXPECT_GE(jammed, 9);
}

} // namespace palpate::test
