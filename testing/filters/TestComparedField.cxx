// SPDX-License-Identifier: GPL-3.0-or-later
// Companions of a field: tensors, other data, places to snap to, the distance of a block from the data's own cells.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/support/Random.h"
#include "testing/support/Says.h"
#include "vtkCellArray.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkHapticFieldData.h"
#include "vtkHapticReaders.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"
#include "vtkRTAnalyticSource.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVectorFieldTopology.h"

using namespace palpate;
using ::testing::HasSubstr;

namespace
{
using Tuple = std::function<std::vector<double>(const Vec3&)>;

vtkSmartPointer<vtkImageData> imageWith(int points, const char* name, const Tuple& tuple)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  values->SetNumberOfComponents(static_cast<int>(tuple(Vec3::Zero()).size()));
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->InsertNextTuple(tuple(Vec3(image->GetPoint(i))).data());
  }
  image->GetPointData()->AddArray(values);
  return image;
}

vtkSmartPointer<vtkUnstructuredGrid> tetrahedraOf(vtkImageData* image)
{
  vtkNew<vtkDataSetTriangleFilter> split;
  split->SetInputData(image);
  split->Update();
  return split->GetOutput();
}

MadeFieldBlock madeOf(
  vtkDataObject* data, const vtkHapticFieldArrays& arrays, const vtkHapticComparedField& beside = {})
{
  const vtkHapticFieldResult field = vtkHapticToField(data, arrays, beside);
  EXPECT_EQ(field.Problem, "");
  return field.Source ? field.Source->brickAround({ Vec3::Zero(), std::numeric_limits<double>::infinity(), 1 })
                      : MadeFieldBlock{};
}

vtkHapticFieldArrays scalarF()
{
  vtkHapticFieldArrays arrays;
  arrays.Scalar = "f";
  arrays.Smoothing = 0;
  return arrays;
}

/// Round an axis beside the data, out from it, and along it: eigenvectors to the eigenvalues 3, -2 and 1.
Eigen::Matrix3d axesAt(const Vec3& p)
{
  const Vec3 out = Vec3(p.x() + 4.0, p.y() + 3.0, 0.0).normalized();
  return (Eigen::Matrix3d() << Vec3::UnitZ().cross(out), out, Vec3::UnitZ()).finished();
}

std::vector<double> tensorAt(const Vec3& p, int components)
{
  const Eigen::Matrix3d axes = axesAt(p);
  const Eigen::Matrix3d t = axes * Vec3(3.0, -2.0, 1.0).asDiagonal() * axes.transpose();
  if (components == 6)
  {
    return { t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2) };
  }
  const double turn = 0.7; // the antisymmetric part plays no part
  return { t(0, 0), t(0, 1) + turn, t(0, 2), t(1, 0) - turn, t(1, 1), t(1, 2), t(2, 0), t(2, 1), t(2, 2) };
}

TEST(FieldOfTensors, IsTheEigenvectorThatIsChosenAsLongAsItsValueOnImagesAndTetrahedra)
{
  const double length[3] = { 3.0, 1.0, 2.0 }; // of the largest, the middle and the least eigenvalue
  const int column[3] = { 0, 2, 1 };
  for (const int components : { 6, 9 })
  {
    const auto image = imageWith(6, "t", [=](const Vec3& p) { return tensorAt(p, components); });
    for (int which = 0; which < 3; ++which)
    {
      vtkHapticFieldArrays arrays;
      arrays.Vector = "t";
      arrays.Eigenvector = which;
      const MadeFieldBlock made = madeOf(image, arrays);
      ASSERT_TRUE(made.brick);
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        const Vec3 p(image->GetPoint(i)), truth = axesAt(p).col(column[which]);
        const auto axis = made.brick->axis(p, truth);
        ASSERT_TRUE(axis);
        EXPECT_LT((*axis - length[which] * truth).norm(), 1e-5) << p.transpose();
      }
    }
    // On tetrahedra tensors are linear between the points, and are half a cell apart at most: the directions turn by
    // less.
    vtkHapticFieldArrays arrays;
    arrays.Vector = "t";
    const MadeFieldBlock made = madeOf(tetrahedraOf(image), arrays);
    ASSERT_TRUE(made.brick);
    const Vec3 p(2.4, 2.6, 2.1), truth = axesAt(p).col(0);
    const auto axis = made.brick->axis(p, truth);
    ASSERT_TRUE(axis);
    EXPECT_LT(std::acos(std::min(1.0, axis->normalized().dot(truth))), 0.02);
  }
  vtkHapticFieldArrays four;
  four.Vector = "q";
  const auto image = imageWith(3, "q", [](const Vec3&) { return std::vector<double>(4, 1.0); });
  EXPECT_THAT(vtkHapticToField(image, four).Problem, HasSubstr("directions need 3, or the 6 or 9"));
}

TEST(FieldError, IsTheLargestDifferenceToVtksProbeInTheMiddleOfTheBricksCells)
{
  const auto bent = [](const Vec3& p) { return std::vector<double>{ p.squaredNorm() + p.x() * p.y() }; };
  const auto grid = tetrahedraOf(imageWith(4, "f", bent));
  const MadeFieldBlock made = madeOf(grid, scalarF());
  ASSERT_TRUE(made.brick);
  const FieldBlockGrid& points = made.brick->grid();
  ASSERT_LE(*std::max_element(points.size.begin(), points.size.end()), 13) << "every cell is looked at";
  vtkNew<vtkImageData> middles;
  middles->SetDimensions(points.size[0] - 1, points.size[1] - 1, points.size[2] - 1);
  middles->SetSpacing(points.spacing_u.data());
  middles->SetOrigin(points.toWorld(Vec3::Constant(0.5)).data());
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(middles);
  probe->SetSourceData(grid);
  probe->Update();
  vtkDataArray* const values = probe->GetOutput()->GetPointData()->GetArray("f");
  double largest = 0.0, low = 1e9, high = -1e9;
  for (vtkIdType i = 0; i < middles->GetNumberOfPoints(); ++i)
  {
    if (const auto sample = made.brick->sample(FieldBlockRole::Scalar, Vec3(middles->GetPoint(i))))
    {
      largest = std::max(largest, std::abs(sample->value - values->GetComponent(i, 0)));
      low = std::min(low, sample->value);
      high = std::max(high, sample->value);
    }
  }
  EXPECT_GT(made.error, 0.0);
  EXPECT_NEAR(made.error, largest / (high - low), 1e-6);
  EXPECT_EQ(madeOf(imageWith(4, "f", bent), scalarF()).error, 0.0) << "the voxels themselves are felt";
  const auto flat = [](const Vec3& p) { return std::vector<double>{ p.x() + 2.0 * p.z() }; };
  EXPECT_LT(madeOf(tetrahedraOf(imageWith(4, "f", flat)), scalarF()).error, 1e-6);
}

TEST(ComparedFieldData, ComparesWithAnArrayOfOtherDataOfAnotherKind)
{
  const auto height = [](const Vec3& p) { return std::vector<double>{ p.z() }; };
  const auto tilted = [](const Vec3& p) { return std::vector<double>{ p.z() + 0.5 * p.x() }; };
  const auto other = tetrahedraOf(imageWith(5, "f", tilted));
  const MadeFieldBlock made = madeOf(imageWith(5, "f", height), scalarF(), { other });
  ASSERT_TRUE(made.brick);
  const auto sample = made.brick->sample(FieldBlockRole::Other, Vec3(2, 1, 3));
  ASSERT_TRUE(sample);
  EXPECT_NEAR(sample->value, 4.0, 1e-5);
  vtkHapticFieldArrays gone = scalarF();
  gone.Other = "gone";
  EXPECT_THAT(vtkHapticToField(imageWith(5, "f", height), gone, { other }).Problem, HasSubstr("its array"));
}

TEST(ComparedFieldData, SnapsToLinesAndVerticesAndToTheBarePointsOfACloud)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 4; ++i)
  {
    points->InsertNextPoint(i, 1.0, i == 3 ? NAN : 2.0);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkHapticComparedField beside{ nullptr, data };
  const auto image = imageWith(4, "f", [](const Vec3& p) { return std::vector<double>{ p.z() }; });
  EXPECT_EQ(madeOf(image, scalarF(), beside).brick->places_W().size(), 3U) << "one of them is nowhere";
  const vtkIdType corners[3] = { 0, 1, 2 };
  vtkNew<vtkCellArray> lines, verts, faces;
  lines->InsertNextCell(3, corners);
  verts->InsertNextCell(1, corners + 2);
  data->SetLines(lines);
  data->SetVerts(verts);
  const MadeFieldBlock made = madeOf(image, scalarF(), beside);
  ASSERT_EQ(made.brick->lines_W().size(), 2U);
  EXPECT_TRUE(std::ranges::count(made.brick->lines_W(), FieldBlockLine{ Vec3(1, 1, 2), Vec3(2, 1, 2) }) == 1);
  ASSERT_EQ(made.brick->places_W().size(), 1U);
  EXPECT_EQ(made.brick->places_W()[0], Vec3(2, 1, 2));
  faces->InsertNextCell(3, corners);
  vtkNew<vtkPolyData> face;
  face->SetPoints(points);
  face->SetPolys(faces);
  EXPECT_THAT(vtkHapticToField(image, scalarF(), { nullptr, face }).Problem, HasSubstr("points or lines"));
}

TEST(FieldSnap, CriticalPointsAreThoseOfVtksVectorFieldTopology)
{
  const auto flow = [](const Vec3& p)
  {
    return std::vector<double>{ std::sin(0.6 * p.x() + 0.3) + 0.2 * p.y() - 1.0, std::cos(0.5 * p.y()) + 0.1 * p.z(),
      std::sin(0.45 * p.z() + 0.4) + 0.1 * std::cos(p.x()) };
  };
  const auto image = imageWith(16, "v", flow);
  image->GetPointData()->SetActiveVectors("v");
  vtkNew<vtkVectorFieldTopology> topology;
  topology->SetInputData(image);
  topology->SetMaxNumSteps(0);
  topology->Update();
  vtkPolyData* const theirs = topology->GetOutput(0);
  vtkHapticFieldArrays arrays;
  arrays.Vector = "v";
  const MadeFieldBlock made = madeOf(image, arrays);
  ASSERT_TRUE(made.brick);
  const std::vector<Vec3>& ours = made.brick->places_W();
  ASSERT_GT(ours.size(), 2U);
  // They are linear in tetrahedra, these trilinear in cells: a part of a cell apart.
  for (const Vec3& place_W : ours)
  {
    double nearest = 1e9;
    for (vtkIdType i = 0; i < theirs->GetNumberOfPoints(); ++i)
    {
      nearest = std::min(nearest, (Vec3(theirs->GetPoint(i)) - place_W).norm());
    }
    EXPECT_LT(nearest, 0.25) << place_W.transpose();
  }
  EXPECT_EQ(static_cast<std::size_t>(theirs->GetNumberOfPoints()), ours.size());
}

TEST(FieldOfTooLittle, IsRefusedInWords)
{
  const auto height = [](const Vec3& p) { return std::vector<double>{ p.z() }; };
  const auto all = tetrahedraOf(imageWith(2, "f", height));
  vtkNew<vtkUnstructuredGrid> one;
  one->SetPoints(all->GetPoints());
  one->GetPointData()->ShallowCopy(all->GetPointData());
  one->InsertNextCell(VTK_TETRA, all->GetCell(0)->GetPointIds());
  const vtkHapticFieldResult field = vtkHapticToField(one, scalarF());
  ASSERT_TRUE(field.Source);
  const MadeFieldBlock made = field.Source->brickAround({ Vec3::Zero(), 10.0, 1 });
  EXPECT_FALSE(made.brick);
  EXPECT_THAT(made.problem, HasSubstr("too few visible cells"));
  vtkNew<vtkImageData> row;
  row->SetDimensions(5, 1, 1);
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  values->SetNumberOfTuples(5);
  row->GetPointData()->AddArray(values);
  EXPECT_TRUE(test::says(vtkHapticToField(row, scalarF()).Problem, { "a single point" }));
  const vtkHapticFieldResult cell = vtkHapticToField(imageWith(2, "f", height), scalarF());
  ASSERT_TRUE(cell.Source) << "one cell of eight points is a field";
  EXPECT_TRUE(cell.Source->brickAround({ Vec3::Zero(), 10.0, 1 }).brick);
}

/// Noise beside the surface of a value, in the middle of an image.
double noiseAt(vtkImageData* image, const char* array, double level)
{
  vtkHapticFieldArrays arrays;
  arrays.Scalar = array;
  const vtkHapticFieldResult field = vtkHapticToField(image, arrays);
  EXPECT_EQ(field.Problem, "");
  const MadeFieldBlock made =
    field.Source->brickAround({ Vec3(image->GetCenter()), std::numeric_limits<double>::infinity(), 1, level });
  EXPECT_TRUE(made.brick);
  EXPECT_EQ(made.smoothness.passes, made.smoothness.noise > 0.2 ? 1 : 0);
  return made.smoothness.noise;
}

TEST(FieldNoise, IsInAMagneticResonanceImage)
{
  const char* const elsewhere = std::getenv("PALPATE_DATA");
  const std::filesystem::path file =
    std::filesystem::path(elsewhere != nullptr ? elsewhere : PALPATE_DATA_CACHE) / "brain.nii.gz";
  if (!std::filesystem::exists(file))
  {
    return; // data/get fetches it
  }
  const vtkHapticReadVolumeResult brain = vtkHapticReadVolume(file.string());
  ASSERT_TRUE(brain.Volume) << brain.Problem;
  EXPECT_GT(noiseAt(vtkImageData::SafeDownCast(brain.Volume), "NIFTI", 60.0), 0.2);
}

TEST(FieldNoise, IsNotInVtksWavelet)
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->Update();
  for (const double level : { 100.0, 150.0, 200.0, 240.0 })
  {
    EXPECT_EQ(noiseAt(wavelet->GetOutput(), "RTData", level), 0.0) << level;
  }
}
} // namespace
