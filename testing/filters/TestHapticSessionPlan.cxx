// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces finer than a hand feels: all of their triangles first, fewer later, in virtual time.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "testing/support/Says.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

namespace
{
constexpr int fine = 180, coarse = 24;
constexpr int cells = 100;

/// Of makeSphere(): two fans at the poles and two triangles for each quad between them.
std::string trianglesOf(int resolution)
{
  return std::to_string(2 * resolution * (resolution - 2));
}

/// How far the longest edge, a diagonal at the equator, runs inside the sphere, at most.
double sagitta(int resolution)
{
  const double side =
    1.1 * 2 * std::numbers::pi * sphereRadius / resolution; // rows are some more than half a turn / n apart
  return 2 * side * side / (8 * sphereRadius);
}

/// A flat square of cells^2 squares.
vtkSmartPointer<vtkPolyData> makeSheet()
{
  vtkNew<vtkPlaneSource> source;
  source->SetXResolution(cells);
  source->SetYResolution(cells);
  source->SetOrigin(-sphereRadius, -sphereRadius, 0.0);
  source->SetPoint1(sphereRadius, -sphereRadius, 0.0);
  source->SetPoint2(-sphereRadius, sphereRadius, 0.0);
  source->Update();
  return source->GetOutput();
}

class HapticSessionPlan : public VirtualSession
{
protected:
  void SetUp() override { this->session_->SetHandPosition(this->handAt(0.0, sphereRadius + 5.0).data()); }

  /// Its scene is not waited for.
  void commit(vtkPolyData* surface)
  {
    this->session_->ClearSurfaces();
    ASSERT_TRUE(this->session_->AddSurface("sphere", surface, nullptr)) << this->session_->GetProblem();
    this->session_->CommitScene();
  }

  /// Presses this deep.
  void touch(double depth)
  {
    this->startTouching();
    this->session_->Step(ticksToEngage);
    this->session_->SetHandPosition(this->handAt(0.0, sphereRadius - depth).data());
    this->session_->Step(ticksToSettle);
  }

  /// A point of a plane that goes through no edge.
  static Vec3 handAt(double angle, double r) { return r * Vec3(std::cos(angle), std::sin(angle), 0.3).normalized(); }

  [[nodiscard]] double force_N() const { return this->session_->GetForceMagnitude(); }
  [[nodiscard]] std::string sentence() const { return this->session_->GetPlanText(); }
};
} // namespace

TEST_F(HapticSessionPlan, APressedFineSphereIsFeltWithAllItsTrianglesFirstAndWithFewerLaterAndNobodyCanTell)
{
  constexpr double depth = 2.0;
  const double wall_N = stiffness * depth / scale;
  this->commit(makeSphere(sphereRadius, fine));
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_THAT(this->sentence(), StartsWith("all " + trianglesOf(fine) + " triangles are used (a simpler surface is"));
  this->touch(depth);
  const double full_N = this->force_N();
  EXPECT_NEAR(full_N, wall_N, stiffness * sagitta(fine) / scale);
  ASSERT_TRUE(this->session_->FinishSimplification()) << this->sentence();
  EXPECT_THAT(this->sentence(), HasSubstr(" of " + trianglesOf(fine) + " triangles are used (proven"));
  EXPECT_LE(2 * std::stoi(this->sentence()), std::stoi(trianglesOf(fine)));
  EXPECT_THAT(this->session_->GetSceneReport(), HasSubstr("sphere: " + std::to_string(std::stoi(this->sentence()))));

  // Two surfaces of which no point is further from the other are everywhere as far off, but for that.
  double last_N = full_N, largestStep_N = 0.0, furthest_N = 0.0;
  for (int tick = 0; tick < ticksToSettle + 1000; ++tick)
  {
    const double angle = 5e-4 * std::max(0, tick - ticksToSettle); // 25 mm along the sphere, once it has blended
    this->session_->SetHandPosition(this->handAt(angle, sphereRadius - depth).data());
    this->session_->Step(1);
    largestStep_N = std::max(largestStep_N, std::abs(this->force_N() - last_N));
    last_N = this->force_N();
    furthest_N = std::max(furthest_N, std::abs(last_N - full_N));
    ASSERT_NEAR(last_N, wall_N, stiffness * (notNoticed + sagitta(fine)) / scale) << "tick " << tick;
    ASSERT_GE(Vec3(this->session_->GetProxyPosition()).norm(), sphereRadius - notNoticed - sagitta(fine)) << tick;
  }
  EXPECT_LE(furthest_N, 0.07 * full_N); // of the force before: nobody notices less
  EXPECT_LE(largestStep_N, 0.1);
  EXPECT_EQ(this->session_->GetCappedTicks(), 0);
  EXPECT_STREQ(this->session_->GetFaultText(), "");
}

TEST_F(HapticSessionPlan, TheSameDataAgainAreSimplerAtOnceAndOtherDataAreNot)
{
  const vtkSmartPointer<vtkPolyData> sphere = makeSphere(sphereRadius, fine);
  this->commit(sphere);
  ASSERT_TRUE(this->session_->FinishScene());
  ASSERT_TRUE(this->session_->FinishSimplification()) << this->sentence();
  const std::string before = this->sentence();
  this->commit(sphere);
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_EQ(this->sentence(), before);
  this->commit(makeSphere(sphereRadius, fine + 1));
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_THAT(this->sentence(), StartsWith("all " + trianglesOf(fine + 1) + " triangles"));
}

TEST_F(HapticSessionPlan, TheNewestCommitCancelsWhatIsLookedForAndOnlyItsOwnSimplerSurfaceIsFelt)
{
  constexpr double depth = 2.0, shrinks = 1.0;
  this->commit(makeSphere(sphereRadius + shrinks, fine + 1));
  ASSERT_TRUE(this->session_->FinishScene());
  this->touch(depth);
  this->commit(makeSphere(sphereRadius, fine));
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_THAT(this->sentence(), StartsWith("all " + trianglesOf(fine) + " triangles"));
  ASSERT_TRUE(this->session_->FinishSimplification()) << this->sentence();
  EXPECT_THAT(this->sentence(), HasSubstr(" of " + trianglesOf(fine) + " triangles are used"));
  this->session_->Step(ticksToSettle);
  EXPECT_NEAR(this->force_N(), stiffness * depth / scale, stiffness * (notNoticed + sagitta(fine)) / scale);
}

TEST_F(HapticSessionPlan, OffKeepsEveryTriangleAndSwitchedOffTheyAllComeBack)
{
  this->session_->SetSetting("Simplify", vtkHapticSession::Off);
  this->commit(makeSphere(sphereRadius, fine));
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_FALSE(this->session_->FinishSimplification());
  const std::string all = "all " + trianglesOf(fine) + " triangles are used (simpler surfaces are off)";
  EXPECT_THAT(this->sentence(), StartsWith(all));
  this->session_->SetSetting("Simplify", vtkHapticSession::Auto);
  ASSERT_TRUE(this->session_->FinishSimplification()) << this->sentence();
  EXPECT_THAT(this->sentence(), Not(StartsWith("all")));
  this->session_->SetSetting("Simplify", vtkHapticSession::Off);
  EXPECT_THAT(this->sentence(), StartsWith(all));
  EXPECT_THAT(this->session_->GetSceneReport(), Not(HasSubstr("proven")));
}

TEST_F(HapticSessionPlan, ASmallSurfaceIsLeftAsItIsUnlessAskedFor)
{
  const std::string triangles = std::to_string(2 * cells * cells);
  this->commit(makeSheet());
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_FALSE(this->session_->FinishSimplification());
  EXPECT_TRUE(test::says(this->sentence(), { "surfaces", "worthwhile", "50000 triangles" }));
  this->session_->SetSetting("Simplify", vtkHapticSession::On);
  EXPECT_TRUE(this->session_->FinishSimplification());
  EXPECT_THAT(this->sentence(), HasSubstr(" of " + triangles + " triangles are used"));
  this->session_->SetSetting("Scale", scale / 10); // an unnoticed difference is felt ten times larger
  this->session_->Update();
  EXPECT_THAT(
    this->sentence(), StartsWith("all " + triangles + " triangles are used (a simpler surface is looked for"));
  EXPECT_TRUE(this->session_->FinishSimplification());
}

TEST_F(HapticSessionPlan, ASurfaceWhoseFacetsAreFeltIsLeftAsItIs)
{
  this->session_->SetSetting("Simplify", vtkHapticSession::On);
  this->commit(makeSphere(sphereRadius, coarse));
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_FALSE(this->session_->FinishSimplification());
  EXPECT_THAT(this->sentence(),
    StartsWith("all " + trianglesOf(coarse) + " triangles are used (its facets are no finer than a hand feels)"));
}

TEST_F(HapticSessionPlan, WhatMovesOrHasMaterialFromArraysIsTouchedAsItIs)
{
  this->session_->SetSetting("Simplify", vtkHapticSession::On);
  this->commit(makeSphere(sphereRadius, coarse));
  ASSERT_TRUE(this->session_->FinishScene());
  this->commit(makeSphere(sphereRadius + 1.0, coarse)); // a time step of the same triangles
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_THAT(this->session_->GetSceneReport(), HasSubstr("refitted"));
  EXPECT_FALSE(this->session_->FinishSimplification());
  EXPECT_TRUE(test::says(this->sentence(), { "deforming", "surfaces", "simplified" }));
  this->session_->SetSetting("FrictionArray", "Normals");
  this->commit(makeSphere(sphereRadius, coarse + 1));
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_FALSE(this->session_->FinishSimplification());
  EXPECT_THAT(this->sentence(), HasSubstr("(its material comes from arrays)"));
}

TEST_F(HapticSessionPlan, ABallIsNoLargerThanItsWorkAllowsUnlessItIsForced)
{
  constexpr double depth = 2.0;
  EXPECT_TRUE(std::isinf(this->session_->GetRadiusLimit()));
  this->session_->SetSetting("Simplify", vtkHapticSession::Off);
  this->commit(makeSphere(sphereRadius, fine));
  ASSERT_TRUE(this->session_->FinishScene());
  const double limit = this->session_->GetRadiusLimit();
  ASSERT_TRUE(std::isfinite(limit));
  this->session_->SetSetting("Radius", limit);
  EXPECT_EQ(this->session_->GetRadiusUsed(), limit);
  EXPECT_THAT(this->sentence(), HasSubstr(" u (as set; up to "));
  this->session_->SetSetting("Radius", 2 * limit);
  EXPECT_EQ(this->session_->GetSetting("Radius"), 2 * limit);
  EXPECT_EQ(this->session_->GetRadiusUsed(), limit);
  EXPECT_TRUE(test::says(this->sentence(), { "is set", "exceed the work of a tick" }));

  // The centre of the ball that really touches rests so far off the sphere.
  const auto rest = [this] { return Vec3(this->session_->GetProxyPosition()).norm() - sphereRadius; };
  this->session_->SetHandPosition(this->handAt(0.0, sphereRadius + 3 * limit).data());
  this->touch(depth);
  EXPECT_NEAR(rest(), limit, sagitta(fine));
  this->session_->SetSetting("LimitRadius", false);
  this->session_->Step(ticksToSettle);
  EXPECT_EQ(this->session_->GetRadiusUsed(), 2 * limit);
  EXPECT_THAT(this->sentence(), HasSubstr(" u (as set and forced; above "));
  EXPECT_NEAR(rest(), 2 * limit, sagitta(fine));
  this->session_->SetSetting("LimitRadius", true);
  this->session_->Step(ticksToSettle);
  EXPECT_NEAR(rest(), limit, sagitta(fine));
  EXPECT_STREQ(this->session_->GetFaultText(), "");
}

TEST_F(HapticSessionPlan, APressedBallGrowsAndShrinksWithWhatTheSceneAllows)
{
  constexpr double depth = 2.0;
  constexpr double soft = 100.0; // far below the device's largest force
  this->session_->SetSetting("Simplify", vtkHapticSession::Off);
  this->session_->SetSetting("Stiffness", soft);
  this->commit(makeSphere(sphereRadius, fine));
  ASSERT_TRUE(this->session_->FinishScene());
  const double limit = this->session_->GetRadiusLimit(), asked = 2 * limit;
  this->session_->SetSetting("Radius", asked);
  this->session_->SetHandPosition(this->handAt(0.0, sphereRadius + 3 * asked).data());
  this->touch(depth);
  const auto rest = [this] { return Vec3(this->session_->GetProxyPosition()).norm() - sphereRadius; };
  for (const int resolution : { coarse, fine, coarse })
  {
    this->commit(makeSphere(sphereRadius, resolution));
    ASSERT_TRUE(this->session_->FinishScene());
    this->session_->Step(1); // the swap; then the ball follows
    this->session_->Step(ticksToSettle);
    const double used = resolution == fine ? limit : asked;
    ASSERT_GE(this->session_->GetRadiusLimit(), used);
    EXPECT_EQ(this->session_->GetRadiusUsed(), used);
    EXPECT_NEAR(rest(), used, sagitta(resolution));
    EXPECT_NEAR(this->force_N(), soft * (depth + used) / scale, soft * sagitta(resolution) / scale);
    EXPECT_STREQ(this->session_->GetFaultText(), "");
  }
}

TEST_F(HapticSessionPlan, ARadiusThatIsNoneIsRefusedWhateverTheLimit)
{
  this->commit(makeSphere(sphereRadius, fine));
  ASSERT_TRUE(this->session_->FinishScene());
  this->session_->SetSetting("Radius", 0.5);
  for (const double bad : { -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    EXPECT_EQ(errorsOf(this->session_, [this, bad] { this->session_->SetSetting("Radius", bad); }).size(), 1u) << bad;
    EXPECT_EQ(this->session_->GetSetting("Radius"), 0.5);
    EXPECT_EQ(this->session_->GetRadiusUsed(), 0.5);
  }
}

TEST_F(HapticSessionPlan, TheSentenceSaysWhatTouchesAndAChoiceThatIsNoneIsRefused)
{
  EXPECT_EQ(this->sentence(), "no rigid surface is touched");
  this->commit(makePlane(sphereRadius));
  ASSERT_TRUE(this->session_->FinishScene());
  EXPECT_THAT(this->sentence(), StartsWith("all 2 triangles are used"));
  EXPECT_TRUE(test::says(this->sentence(), { "radius", "friction", "8 triangles" }));
  this->session_->SetSetting("Radius", 1.5);
  this->session_->SetSetting("FrictionStatic", 0.5);
  this->session_->SetSetting("FrictionKinetic", 0.25);
  EXPECT_TRUE(test::says(this->sentence(), { "1.5 u", "computed", "friction", "0.5", "0.25" }));
  const auto errors = errorsOf(this->session_, [this] { this->session_->SetSetting("Simplify", 3); });
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_TRUE(test::says(errors[0], { "simpler surfaces", "0 (auto)", "1 (off)", "2 (on)" }));
  EXPECT_EQ(static_cast<int>(this->session_->GetSetting("Simplify")), vtkHapticSession::Auto);
}
