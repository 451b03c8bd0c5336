// SPDX-License-Identifier: GPL-3.0-or-later
// A session that feels arrays: its texts about them, and the cost of a change of them.
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/session/scene/SceneWorker.h"

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "testing/support/Says.h"
#include "vtkDoubleArray.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;
using ::testing::Not;

namespace
{

vtkSmartPointer<vtkPolyData> planeWithX()
{
  auto plane = makePlane(half);
  vtkNew<vtkDoubleArray> x;
  x->SetName("x");
  for (vtkIdType i = 0; i < plane->GetNumberOfPoints(); ++i)
  {
    x->InsertNextValue(plane->GetPoint(i)[0]);
  }
  plane->GetPointData()->AddArray(x);
  return plane;
}

/// A fed hand in virtual time.
class HapticSessionMaterials : public VirtualSession
{
protected:
  Vec3 pressedAt(double x)
  {
    this->session_->SetHandPosition(x, 0.0, 1.0);
    this->session_->TouchingOn();
    this->session_->Step(1200); // arming and the ramp of 1 s
    this->session_->SetHandPosition(x, 0.0, -depth);
    this->session_->Step(100);
    return Vec3(this->session_->GetForce());
  }
};
} // namespace

// The spring of the session is the stiffest that data can feel like.
TEST_F(HapticSessionMaterials, StiffnessThatTheSpringCutsIsSaid)
{
  this->session_->SetSetting("StiffnessFeltRange", 100.0, 2.0 * stiffness);
  EXPECT_STREQ(this->session_->GetMaterialText(), "") << "no array gives it";
  this->session_->SetSetting("StiffnessArray", "hardness");
  EXPECT_TRUE(test::says(this->session_->GetMaterialText(), { "1000 N/m", "the spring of 500 N/m" }));
  this->session_->SetSetting("StiffnessFeltRange", 100.0, stiffness);
  EXPECT_STREQ(this->session_->GetMaterialText(), "");
}

TEST_F(HapticSessionMaterials, AnArrayIsFeltAndTheReportSaysHow)
{
  this->session_->SetSetting("StiffnessArray", "x");
  this->session_->SetSetting("StiffnessFeltRange", 100.0, 400.0);
  this->show(planeWithX());
  EXPECT_TRUE(test::says(this->session_->GetSceneReport(), { "stiffness from 'x'", "-100 to 100", "100 to 400 N/m" }));
  const double x = 40.0, slope = 300.0 / (2.0 * half); // N/m per u
  const double wall = 100.0 + slope * (x + half);
  const Vec3 expected_W = Vec3(-0.5 * depth * depth * slope, 0.0, wall * depth) / scale;
  EXPECT_LT((this->pressedAt(x) - expected_W).norm(), 1e-12);
}

TEST_F(HapticSessionMaterials, ASurfaceWithoutTheArrayKeepsItsOwnAndTheReportSaysSo)
{
  this->session_->SetSetting("TextureArray", "roughness");
  this->show(planeWithX());
  EXPECT_TRUE(
    test::says(this->session_->GetSceneReport(), { "its own texture", "no array 'roughness'", "it has 'x'" }));
  EXPECT_NEAR(this->pressedAt(40.0).z(), stiffness * depth / scale, 1e-12);
}

TEST_F(HapticSessionMaterials, WallsAreFeltWithoutArraysAndTheReportSaysSo)
{
  const auto line = makePath({ Vec3(-half, 0.0, 0.0), Vec3(half, 0.0, 0.0), Vec3(half, half, 0.0) });
  this->session_->SetSetting("LinesAsWalls", 2);
  this->session_->SetSetting("StiffnessArray", "x");
  for (int again = 0; again < 2; ++again)
  {
    this->show(line);
    EXPECT_THAT(this->session_->GetSceneReport(), HasSubstr("walls have no arrays"));
  }
  this->session_->SetSetting("StiffnessArray", "");
  this->show(line);
  EXPECT_THAT(this->session_->GetSceneReport(), Not(HasSubstr("no arrays")));
}

TEST_F(HapticSessionMaterials, PointsWithoutANumberAreCountedInTheReport)
{
  const auto plane = planeWithX();
  plane->GetPointData()->GetArray("x")->SetComponent(2, 0, std::numeric_limits<double>::infinity());
  this->session_->SetSetting("FrictionArray", "x");
  this->show(plane);
  EXPECT_TRUE(test::says(this->session_->GetSceneReport(), { "1 point without a number" }));
}

TEST_F(HapticSessionMaterials, RangesThatCannotBeAreRefusedAndTheOldOnesStay)
{
  vtkObject::GlobalWarningDisplayOff();
  this->session_->SetSetting("FrictionFeltRange", 0.1, 0.2);
  this->session_->SetSetting("FrictionFeltRange", 0.1, 10.5);
  this->session_->SetSetting("StiffnessDataRange", std::nan(""), 1.0);
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_EQ(this->session_->GetSettingNumbers("FrictionFeltRange")[1], 0.2);
  EXPECT_EQ(this->session_->GetSettingNumbers("StiffnessDataRange")[0], 0.0);
  EXPECT_THAT(this->session_->GetProblem(), HasSubstr("stiffness"));
}

TEST_F(HapticSessionMaterials, OnlyAChangeOfTheSettingsChangesTheirTime)
{
  const vtkMTimeType before = this->session_->GetSight()->GetMaterialTime();
  this->session_->SetSetting("FrictionArray", "");
  this->session_->SetSetting("Stiffness", 300.0);
  EXPECT_EQ(this->session_->GetSight()->GetMaterialTime(), before);
  EXPECT_FALSE(this->session_->GetSight()->GetUsesMaterialArrays());
  this->session_->SetSetting("FrictionArray", "x");
  EXPECT_NE(this->session_->GetSight()->GetMaterialTime(), before);
  EXPECT_TRUE(this->session_->GetSight()->GetUsesMaterialArrays());
}

TEST_F(HapticSessionMaterials, AnotherRangeOrOtherValuesAreFeltAtOnce)
{
  const auto plane = planeWithX();
  this->session_->SetSetting("StiffnessArray", "x");
  this->session_->SetSetting("StiffnessFeltRange", 100.0, 100.0);
  this->show(plane);
  EXPECT_NEAR(this->pressedAt(0.0).z(), 100.0 * depth / scale, 1e-12);
  this->session_->SetSetting("StiffnessFeltRange", 300.0, 300.0);
  this->show(plane);
  this->session_->Step(1000); // the force before fades out
  EXPECT_NEAR(this->session_->GetForce()[2], 300.0 * depth / scale, 1e-12);
  this->session_->SetSetting("StiffnessFeltRange", 0.0, 400.0);
  this->session_->SetSetting("StiffnessDataRange", 0.0, 100.0);
  plane->GetPointData()->GetArray("x")->Fill(75.0);
  plane->GetPointData()->GetArray("x")->Modified();
  this->show(plane);
  this->session_->Step(1000);
  EXPECT_NEAR(this->session_->GetForce()[2], 300.0 * depth / scale, 1e-12);
}

TEST(SceneWorkerMaterials, AnotherRangeOrOtherValuesBuildNoTree)
{
  const auto plane = planeWithX();
  vtkHapticSceneSurfaces surfaces;
  palpate::SceneWorker worker;
  const auto built = [&]
  {
    surfaces.Clear();
    EXPECT_EQ(surfaces.Add("plane", plane, nullptr), "");
    surfaces.Commit(worker);
    return worker.wait()->scene;
  };
  const auto first = built();
  vtkHapticMaterialSettings settings;
  settings.Stiffness.Array = "x";
  surfaces.SetMaterials(settings);
  const auto second = built();
  plane->GetPointData()->GetArray("x")->Fill(1.0);
  plane->GetPointData()->GetArray("x")->Modified();
  const auto third = built();
  EXPECT_EQ(first->surfaces()[0].tree, second->surfaces()[0].tree);
  EXPECT_EQ(first->surfaces()[0].tree, third->surfaces()[0].tree);
  EXPECT_EQ(first->surfaces()[0].fields, nullptr);
  EXPECT_NE(second->geometryHash(), third->geometryHash());
}

TEST_F(HapticSessionMaterials, OneSourceIsSofterThanTheOthersOrNotTouchedAtAll)
{
  const auto plane = makePlane(half);
  const auto felt = [&]
  {
    this->show(plane);
    return this->pressedAt(10.0).z();
  };
  EXPECT_NEAR(felt(), stiffness * depth / scale, 1e-9);
  this->session_->TouchingOff();
  ASSERT_TRUE(this->session_->SetSourceMaterial("surface", 200.0, -1.0, -1.0));
  EXPECT_NEAR(felt(), 200.0 * depth / scale, 1e-9);
  this->session_->TouchingOff();
  ASSERT_TRUE(this->session_->SetSourceMaterial("another", 50.0, -1.0, -1.0));
  EXPECT_NEAR(felt(), 200.0 * depth / scale, 1e-9);

  const auto before = this->session_->GetSight()->GetMaterialTime();
  this->session_->SetSourceTouched("surface", false);
  EXPECT_GT(this->session_->GetSight()->GetMaterialTime(), before) << "who follows a view adds it again";
  this->session_->ClearSurfaces();
  EXPECT_TRUE(this->session_->AddSurface("surface", plane, nullptr)) << "that is no problem";
  this->session_->CommitScene();
  EXPECT_FALSE(this->session_->FinishScene());
  EXPECT_THAT(this->session_->GetSceneReport(), HasSubstr("surface: the source is switched off"));
  this->session_->SetSourceTouched("surface", true);
  this->show(plane);

  const auto errors = errorsOf(static_cast<vtkObject*>(this->session_),
    [&] { EXPECT_FALSE(this->session_->SetSourceMaterial("surface", -3.0, -1.0, -1.0)); });
  EXPECT_EQ(errors.size(), 1u);
  double material[3];
  this->session_->GetSourceMaterial("surface", material);
  EXPECT_EQ(material[0], 200.0);
}

TEST_F(HapticSessionMaterials, AnArrayThatIsDeletedOrRenamedWhileItIsFeltIsWarnedOfUntilAnotherIsChosen)
{
  const auto plane = planeWithX();
  this->session_->SetSetting("StiffnessArray", "x");
  this->session_->SetSetting("StiffnessFeltRange", 100.0, 400.0);
  this->show(plane);
  EXPECT_NEAR(this->pressedAt(0.0).z(), 250.0 * depth / scale, 1e-9);
  EXPECT_STREQ(this->session_->GetWarning(), "");
  plane->GetPointData()->GetArray("x")->SetName("y");
  plane->GetPointData()->Modified();
  this->show(plane);
  this->session_->Step(1000);
  EXPECT_NEAR(this->session_->GetForce()[2], stiffness * depth / scale, 1e-9) << "the surface has its own again";
  EXPECT_TRUE(test::says(this->session_->GetWarning(), { "Stiffness", "'x'", "touchable" }));
  this->session_->SetSetting("StiffnessArray", "y");
  this->show(plane);
  this->session_->Step(1000);
  EXPECT_STREQ(this->session_->GetWarning(), "");
  EXPECT_NEAR(this->session_->GetForce()[2], 250.0 * depth / scale, 1e-9);
  plane->GetPointData()->RemoveArray("y");
  this->show(plane);
  this->session_->Step(10);
  EXPECT_THAT(this->session_->GetWarning(), HasSubstr("array 'y'"));
}
