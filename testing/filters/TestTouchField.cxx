// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in space felt along a path. Judges: formulas, and VTK's probe of the values where the proxy is.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "vtkCallbackCommand.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkHapticFlowSource.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"
#include "vtkTouchAlongPath.h"
#include "vtkUnstructuredGrid.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace
{
constexpr double touchStiffness = 400.0;

vtkSmartPointer<vtkImageData> sampledImage(double (*function)(const Vec3&))
{
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(21, 21, 21);
  data->SetOrigin(-5.0, -5.0, -5.0);
  data->SetSpacing(0.5, 0.5, 0.5);
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(function(Vec3(data->GetPoint(i))));
  }
  data->GetPointData()->AddArray(values);
  return data;
}

vtkSmartPointer<vtkTouchAlongPath> touchField(vtkDataObject* input, const std::vector<Vec3>& points_W)
{
  auto touch = vtkSmartPointer<vtkTouchAlongPath>::New();
  touch->SetInputDataObject(0, input);
  touch->SetPathData(makePath(points_W));
  touch->SetSetting("Stiffness", touchStiffness);
  return touch;
}

Vec3 tuple(vtkPolyData& output, const char* array, vtkIdType row)
{
  Vec3 value;
  output.GetPointData()->GetArray(array)->GetTuple(row, value.data());
  return value;
}

double heightOf(const Vec3& p)
{
  return p.z();
}

/// Bent, and with both signs of curvature.
double waves(const Vec3& p)
{
  return p.z() + 0.5 * std::sin(p.x()) * std::cos(0.8 * p.y());
}

/// In from above and then on a wide turn below the surface.
std::vector<Vec3> slide(double depth)
{
  std::vector<Vec3> points_W{ Vec3(3, 0, 3) };
  for (int i = 0; i <= 1500; ++i)
  {
    const double turn = 0.004 * i;
    const Vec3 p(3 * std::cos(turn), 3 * std::sin(turn), 0.0);
    points_W.emplace_back(p.x(), p.y(), p.z() - waves(p) - depth);
  }
  return points_W;
}

TEST(TouchField, AnIsosurfaceIsWhereVtksProbeFindsItsValueAndPushesOut)
{
  const auto data = sampledImage(waves);
  const auto touch = touchField(data, slide(0.2));
  touch->SetSetting("FieldArray", "f");
  touch->SetSetting("FieldIsosurface", 1);
  touch->SetSetting("FieldIsovalue", 0.125);
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  vtkPolyData* const output = touch->GetOutput();
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(output);
  probe->SetSourceData(data);
  probe->Update();
  vtkDataArray* const found = probe->GetOutput()->GetPointData()->GetArray("f");
  for (vtkIdType i = 1; i < output->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(found->GetTuple1(i), 0.125, 1e-6) << i; // values of a block are floats
    EXPECT_GT(tuple(*output, "Force", i).z(), 0.0);
    EXPECT_LT(
      (tuple(*output, "Force", i) - touchStiffness * (Vec3(output->GetPoint(i)) - tuple(*output, "Device", i))).norm(),
      1e-9 * touchStiffness);
    EXPECT_GE(output->GetPointData()->GetArray("Contacts")->GetTuple1(i), 1.0);
  }
}

TEST(TouchField, OnTetrahedraTheSurfaceOfALinearFieldIsThatOfTheImage)
{
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputData(sampledImage(heightOf));
  cut->Update();
  const auto touch = touchField(cut->GetOutput(), { Vec3(0.3, 0.2, 1.0), Vec3(0.3, 0.2, 0.0), Vec3(0.4, 0.1, -0.5) });
  touch->SetSetting("FieldArray", "f");
  touch->SetSetting("FieldIsosurface", 1);
  touch->SetSetting("FieldIsovalue", 0.3);
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  EXPECT_LT((tuple(*touch->GetOutput(), "Force", 1) - Vec3(0, 0, 0.3 * touchStiffness)).norm(), 1e-4 * touchStiffness);
  EXPECT_LT((tuple(*touch->GetOutput(), "Force", 2) - Vec3(0, 0, 0.8 * touchStiffness)).norm(), 1e-4 * touchStiffness);
}

TEST(TouchField, AFieldBesideASurfaceIsFeltWithIt)
{
  const auto touch = touchField(makePlane(10.0), { Vec3(0.3, 0.2, 1.0), Vec3(0.3, 0.2, -0.25) });
  touch->SetFieldData(sampledImage([](const Vec3& p) { return p.x(); }));
  touch->SetSetting("FieldArray", "f");
  touch->SetSetting("FieldIsosurface", 1);
  touch->SetSetting("FieldIsovalue", 0.0);
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  EXPECT_LT((tuple(*touch->GetOutput(), "Force", 1) - Vec3(0, 0, 0.25 * touchStiffness / 2)).norm(), 1e-9);
  touch->SetPathData(makePath({ Vec3(0.3, 0.2, 1.0), Vec3(-0.5, 0.2, -0.25) }));
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  EXPECT_LT((tuple(*touch->GetOutput(), "Force", 1) - Vec3(0.5, 0, 0.25) * touchStiffness / 2).norm(), 1e-9);
}

/// Ten turns of a hand beside the circle at `radius` round the z axis: how far the proxy drifts from it at most,
/// relative.
double drift(vtkHapticFlowSource* flow, double radius, double beside)
{
  constexpr int turns = 10, ticksATurn = 600;
  std::vector<Vec3> points_W{ Vec3(radius, 0, 0.1) };
  for (int i = 0; i <= turns * ticksATurn; ++i)
  {
    const double turn = 2.0 * std::numbers::pi * i / ticksATurn;
    points_W.emplace_back((radius + beside) * std::cos(turn), (radius + beside) * std::sin(turn), 0.1);
  }
  flow->Update();
  const auto touch = touchField(flow->GetOutputDataObject(0), points_W);
  touch->SetSetting("FieldVectors", "Velocity");
  touch->SetSetting("FieldFollow", 1000.0);
  EXPECT_THAT(errorsOf(touch), IsEmpty());
  double most = 0.0;
  for (vtkIdType i = 0; i < touch->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const Vec3 p(touch->GetOutput()->GetPoint(i));
    most = std::max(most, std::fabs(std::hypot(p.x(), p.y()) / radius - 1.0));
  }
  return most;
}

TEST(TouchField, TenTurnsRoundAVortexStayOnItsStreamlineAndFinerCellsHoldItBetter)
{
  vtkNew<vtkHapticFlowSource> flow;
  flow->SetFlow(vtkHapticFlowSource::LambOseen);
  for (const int cells : { vtkHapticFlowSource::Image, vtkHapticFlowSource::Tetrahedra })
  {
    flow->SetCells(cells);
    flow->SetResolution(25);
    const double coarse = drift(flow, 2.0, 0.1);
    flow->SetResolution(49);
    const double fine = drift(flow, 2.0, 0.1);
    // A streamline of linear interpolation leaves the true one by its error, of second order.
    EXPECT_LT(fine, 0.5 * coarse) << cells;
    EXPECT_LT(fine, 5e-3) << cells;
  }
}

TEST(TouchField, OtherDataAreComparedWithAndSnappedTo)
{
  const auto touch = touchField(sampledImage(heightOf), { Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(0, 2, 0) });
  touch->SetSetting("FieldArray", "f");
  touch->SetSetting("FieldSnap", 0.5);
  touch->SetSetting("FieldSnapReach", 4.0);
  touch->SetSnapData(makePath({ Vec3(-4, 0, 0), Vec3(4, 0, 0) }));
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  EXPECT_LT((tuple(*touch->GetOutput(), "Force", 2) - Vec3(0, -0.25, 0)).norm(), 1e-9) << "half of the reach away";
  touch->SetSnapData(nullptr);
  touch->SetSetting("FieldSnap", 0.0);
  touch->SetSetting("FieldCompare", 0.4);
  touch->SetComparedData(sampledImage([](const Vec3& p) { return p.z() + 0.5; }));
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  EXPECT_LT((tuple(*touch->GetOutput(), "Force", 2) - Vec3(0, -0.5 * 0.4, 0)).norm(), 1e-6)
    << "half of a difference of 1";
  touch->SetSetting("FieldArray", "");
  touch->SetSetting("FieldCompare", 0.0);
  touch->SetInputDataObject(0, makePlane(10.0));
  const auto errors = errorsOf(touch);
  ASSERT_FALSE(errors.empty());
  EXPECT_THAT(errors.front(), HasSubstr("need a field"));
}

TEST(TouchField, LevelsThatAreAskedToBeTooStrongAreAWarning)
{
  const auto touch = touchField(sampledImage(heightOf), { Vec3(0, 0, 0), Vec3(0, 0, 0.1), Vec3(0, 0, 0.2) });
  touch->SetSetting("FieldArray", "f");
  touch->SetSetting("FieldDetent", 1.0);
  touch->SetSetting("FieldDetentSpacing", 2.0);
  std::string warnings;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&warnings);
  listener->SetCallback([](vtkObject*, unsigned long, void* all, void* text)
    { *static_cast<std::string*>(all) += static_cast<const char*>(text); });
  touch->AddObserver(vtkCommand::WarningEvent, listener);
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  EXPECT_THAT(warnings, IsEmpty());
  touch->SetSetting("FieldDetent", 1000.0);
  ASSERT_THAT(errorsOf(touch), IsEmpty());
  // A slope of 1 without a bend: 0.9 k against 32 s / (3.08 D), which is 69 N.
  EXPECT_THAT(warnings, HasSubstr("smooth levels hold with 69 N"));
}

TEST(TouchField, WhatCannotBeFeltIsSaidInOneLineAndTheOutputIsEmpty)
{
  const auto touch = touchField(sampledImage(heightOf), { Vec3(0, 0, 1), Vec3(0, 0, -1) });
  const auto expect = [&](const char* words)
  {
    const auto errors = errorsOf(touch);
    ASSERT_FALSE(errors.empty()) << words;
    EXPECT_THAT(errors.front(), HasSubstr(words));
    EXPECT_EQ(touch->GetOutput()->GetNumberOfPoints(), 0);
  };
  touch->SetSetting("FieldIsosurface", 1);
  expect("set FieldArray");
  touch->SetSetting("FieldArray", "gone");
  expect("\"gone\"");
  touch->SetSetting("FieldArray", "f");
  touch->SetSetting("FieldIsosurface", 0);
  expect("set FieldIsosurface");
  touch->SetSetting("FieldPush", 3.0);
  expect("FieldPush: ");
  touch->SetSetting("FieldPush", 0.0);
  touch->SetSetting("FieldSmoothing", 9);
  expect("FieldSmoothing: ");
  touch->SetSetting("FieldSmoothing", 0);
  touch->SetSetting("FieldVectors", "f");
  touch->SetSetting("FieldFollow", 1.0);
  expect("directions need 3");
}
} // namespace
