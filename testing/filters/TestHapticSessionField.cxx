// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in space under a hand, in virtual time. The truth is a distance: the values are those of f = |p|.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "FieldSession.h"
#include "VtkScenes.h"
#include "testing/support/Says.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkFloatArray.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;

namespace
{
class HapticSessionField : public FieldSession
{
};

TEST_F(HapticSessionField, AloneIsFeltAsTheSurfaceOfItsIsovalueFromBothSides)
{
  constexpr double h = 1.0, R = 20.0;
  this->session_->SetSetting("FieldArray", "distance");
  this->session_->SetSetting("FieldIsosurface", true);
  this->session_->SetSetting("FieldIsovalue", R);
  ASSERT_TRUE(this->session_->AddField("ball", distances(60, h))) << this->session_->GetProblem();
  ASSERT_TRUE(this->session_->FinishField());
  const Vec3 n = Vec3(1.0, 2.0, -0.5).normalized();
  this->start(28.0 * n);
  EXPECT_STREQ(this->session_->GetFaultText(), "");
  EXPECT_EQ(this->force().norm(), 0.0);
  this->go(28.0 * n, 17.0 * n);
  // The surface of sampled distances lies up to h^2 / 4 R inside of the ball.
  const double error_N = stiffness * h * h / (4.0 * R) / scale;
  const double spring_N = stiffness * 3.0 / scale;
  EXPECT_NEAR(this->force().dot(n), spring_N, 1.1 * error_N);
  EXPECT_NEAR(this->session_->GetFieldValue(), 17.0, h * h / (4.0 * 17.0) * 1.1);
  EXPECT_LT((Vec3(this->session_->GetFieldGradient()) - n).norm(), 0.1);
  EXPECT_NEAR(Vec3(this->session_->GetProxyPosition()).norm(), R, 1.1 * h * h / (4.0 * R)) << "the tool is drawn there";
  EXPECT_EQ(this->session_->GetContacts(), 1);
}

TEST_F(HapticSessionField, AloneIsWhatTheHandIsFittedTo)
{
  this->session_->SetSetting("FieldArray", "distance");
  this->session_->SetSetting("FitOnTouch", true);
  ASSERT_TRUE(this->session_->AddField("ball", distances(41, 1.0))); // 40 u a side
  ASSERT_TRUE(this->session_->FinishField());
  double b[6];
  ASSERT_TRUE(this->session_->GetSceneBounds(b));
  EXPECT_EQ(std::vector<double>(b, b + 6), (std::vector<double>{ -20, 20, -20, 20, -20, 20 }));
  this->session_->FitWorkspace();
  EXPECT_STREQ(this->session_->GetProblem(), "");
  const double fitted = this->session_->GetSetting("Scale");
  // Half of the diagonal is the workspace's radius: a box of twice the size has twice the scale.
  ASSERT_TRUE(this->session_->AddField("larger", distances(41, 2.0)));
  this->session_->SetSetting("VirtualTime", true);
  this->session_->TouchingOn();
  EXPECT_NEAR(this->session_->GetSetting("Scale"), 2.0 * fitted, 1e-9 * fitted);
}

// A view hands over its data a moment after the touch, here no surface and one field.
TEST_F(HapticSessionField, AloneItIsFittedAsByHandAlsoWhenItComesAfterTheTouch)
{
  this->session_->SetSetting("FieldArray", "distance");
  this->session_->SetSetting("FitOnTouch", true);
  this->session_->TouchingOn();
  this->session_->Step(10);
  this->session_->ClearSurfaces();
  this->session_->CommitScene();
  this->session_->FinishScene();
  ASSERT_TRUE(this->session_->AddField("ball", distances(41, 1.0)));
  ASSERT_TRUE(this->session_->FinishField());
  const double atOnce = this->session_->GetSetting("Scale");
  EXPECT_NE(atOnce, scale);
  this->session_->FitWorkspace();
  EXPECT_STREQ(this->session_->GetProblem(), "");
  EXPECT_NEAR(this->session_->GetSetting("Scale"), atOnce, 1e-9 * atOnce);
}

/// (-y, x, 0) on the points of an image.
void addVortex(vtkImageData& image)
{
  vtkNew<vtkFloatArray> values;
  values->SetName("velocity");
  values->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < image.GetNumberOfPoints(); ++i)
  {
    const Vec3 p(image.GetPoint(i));
    values->InsertNextTuple3(-p.y(), p.x(), 0.0);
  }
  image.GetPointData()->AddArray(values);
}

TEST_F(HapticSessionField, IsDrawnWhereTheProxyIsAsAPatchOfItsSurfaceAndAsItsStreamline)
{
  const auto image = distances(60, 1.0);
  addVortex(*image);
  this->session_->SetSetting("FieldArray", "distance");
  this->session_->SetSetting("FieldVectors", "velocity");
  this->session_->SetSetting("FieldFollow", 1.0);
  this->session_->SetSetting("FieldIsosurface", true);
  this->session_->SetSetting("FieldIsovalue", 20.0);
  ASSERT_TRUE(this->session_->AddField("ball", image));
  ASSERT_TRUE(this->session_->FinishField());
  this->start({ 21.0, 0.0, 3.0 });
  vtkNew<vtkPolyData> shape;
  this->session_->GetSight()->GetFieldShape(shape);
  ASSERT_GT(shape->GetNumberOfPolys(), 50);
  ASSERT_EQ(shape->GetNumberOfLines(), 1);
  vtkNew<vtkIdList> line;
  shape->GetCellPoints(0, line); // lines come before polygons
  ASSERT_GT(line->GetNumberOfIds(), 20);
  for (vtkIdType i = 0; i < shape->GetNumberOfPoints(); ++i)
  {
    const Vec3 p(shape->GetPoint(i));
    if (line->IsId(i) >= 0)
    {
      EXPECT_NEAR(std::hypot(p.x(), p.y()), 21.0, 1e-5); // a circle of a linear field; its numbers are floats
      EXPECT_NEAR(p.z(), 3.0, 1e-9);
    }
    else
    {
      EXPECT_NEAR(p.norm(), 20.0, 0.02); // h^2 / 4 R
      EXPECT_LT((p - Vec3(21.0, 0.0, 3.0)).cwiseAbs().maxCoeff(), 9.0) << "beside the hand alone";
    }
  }
}

TEST_F(HapticSessionField, OfADetentItsLevelIsDrawnAndOfASnapItsPlaceAndTheWayThere)
{
  this->session_->SetSetting("FieldArray", "distance");
  this->session_->SetSetting("FieldDetent", 0.1);
  ASSERT_TRUE(this->session_->AddField("ball", distances(60, 1.0)));
  ASSERT_TRUE(this->session_->FinishField());
  this->start({ 12.0, 9.0, 3.0 });
  const Vec3 x(this->session_->GetProxyPosition());
  vtkNew<vtkPolyData> shape;
  this->session_->GetSight()->GetFieldShape(shape);
  ASSERT_EQ(shape->GetNumberOfLines(), 1);
  ASSERT_EQ(shape->GetNumberOfPoints(), 5) << "a square, closed";
  for (vtkIdType i = 0; i < 5; ++i)
  {
    const Vec3 arm = Vec3(shape->GetPoint(i)) - x;
    EXPECT_NEAR(arm.norm(), 3.0, 1e-9) << "three cells";
    EXPECT_NEAR(arm.dot(x.normalized()), 0.0, 0.05 * 3.0) << "along the level: trilinear normals turn by h / R";
  }
  vtkNew<vtkPolyData> places;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(12.0, 9.0, 5.0);
  points->InsertNextPoint(0.0, 0.0, 0.0);
  places->SetPoints(points);
  this->session_->SetSetting("FieldDetent", 0.0);
  this->session_->SetSetting("FieldSnap", 0.1);
  this->session_->GetSight()->SetComparedField(nullptr, places);
  ASSERT_TRUE(this->session_->FinishField());
  this->go({ 12.0, 9.0, 3.0 }, { 12.0, 9.0, 4.0 });
  this->session_->GetSight()->GetFieldShape(shape);
  ASSERT_EQ(shape->GetNumberOfLines(), 4) << "the way and a cross";
  EXPECT_LT((Vec3(shape->GetPoint(0)) - Vec3(12.0, 9.0, 4.0)).norm(), 1e-6);
  EXPECT_EQ(Vec3(shape->GetPoint(1)), Vec3(12.0, 9.0, 5.0)) << "the nearer of the two";
}

TEST_F(HapticSessionField, OfTetrahedraIsFeltAsOnTheImageThatTheyWereCutFrom)
{
  constexpr double h = 2.0, R = 14.0;
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputData(distances(22, h));
  cut->Update();
  this->session_->SetSetting("FieldArray", "distance");
  this->session_->SetSetting("FieldIsosurface", true);
  this->session_->SetSetting("FieldIsovalue", R);
  ASSERT_TRUE(this->session_->AddField("tetrahedra", cut->GetOutput())) << this->session_->GetProblem();
  ASSERT_TRUE(this->session_->FinishField());
  const Vec3 n = Vec3(1.0, 1.0, 0.3).normalized();
  this->start(18.0 * n);
  this->go(18.0 * n, 11.0 * n);
  // A chord of a tetrahedron's longest edge, sqrt(3) h, is (sqrt(3) h)^2 / 8 R inside of the ball.
  const double error_N = stiffness * 3.0 * h * h / (8.0 * R) / scale;
  EXPECT_NEAR(this->force().norm(), stiffness * 3.0 / scale, error_N);
}

TEST_F(HapticSessionField, LargerThanABrickComesAlongWithTheHand)
{
  // 200^3 floats are 32 MB, three times the limit of a block; the wall is a plane far from where the hand begins.
  const auto image = distances(200, 1.0);
  auto* const values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->SetValue(i, static_cast<float>(image->GetPoint(i)[0]));
  }
  this->session_->SetSetting("FieldArray", "distance");
  this->session_->SetSetting("FieldIsosurface", true);
  this->session_->SetSetting("FieldIsovalue", 90.25);
  ASSERT_TRUE(this->session_->AddField("slope", image));
  const Vec3 from(-90.0, 3.0, 5.0), to(92.25, 3.0, 5.0);
  this->at(from);
  ASSERT_TRUE(this->session_->FinishField());
  this->start(from);
  this->go(from, to);
  EXPECT_NEAR(this->force().x(), -stiffness * 2.0 / scale, 1e-6);
  EXPECT_THAT(this->session_->GetFieldText(), HasSubstr("u around the hand"));
}

TEST_F(HapticSessionField, WithoutAModeThatIsOnNothingIsFeltAndThePersonIsTold)
{
  this->session_->SetSetting("FieldArray", "distance");
  ASSERT_TRUE(this->session_->AddField("ball", distances(20, 1.0)));
  ASSERT_TRUE(this->session_->FinishField());
  this->start(Vec3(5.0, 0.0, 0.0));
  EXPECT_STRNE(this->session_->GetFaultText(), "");
  EXPECT_EQ(this->session_->GetForceMagnitude(), 0.0);
}

TEST_F(HapticSessionField, ThatCannotBeFeltIsRefusedByNameAndARightArrayTakesTheRefusalBack)
{
  this->session_->SetSetting("FieldArray", "gone");
  const auto errors =
    errorsOf(this->session_, [&] { EXPECT_FALSE(this->session_->AddField("ball", distances(20, 1.0))); });
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_TRUE(test::says(errors[0], { "array", "\"gone\"", "exist" }));
  EXPECT_THAT(this->session_->GetFieldText(), HasSubstr("\"gone\""));
  EXPECT_FALSE(this->session_->FinishField());
  this->session_->SetSetting("FieldArray", "distance");
  EXPECT_STREQ(this->session_->GetProblem(), "");
  EXPECT_TRUE(this->session_->FinishField());
}

TEST_F(HapticSessionField, ThatIsTakenAwayWhileItPressesFadesWithin30Milliseconds)
{
  this->session_->SetSetting("FieldArray", "distance");
  this->session_->SetSetting("FieldIsosurface", true);
  this->session_->SetSetting("FieldIsovalue", 20.0);
  ASSERT_TRUE(this->session_->AddField("ball", distances(60, 1.0)));
  ASSERT_TRUE(this->session_->FinishField());
  this->start(Vec3(28.0, 0.0, 0.0));
  this->go(Vec3(28.0, 0.0, 0.0), Vec3(17.0, 0.0, 0.0));
  const double before_N = this->force().norm();
  ASSERT_GT(before_N, 1.0);
  this->session_->AddField(nullptr, nullptr);
  this->session_->FinishField();
  double largestStep_N = 0.0, last_N = before_N;
  for (int tick = 0; tick < 31; ++tick)
  {
    this->session_->Step(1);
    largestStep_N = std::max(largestStep_N, std::abs(this->force().norm() - last_N));
    last_N = this->force().norm();
  }
  EXPECT_LT(last_N, 1e-9);
  EXPECT_LE(largestStep_N, 2.0 * before_N / 30.0);
}

TEST_F(HapticSessionField, AnExtremumPullsTheHandWithTheStrengthOfItsSnap)
{
  // The distance is least at the origin, which is a point of the grid.
  constexpr double strength_N = 0.3;
  this->session_->SetSetting("FieldArray", "distance");
  this->session_->SetSetting("FieldSnap", strength_N);
  this->session_->SetSetting("FieldSnapReach", 8.0);
  ASSERT_TRUE(this->session_->AddField("ball", distances(41, 1.0)));
  ASSERT_TRUE(this->session_->FinishField());
  this->start(Vec3(12.0, 0.0, 0.0));
  EXPECT_EQ(this->force().norm(), 0.0);
  this->go(Vec3(12.0, 0.0, 0.0), Vec3(5.0, 0.0, 0.0));
  EXPECT_LT(this->force().x(), 0.0);
  EXPECT_LE(this->force().norm(), strength_N * (1.0 + 1e-9));
}

TEST_F(HapticSessionField, ADetentIsAsStrongAsItSaysWhereValuesChangeAsTheyUsuallyDo)
{
  // The same levels in other units: values a hundred times as large, levels a hundred times as far apart.
  std::array<double, 2> peak_N{};
  for (int unit = 0; unit < 2; ++unit)
  {
    const double factor = unit == 0 ? 1.0 : 100.0;
    const auto image = distances(41, 1.0);
    auto* const values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      values->SetValue(i, static_cast<float>(factor * image->GetPoint(i)[0]));
    }
    this->session_->SetSetting("FieldArray", "distance");
    this->session_->SetSetting("FieldDetent", 0.2);
    this->session_->SetSetting("FieldDetentSpacing", 5.0 * factor);
    ASSERT_TRUE(this->session_->AddField("slope", image));
    ASSERT_TRUE(this->session_->FinishField());
    this->start(Vec3(0.0, 0.0, 0.0));
    for (int i = 0; i <= 500; ++i)
    {
      this->at(Vec3(0.01 * i, 0.0, 0.0));
      this->session_->Step(1);
      peak_N[unit] = std::max(peak_N[unit], this->force().norm());
    }
    this->session_->TouchingOff();
  }
  EXPECT_GT(peak_N[0], 0.1);
  EXPECT_LE(peak_N[0], 0.2 * (1.0 + 1e-6));
  EXPECT_NEAR(peak_N[0], peak_N[1], 1e-3 * peak_N[0]);
}

TEST_F(HapticSessionField, SaysWithHowMuchSmoothLevelsHoldAlsoWhereItIsLargerThanABrick)
{
  // 200^3 floats are 32 MB, three times the limit of a block; steep far away from the hand.
  const auto image = distances(200, 1.0);
  auto* const values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double x = image->GetPoint(i)[0];
    values->SetValue(i, static_cast<float>(x > 80.0 ? 80.0 + 4.0 * (x - 80.0) : x));
  }
  this->session_->SetSetting("FieldArray", "distance");
  this->session_->SetSetting("FieldDetent", 5.0);
  this->session_->SetSetting("FieldDetentSpacing", 2.0);
  ASSERT_TRUE(this->session_->AddField("slope", image));
  this->at(Vec3(-50.0, 0.0, 0.0));
  ASSERT_TRUE(this->session_->FinishField());
  this->start(Vec3(-50.0, 0.0, 0.0));
  // By the slope of 4 and the bend of 3 where it begins, over a spacing: k = 0.5 N/mm, levels 2 apart.
  const double most_N = 0.9 * 0.5 / (32.0 * 16.0 / (3.0792014356780046 * 2.0) + 3.0);
  double largest_N = 0.0;
  for (int i = 0; i <= 400; ++i)
  {
    this->at(Vec3(-50.0 + 0.01 * i, 0.0, 0.0));
    this->session_->Step(1);
    largest_N = std::max(largest_N, this->force().norm());
  }
  EXPECT_NEAR(largest_N, most_N, 0.06 * most_N) << "bounds may be a twentieth too large";
  EXPECT_THAT(this->session_->GetFieldText(), HasSubstr("smooth levels hold with 0.00"));
}

TEST_F(HapticSessionField, SaysWhatThePushGivesAndCountsTheTicksBeyondTheNumbers)
{
  const auto image = distances(41, 1.0);
  addVortex(*image);
  this->session_->SetSetting("FieldVectors", "velocity");
  this->session_->SetSetting("FieldPush", 0.25);
  ASSERT_TRUE(this->session_->AddField("vortex", image));
  ASSERT_TRUE(this->session_->FinishField());
  EXPECT_EQ(this->session_->GetFieldError(), 0.0) << "the voxels themselves";
  EXPECT_GE(this->session_->GetFieldAge(), 0.0);
  this->start(Vec3(10.0, 0.0, 0.0));
  for (int i = 1; i <= 100; ++i) // along the stream, 100 mm/s
  {
    this->at(Vec3(10.0, 0.1 * i - 5.0, 0.0));
    this->session_->Step(1);
  }
  // The force is 0.25 N along (-5, 10) / |(-5, 10)| at the end, the velocity 0.1 m/s along y: 25 mW times 10 / 11.18.
  EXPECT_NEAR(this->session_->GetFieldPushPower(), 25.0 * 10.0 / std::hypot(5.0, 10.0), 0.5);
  EXPECT_EQ(this->session_->GetFieldTicksBeyond(), 0);
  this->at(Vec3(21.0, 0.0, 0.0)); // the image ends at 20
  this->session_->Step(37);
  EXPECT_EQ(this->session_->GetFieldTicksBeyond(), 37);
  EXPECT_EQ(this->session_->GetFieldPushPower(), 0.0);
}

TEST_F(HapticSessionField, HoldsTheHandAtChosenLevelsAndRefusesWhatAreNone)
{
  this->session_->SetSetting("FieldArray", "distance");
  this->session_->SetSetting("FieldDetent", 0.2);
  this->session_->SetSetting("FieldDetentSpacing", 2.0);
  this->session_->SetSetting("FieldDetentLevels", "8, 14");
  EXPECT_STREQ(this->session_->GetSettingText("FieldDetentLevels"), "8, 14");
  ASSERT_TRUE(this->session_->AddField("ball", distances(41, 1.0)));
  ASSERT_TRUE(this->session_->FinishField());
  this->start(Vec3(7.7, 0.0, 0.0));
  EXPECT_GT(this->force().x(), 0.01) << "drawn to 8";
  this->at(Vec3(10.0, 0.0, 0.0));
  this->session_->Step(10);
  EXPECT_EQ(this->force().norm(), 0.0) << "10 and 12 would be levels 2 apart";
  this->at(Vec3(14.3, 0.0, 0.0));
  this->session_->Step(10);
  EXPECT_LT(this->force().x(), -0.01);
  const auto errors = errorsOf(this->session_, [&] { this->session_->SetSetting("FieldDetentLevels", "8, high"); });
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_THAT(errors[0], HasSubstr("'high' is not a number"));
  EXPECT_STREQ(this->session_->GetSettingText("FieldDetentLevels"), "8, 14");
}

TEST_F(HapticSessionField, AnArrayOfASourceThatIsChosenIsNotLookedForInTheDataOfAnother)
{
  this->session_->SetSetting("FieldArray", "distance");
  ASSERT_TRUE(this->session_->AddField("ball", distances(20, 1.0)));
  const auto errors = errorsOf(this->session_,
    [&]
    {
      this->session_->SetSetting("FeltSource", "slope");
      this->session_->SetSetting("FieldArray", "steepness");
    });
  EXPECT_THAT(errors, ::testing::IsEmpty());
  EXPECT_STREQ(this->session_->GetProblem(), "");
}

TEST_F(HapticSessionField, SaysThatTheDataDoNotHaveTheIsovalueAndThatWhatWasFeltIsGone)
{
  this->session_->SetSetting("FieldArray", "distance");
  this->session_->SetSetting("FieldIsosurface", true);
  this->session_->SetSetting("FieldIsovalue", 500.0);
  ASSERT_TRUE(this->session_->AddField("ball", distances(41, 1.0)));
  ASSERT_TRUE(this->session_->FinishField());
  EXPECT_THAT(this->session_->GetFieldText(), HasSubstr("do not contain the isovalue 500"));
  this->session_->SetSetting("FieldIsovalue", 10.0);
  EXPECT_THAT(this->session_->GetFieldText(), ::testing::Not(HasSubstr("isovalue")));
  this->start(Vec3(12.0, 0.0, 0.0));
  EXPECT_STREQ(this->session_->GetWarning(), "");
  this->session_->AddField(nullptr, nullptr); // as who follows a view does when no source has the array any more
  this->session_->Step(1);
  this->session_->Update();
  EXPECT_TRUE(test::says(this->session_->GetWarning(), { "source", "longer", "visible" }));
  this->session_->AddField("ball", distances(41, 1.0));
  this->session_->Update();
  EXPECT_STREQ(this->session_->GetWarning(), "");
}

TEST_F(HapticSessionField, IsComparedWithOtherDataAndSnapsToTheirPoints)
{
  const auto image = distances(41, 1.0), other = distances(21, 2.0);
  auto* const values = vtkFloatArray::SafeDownCast(other->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < other->GetNumberOfPoints(); ++i)
  {
    values->SetValue(i, values->GetValue(i) + (other->GetPoint(i)[0] > 1.0 ? 10.0F : 0.0F));
  }
  this->session_->SetSetting("FieldArray", "distance");
  this->session_->SetSetting("FieldCompare", 0.4);
  this->session_->SetSetting("FieldCompareFull", 5.0);
  this->session_->GetSight()->SetComparedField(other, nullptr);
  ASSERT_TRUE(this->session_->AddField("ball", image));
  ASSERT_TRUE(this->session_->FinishField()) << this->session_->GetProblem();
  const auto drag = [this](double x)
  {
    this->at(Vec3(x, 9.0, 2.0));
    this->session_->Step(1);
    for (int i = 1; i <= 60; ++i)
    {
      this->at(Vec3(x, 9.0 + 0.05 * i, 2.0));
      this->session_->Step(1);
    }
    return this->force().norm();
  };
  this->start(Vec3(-9.0, 9.0, 2.0));
  // Chords of 2 u on distances of 10 u and more differ by h^2 / 4 R, 0.1 of the 5 that have all of it.
  EXPECT_LT(drag(-9.0), 0.4 * 0.1 / 5.0 * 1.5);
  EXPECT_NEAR(drag(9.0), 0.4, 1e-3);
  this->session_->SetSetting("FieldCompare", 0.0);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-10.0, 3.0, 0.0);
  vtkNew<vtkPolyData> cores;
  cores->SetPoints(points);
  this->session_->SetSetting("FieldSnap", 0.3);
  this->session_->SetSetting("FieldSnapReach", 4.0);
  this->session_->GetSight()->SetComparedField(nullptr, cores);
  ASSERT_TRUE(this->session_->FinishField());
  this->at(Vec3(-8.0, 3.0, 0.0));
  this->session_->Step(100);
  EXPECT_NEAR(this->force().x(), -0.3 * (1.0 - 2.0 / 4.0), 1e-6);
}
} // namespace
