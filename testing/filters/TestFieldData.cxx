// SPDX-License-Identifier: GPL-3.0-or-later
// Data sets as blocks. The judge is VTK's own probe.
#include <cmath>
#include <limits>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/session/scene/FeltField.h"
#include "testing/support/Random.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkHapticFieldData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

using namespace palpate;
using ::testing::HasSubstr;

namespace
{
constexpr double endless = std::numeric_limits<double>::infinity();

vtkSmartPointer<vtkImageData> makeImage(int nx, int ny, int nz)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, nx + 2, -2, ny - 3, 0, nz - 1); // extents of pipelines begin anywhere
  image->SetSpacing(0.5, 1.25, 2.0);
  image->SetOrigin(10.0, -20.0, 30.0);
  return image;
}

void turn(vtkImageData& image, bool mirrored)
{
  Eigen::Matrix3d axes = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  axes.col(1) *= mirrored ? -1.0 : 1.0;
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = axes;
  image.SetDirectionMatrix(rows.data());
}

void addRandom(vtkImageData& image, const char* name, int components, test::Random& random)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  values->SetNumberOfComponents(components);
  for (vtkIdType i = 0; i < components * image.GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(random.uniform(-1.0, 1.0));
  }
  image.GetPointData()->AddArray(values);
}

/// VTK's answer at a place, or nothing where VTK finds no cell.
std::optional<std::vector<double>> probed(vtkDataSet* data, const char* name, const Vec3& p_W)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(p_W.data());
  vtkNew<vtkPolyData> at;
  at->SetPoints(points);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(at);
  probe->SetSourceData(data);
  probe->Update();
  if (probe->GetValidPoints()->GetNumberOfTuples() == 0)
  {
    return std::nullopt;
  }
  vtkDataArray* const array = probe->GetOutput()->GetPointData()->GetArray(name);
  std::vector<double> tuple(static_cast<std::size_t>(array->GetNumberOfComponents()));
  array->GetTuple(0, tuple.data());
  return tuple;
}

MadeFieldBlock brickOf(vtkDataObject* data, const vtkHapticFieldArrays& arrays, const Vec3& centre_W = Vec3::Zero(),
  double reach_u = endless)
{
  const vtkHapticFieldResult field = vtkHapticToField(data, arrays);
  EXPECT_EQ(field.Problem, "");
  return field.Source ? field.Source->brickAround({ centre_W, reach_u, 1 }) : MadeFieldBlock{};
}

vtkHapticFieldArrays scalar(const char* name)
{
  vtkHapticFieldArrays arrays;
  arrays.Scalar = name;
  return arrays;
}

class FieldOfAnImage : public ::testing::TestWithParam<bool>
{
};

TEST_P(FieldOfAnImage, HasTheValuesOfVtksProbeTurnedOrMirroredAndOfUnevenSpacing)
{
  test::Random random(test::testSeed(1701));
  const auto image = makeImage(6, 5, 4);
  turn(*image, GetParam());
  addRandom(*image, "f", 1, random);
  addRandom(*image, "v", 3, random);
  vtkHapticFieldArrays arrays = scalar("f");
  arrays.Vector = "v";
  const MadeFieldBlock made = brickOf(image, arrays);
  ASSERT_TRUE(made.brick);
  EXPECT_EQ(made.reach_u, endless);
  for (std::size_t n = 0; n < test::testCount(200); ++n)
  {
    const Vec3 index(random.uniform(0, 5), random.uniform(0, 4), random.uniform(0, 3));
    const Vec3 p_W = made.brick->grid().toWorld(index);
    const auto f = probed(image, "f", p_W), v = probed(image, "v", p_W);
    ASSERT_TRUE(f && v) << p_W.transpose();
    // The block's numbers are floats.
    EXPECT_NEAR(made.brick->sample(FieldBlockRole::Scalar, p_W)->value, f->at(0), 1e-6);
    EXPECT_LT((*made.brick->vector(p_W) - Vec3(v->data())).norm(), 1e-6);
  }
}
INSTANTIATE_TEST_SUITE_P(
  Axes, FieldOfAnImage, ::testing::Bool(), [](const auto& info) { return info.param ? "LeftHanded" : "RightHanded"; });

TEST(FieldData, TwoWindowsOfOneImageHaveTheSameBitsWhereTheyOverlapSmoothedOrNot)
{
  test::Random random(test::testSeed(1702));
  const auto image = makeImage(160, 150, 140); // 3.4 million points: more than a block holds
  addRandom(*image, "f", 1, random);
  for (const int passes : { 0, 2 })
  {
    vtkHapticFieldArrays arrays = scalar("f");
    arrays.Smoothing = passes;
    const vtkHapticFieldResult field = vtkHapticToField(image, arrays);
    ASSERT_TRUE(field.Source);
    const double* const centre = image->GetCenter();
    const MadeFieldBlock largest = field.Source->brickAround({ Vec3(centre), endless, 3 });
    ASSERT_TRUE(largest.brick);
    EXPECT_LE(largest.brick->bytes(), FieldBlock::mostBytes);
    EXPECT_GT(largest.brick->bytes(), FieldBlock::mostBytes / 2);
    const MadeFieldBlock one = field.Source->brickAround({ Vec3(centre), 9.0, 1 });
    const MadeFieldBlock two = field.Source->brickAround({ Vec3(centre) + Vec3(4.0, -3.0, 5.0), 9.0, 2 });
    ASSERT_TRUE(one.brick && two.brick);
    EXPECT_GE(one.reach_u, 9.0);
    for (std::size_t n = 0; n < test::testCount(200); ++n)
    {
      const Vec3 p_W = Vec3(centre) + Vec3(random.uniform(-4, 8), random.uniform(-8, 5), random.uniform(-3, 8));
      const auto a = one.brick->sample(FieldBlockRole::Scalar, p_W), b = two.brick->sample(FieldBlockRole::Scalar, p_W);
      ASSERT_TRUE(a && b);
      // The corners are the same bits; the place in the cell is computed from another first point.
      EXPECT_NEAR(a->value, b->value, 1e-12);
    }
  }
}

/// Near enough to normally distributed: twelve numbers of variance 1/12.
double normal(test::Random& random)
{
  double sum = -6.0;
  for (int i = 0; i < 12; ++i)
  {
    sum += random.uniform();
  }
  return sum;
}

/// Heights with noise of so many spacings.
vtkSmartPointer<vtkImageData> noisyHeights(double sigma)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(24, 24, 24);
  test::Random random(test::testSeed(1707));
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(image->GetPoint(i)[2] + sigma * normal(random));
  }
  image->GetPointData()->AddArray(values);
  return image;
}

TEST(FieldData, NoiseThatTrapsAHandIsSmoothedOnceByItselfBesideTheLevelThatIsFeltAndSaid)
{
  // White noise of sigma spacings is measured as 0.6 sigma, and a fifth of a spacing traps: 0.5 does, 0.2 does not.
  for (const double sigma : { 0.0, 0.2, 0.5 })
  {
    const auto image = noisyHeights(sigma);
    const vtkHapticFieldResult field = vtkHapticToField(image, scalar("f"));
    const MadeFieldBlock made = field.Source->brickAround({ Vec3::Zero(), endless, 1, 12.25 });
    EXPECT_NEAR(made.smoothness.noise, 0.6 * sigma, 0.15 * sigma + 1e-6);
    EXPECT_EQ(made.smoothness.passes, sigma > 0.4 ? 1 : 0);
    EXPECT_EQ(field.Source->brickAround({ Vec3::Zero(), endless, 2 }).smoothness.passes, 0) << "no surface is felt";
    vtkHapticFieldArrays asked = scalar("f");
    asked.Smoothing = sigma > 0.4 ? 1 : 0;
    EXPECT_EQ(made.brick->contentHash(), brickOf(image, asked).brick->contentHash());
    const std::string said = fieldText("head", made, 1.0, 1.0);
    EXPECT_EQ(said.find("smoothed once: noise of 0.") != std::string::npos, sigma > 0.4) << said;
  }
}

TEST(FieldData, SmoothingLeavesALinearFunctionAlone)
{
  const auto image = makeImage(8, 8, 8);
  vtkNew<vtkFloatArray> values;
  values->SetName("f");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<float>(image->GetPoint(i)[0] - 2 * image->GetPoint(i)[1]));
  }
  image->GetPointData()->AddArray(values);
  vtkHapticFieldArrays arrays = scalar("f");
  arrays.Smoothing = 3;
  const MadeFieldBlock made = brickOf(image, arrays);
  const Vec3 p_W(image->GetCenter());
  EXPECT_NEAR(made.brick->sample(FieldBlockRole::Scalar, p_W)->value, p_W.x() - 2 * p_W.y(), 1e-4);
}

/// An image cut into tetrahedra, with a linear function at its points.
vtkSmartPointer<vtkUnstructuredGrid> makeTetrahedra(vtkImageData& image)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (vtkIdType i = 0; i < image.GetNumberOfPoints(); ++i)
  {
    const double* const p = image.GetPoint(i);
    values->InsertNextValue(p[0] - 2 * p[1] + 3 * p[2]);
  }
  image.GetPointData()->AddArray(values);
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputData(&image);
  cut->Update();
  return cut->GetOutput();
}

TEST(FieldData, ALinearFunctionOnTetrahedraIsFeltAsItIsAloneAndInBlocks)
{
  const auto tetrahedra = makeTetrahedra(*makeImage(5, 5, 5));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(2);
  blocks->SetBlock(1, tetrahedra);
  test::Random random(test::testSeed(1703));
  for (vtkDataObject* data : { static_cast<vtkDataObject*>(tetrahedra), static_cast<vtkDataObject*>(blocks) })
  {
    const MadeFieldBlock made = brickOf(data, scalar("f"));
    ASSERT_TRUE(made.brick);
    double bounds[6];
    tetrahedra->GetBounds(bounds);
    for (std::size_t n = 0; n < test::testCount(100); ++n)
    {
      const Vec3 p_W(random.uniform(bounds[0], bounds[1]), random.uniform(bounds[2], bounds[3]),
        random.uniform(bounds[4], bounds[5]));
      const auto sample = made.brick->sample(FieldBlockRole::Scalar, p_W);
      if (!sample)
      {
        continue; // VTK's probe may miss a point on the rim by rounding
      }
      EXPECT_NEAR(sample->value, p_W.x() - 2 * p_W.y() + 3 * p_W.z(), 1e-4);
    }
    EXPECT_TRUE(made.brick->sample(FieldBlockRole::Scalar, Vec3(tetrahedra->GetCenter())));
  }
}

TEST(FieldData, TetrahedraHaveTheValuesOfVtksProbeAtEachPointOfTheLattice)
{
  test::Random random(test::testSeed(1707));
  const auto image = makeImage(5, 5, 5);
  const auto tetrahedra = makeTetrahedra(*image);
  auto* const values = vtkDoubleArray::SafeDownCast(tetrahedra->GetPointData()->GetArray("f"));
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetValue(i, random.uniform(-1.0, 1.0));
  }
  const MadeFieldBlock made = brickOf(tetrahedra, scalar("f"));
  ASSERT_TRUE(made.brick);
  const FieldBlockGrid& grid = made.brick->grid();
  const FieldBlockComponent f = made.brick->component(FieldBlockRole::Scalar);
  for (std::size_t n = 0; n < test::testCount(200); ++n)
  {
    GridIndex at;
    for (int k = 0; k < 3; ++k)
    {
      at[k] = 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(grid.size[k] - 2))); // VTK may miss the rim
    }
    const auto known = probed(tetrahedra, "f", grid.toWorld({ 1.0 * at[0], 1.0 * at[1], 1.0 * at[2] }));
    ASSERT_TRUE(known);
    EXPECT_NEAR(f.at(at), known->at(0), 1e-5);
  }
}

TEST(FieldData, ValuesOfCellsAreTakenToThePointsAsVtkTakesThem)
{
  const auto image = makeImage(4, 4, 4);
  vtkNew<vtkDoubleArray> values;
  values->SetName("c");
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
  {
    values->InsertNextValue(static_cast<double>(i % 5));
  }
  image->GetCellData()->AddArray(values);
  const MadeFieldBlock made = brickOf(image, scalar("c"));
  vtkNew<vtkCellDataToPointData> toPoints;
  toPoints->SetInputData(image);
  toPoints->Update();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const auto sample = made.brick->sample(FieldBlockRole::Scalar, Vec3(image->GetPoint(i)));
    ASSERT_TRUE(sample);
    EXPECT_NEAR(sample->value, toPoints->GetOutput()->GetPointData()->GetArray("c")->GetComponent(i, 0), 1e-6);
  }
}

TEST(FieldData, BlankedCellsHaveNoValue)
{
  test::Random random(test::testSeed(1704));
  const auto withoutMiddle = [&](int cells)
  {
    const auto image = makeImage(cells + 1, cells + 1, cells + 1);
    addRandom(*image, "f", 1, random);
    image->AllocateCellGhostArray();
    image->GetCellGhostArray()->SetValue(cells * cells * cells / 2, vtkDataSetAttributes::HIDDENCELL);
    return image;
  };
  const auto image = withoutMiddle(5);
  const MadeFieldBlock made = brickOf(image, scalar("f"));
  ASSERT_TRUE(made.brick);
  EXPECT_FALSE(made.brick->sample(FieldBlockRole::Scalar, Vec3(image->GetCenter())));
  EXPECT_TRUE(made.brick->sample(FieldBlockRole::Scalar, Vec3(image->GetPoint(0))));
  const MadeFieldBlock none = brickOf(withoutMiddle(3), scalar("f")); // each of 27 cells has a corner of the middle one
  EXPECT_FALSE(none.brick);
  EXPECT_THAT(none.problem, HasSubstr("too few visible cells"));
}

TEST(FieldData, AScalarOfSeveralComponentsIsTheirLengthOrTheOneThatIsChosen)
{
  test::Random random(test::testSeed(1705));
  const auto image = makeImage(3, 3, 3);
  addRandom(*image, "v", 3, random);
  vtkHapticFieldArrays arrays = scalar("v");
  const Vec3 p_W(image->GetPoint(13));
  const double* const v = image->GetPointData()->GetArray("v")->GetTuple3(13);
  const Vec3 expected(v);
  EXPECT_NEAR(brickOf(image, arrays).brick->sample(FieldBlockRole::Scalar, p_W)->value, expected.norm(), 1e-6);
  arrays.Component = 2;
  EXPECT_NEAR(brickOf(image, arrays).brick->sample(FieldBlockRole::Scalar, p_W)->value, expected.z(), 1e-6);
}

TEST(FieldData, OfDataLargerThanABrickThereAreSomeCellsAroundAHandThatReachesLessFarThanOne)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(150, 150, 150); // 13.5 MB of floats, and a block holds 10
  vtkNew<vtkFloatArray> heights;
  heights->SetName("f");
  heights->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    heights->SetValue(i, static_cast<float>(i / 22500));
  }
  image->GetPointData()->AddArray(heights);
  const MadeFieldBlock made = brickOf(image, scalar("f"), Vec3(70.2, 70.3, 70.4), 0.01);
  ASSERT_TRUE(made.brick);
  EXPECT_NEAR(made.brick->sample(FieldBlockRole::Scalar, Vec3(70.2, 70.3, 70.4))->value, 70.4, 1e-4);
  EXPECT_GT(made.reach_u, 1.0);
}

TEST(FieldData, ACloudOfPointsIsInterpolatedBetweenThemAndEndsBesideThem)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (int i = 0; i < 6 * 6 * 6; ++i)
  {
    points->InsertNextPoint(i % 6, i / 6 % 6, i / 36);
    values->InsertNextValue(i == 0 ? 8.0 : 7.0); // the corner is far from where it is looked at
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->GetPointData()->AddArray(values);
  const MadeFieldBlock made = brickOf(cloud, scalar("f"));
  ASSERT_TRUE(made.brick);
  EXPECT_NEAR(
    made.brick->sample(FieldBlockRole::Scalar, Vec3(2.3, 2.6, 2.4))->value, 7.0, 1e-6); // an average of sevens
  EXPECT_FALSE(made.brick->sample(FieldBlockRole::Scalar, Vec3(9, 2, 2)));
}

TEST(FieldData, ValuesInWhichThereIsNothingToFeelAreRefusedInWords)
{
  const auto problem = [](double at, double step, int component = -1, const char* other = "")
  {
    const auto image = makeImage(5, 6, 7);
    for (const auto& [name, first, more] : { std::tuple("f", at, step), std::tuple("g", 0.0, 1.0) })
    {
      vtkNew<vtkDoubleArray> values;
      values->SetName(name);
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        values->InsertNextValue(first + more * image->GetPoint(i)[2]);
      }
      image->GetPointData()->AddArray(values);
    }
    vtkHapticFieldArrays arrays = scalar("f");
    arrays.Component = component;
    arrays.Other = other;
    return vtkHapticToField(image, arrays).Problem;
  };
  EXPECT_EQ(problem(0.0, 1.0), "");
  EXPECT_THAT(problem(3.0, 0.0), HasSubstr("the same value everywhere"));
  EXPECT_EQ(problem(3.0, 0.0, -1, "g"), ""); // it differs from another one
  EXPECT_EQ(problem(101325.0, 1e-5), "");    // floats are 0.008 apart there, and a block holds the differences
  EXPECT_THAT(problem(0.0, 1e300), HasSubstr("beyond single precision"));
  EXPECT_THAT(problem(std::nan(""), 1.0), HasSubstr("no finite values"));
  EXPECT_THAT(problem(0.0, 1.0, 1), HasSubstr("has 1 components, counted from 0"));
}

TEST(FieldData, ValuesThatDifferLittleFromALargeNumberAreFeltAsFinelyAsOthers)
{
  constexpr double pressure = 101325.0, slope = 1e-5; // floats are 0.008 apart there
  const auto image = makeImage(5, 6, 7);
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(pressure + slope * image->GetPoint(i)[2]);
  }
  image->GetPointData()->AddArray(values);
  const MadeFieldBlock made = brickOf(image, scalar("f"));
  ASSERT_TRUE(made.brick);
  double bounds[6];
  image->GetBounds(bounds);
  for (const double share : { 0.1, 0.43, 0.77 })
  {
    const Vec3 p(
      0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), bounds[4] + share * (bounds[5] - bounds[4]));
    const auto sample = made.brick->sample(FieldBlockRole::Scalar, p);
    ASSERT_TRUE(sample);
    EXPECT_NEAR(sample->value, pressure + slope * p.z(), 3e-11) << "two roundings of a double of that size";
    EXPECT_NEAR(sample->gradient_W.z(), slope, 1e-5 * slope);
  }
}

TEST(FieldData, WhatCannotBeFeltIsRefusedInWords)
{
  test::Random random(test::testSeed(1706));
  const auto image = makeImage(4, 4, 4);
  addRandom(*image, "f", 1, random);
  vtkNew<vtkStringArray> text;
  text->SetName("names");
  text->SetNumberOfValues(image->GetNumberOfPoints());
  image->GetPointData()->AddArray(text);
  EXPECT_THAT(vtkHapticToField(image, scalar("names")).Problem, HasSubstr("\"names\" is not numeric"));
  EXPECT_THAT(vtkHapticToField(image, scalar("gone")).Problem, HasSubstr("\"gone\""));
  EXPECT_THAT(vtkHapticToField(image, {}).Problem, HasSubstr("no array is chosen"));
  vtkHapticFieldArrays directions;
  directions.Vector = "f";
  EXPECT_THAT(vtkHapticToField(image, directions).Problem, HasSubstr("has 1 components, and directions need 3"));
  const auto slice = makeImage(4, 4, 1);
  addRandom(*slice, "f", 1, random);
  EXPECT_THAT(vtkHapticToField(slice, scalar("f")).Problem, HasSubstr("the data are flat"));
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  EXPECT_THAT(vtkHapticToField(sphere->GetOutput(), scalar("Normals")).Problem, HasSubstr("faces or lines"));
  vtkNew<vtkUnstructuredGrid> empty;
  EXPECT_THAT(vtkHapticToField(empty, scalar("f")).Problem, HasSubstr("it has no points"));
}

} // namespace
