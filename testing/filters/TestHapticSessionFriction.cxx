// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace
{
constexpr double normal_N = stiffness * depth / scale;
constexpr double statical = 0.5;
constexpr double kinetic = 0.3;

/// A fed hand in virtual time, pressed at the origin into the plane z = 0.
class HapticSessionFriction : public VirtualSession
{
protected:
  void SetUp() override { this->show(makePlane(100.0)); }

  void press()
  {
    this->session_->SetHandPosition(0.0, 0.0, 1.0);
    this->startTouching();
    this->session_->Step(ticksToEngage);
    this->session_->SetHandPosition(0.0, 0.0, -depth);
    this->session_->Step(100);
    ASSERT_NEAR(this->session_->GetForce()[2], normal_N, 1e-12);
  }

  /// A tick with the hand at x [u], as deep as before; the force against the motion [N].
  double dragTo(double x)
  {
    this->session_->SetHandPosition(x, 0.0, -depth);
    this->session_->Step(1);
    EXPECT_NEAR(this->session_->GetForce()[2], normal_N, 1e-12);
    EXPECT_NEAR(this->session_->GetForce()[1], 0.0, 1e-12);
    return -this->session_->GetForce()[0];
  }

  void expectRefused(double coefficient, const char* setting)
  {
    const auto errors = errorsOf(this->session_, [&] { this->session_->SetSetting(setting, coefficient); });
    EXPECT_THAT(errors, ElementsAre(HasSubstr("friction"))) << coefficient;
  }
};
} // namespace

TEST_F(HapticSessionFriction, HoldsUpToTheStaticConeThenBrakesWithTheKineticOne)
{
  this->session_->SetSetting("FrictionStatic", statical);
  this->session_->SetSetting("FrictionKinetic", kinetic);
  this->press();
  constexpr double step = 0.03; // u a tick; breakAway is no multiple of it
  constexpr double breakAway = statical * depth;
  for (int i = 1; i <= 200; ++i)
  {
    const double x = i * step;
    const double drag_N = this->dragTo(x);
    ASSERT_NEAR(drag_N, x < breakAway ? stiffness * x / scale : kinetic * normal_N, 1e-12) << "x = " << x;
    ASSERT_STREQ(this->session_->GetFrictionText(), x < breakAway ? "sticks" : "slips") << "x = " << x;
  }
}

TEST_F(HapticSessionFriction, WithoutFrictionNothingBrakesAndNothingIsSaid)
{
  this->press();
  for (int i = 1; i <= 50; ++i)
  {
    ASSERT_NEAR(this->dragTo(0.1 * i), 0.0, 1e-12);
  }
  EXPECT_STREQ(this->session_->GetFrictionText(), "");
}

TEST_F(HapticSessionFriction, TheOrderOfTheCoefficientsDoesNotMatter)
{
  this->session_->SetSetting("FrictionKinetic", kinetic);
  EXPECT_EQ(this->session_->GetFrictionKineticUsed(), 0.0);
  this->session_->SetSetting("FrictionStatic", statical);
  EXPECT_EQ(this->session_->GetFrictionKineticUsed(), kinetic);
  EXPECT_STREQ(this->session_->GetProblem(), "");
}

TEST_F(HapticSessionFriction, NoMoreThanTheStaticCoefficientIsUsedOfTheKineticOne)
{
  this->session_->SetSetting("FrictionKinetic", 0.9);
  this->session_->SetSetting("FrictionStatic", statical);
  EXPECT_EQ(this->session_->GetSetting("FrictionKinetic"), 0.9);
  EXPECT_EQ(this->session_->GetFrictionKineticUsed(), statical);
  this->session_->SetSetting("FrictionKinetic", kinetic);
  EXPECT_EQ(this->session_->GetFrictionKineticUsed(), kinetic);
}

TEST_F(HapticSessionFriction, CoefficientsThatCannotBeAreRefusedAndTheOldOnesStay)
{
  this->session_->SetSetting("FrictionStatic", statical);
  this->session_->SetSetting("FrictionKinetic", kinetic);
  for (const double bad : { -0.1, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    this->expectRefused(bad, "FrictionStatic");
    this->expectRefused(bad, "FrictionKinetic");
  }
  this->expectRefused(10.5, "FrictionStatic");
  this->expectRefused(10.5, "FrictionKinetic");
  EXPECT_EQ(this->session_->GetSetting("FrictionStatic"), statical);
  EXPECT_EQ(this->session_->GetSetting("FrictionKinetic"), kinetic);
  EXPECT_EQ(this->session_->GetFrictionKineticUsed(), kinetic);
}
