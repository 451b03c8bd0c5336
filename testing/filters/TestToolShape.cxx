// SPDX-License-Identifier: GPL-3.0-or-later
// Tools to hold and what they go into. Judges: VTK's own edges and volume, and the formulas of pegs and screws.
#include <cmath>
#include <functional>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "vtkDoubleArray.h"
#include "vtkFeatureEdges.h"
#include "vtkHapticToolShape.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTouchAlongPath.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;

namespace
{
constexpr double pi = std::numbers::pi;
constexpr double radius = 5.0, depth = 20.0, clearance = 0.2, chamfer = 1.0, pitch = 4.0, lever = 3.0;

vtkSmartPointer<vtkHapticToolShape> shapeOf(int shape, int resolution = 6)
{
  auto source = vtkSmartPointer<vtkHapticToolShape>::New();
  source->SetShape(shape);
  source->SetResolution(resolution);
  source->SetClearance(clearance);
  source->Update();
  return source;
}

double volumeOf(vtkHapticToolShape& source)
{
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(source.GetOutput());
  mass->Update();
  return mass->GetVolume();
}

/// Of a regular polygon in a circle.
double polygon(double r, int corners)
{
  return 0.5 * corners * std::sin(2.0 * pi / corners) * r * r;
}

double frustum(double bottom, double top, double height)
{
  return height / 3.0 * (bottom + top + std::sqrt(bottom * top));
}

vtkSmartPointer<vtkTouchAlongPath> lead(int tool, int into, const std::vector<Pose>& hand)
{
  std::vector<Vec3> points_W;
  vtkNew<vtkDoubleArray> turns;
  turns->SetName("turn");
  turns->SetNumberOfComponents(4);
  for (const Pose& pose : hand)
  {
    points_W.push_back(pose.p);
    turns->InsertNextTuple4(pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z());
  }
  const auto path = makePath(points_W);
  path->GetPointData()->AddArray(turns);
  auto touch = vtkSmartPointer<vtkTouchAlongPath>::New();
  touch->SetInputData(shapeOf(into)->GetOutput());
  touch->SetToolData(shapeOf(tool)->GetOutput());
  touch->SetPathData(path);
  touch->SetTurnArray("turn");
  touch->SetLever(lever);
  touch->Update();
  return touch;
}

Pose turned(double angle, double height, double aside = 0.0)
{
  return { Vec3(aside, 0.0, height), Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())) };
}
} // namespace

TEST(ToolShape, EachIsClosedAndFacesOutward)
{
  for (int shape = vtkHapticToolShape::Peg; shape <= vtkHapticToolShape::Burr; ++shape)
  {
    const auto source = shapeOf(shape);
    vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(source->GetOutput());
    edges->FeatureEdgesOff();
    edges->BoundaryEdgesOn();
    edges->NonManifoldEdgesOn();
    edges->ManifoldEdgesOff();
    edges->Update();
    EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0) << shape;
    EXPECT_GT(volumeOf(*source), 0.0) << shape;
  }
}

TEST(ToolShape, TheirVolumesAreThoseOfTheFormulas)
{
  const int corners = 48;
  const double peg = polygon(radius, corners) * (depth - chamfer) +
                     frustum(polygon(radius, corners), polygon(radius - chamfer, corners), chamfer);
  EXPECT_NEAR(volumeOf(*shapeOf(vtkHapticToolShape::Peg)), peg, 1e-9 * peg);
  const double bore = radius + clearance, outer = 2.0 * bore + chamfer;
  const double hollow = polygon(bore, corners) * (depth - chamfer) +
                        frustum(polygon(bore, corners), polygon(bore + chamfer, corners), chamfer);
  const double block = 4.0 * outer * outer * depth - hollow;
  EXPECT_NEAR(volumeOf(*shapeOf(vtkHapticToolShape::Hole)), block, 1e-9 * block);
  // The thread's height runs evenly from 0 to h: the mean of r^2 is R^2 + R h + h^2 / 3.
  const double h = pitch / 2.0, screw = pi * depth * (radius * radius + radius * h + h * h / 3.0);
  EXPECT_NEAR(volumeOf(*shapeOf(vtkHapticToolShape::Screw, 24)), screw, 0.005 * screw);
}

TEST(ToolShape, APegThatIsLedBesideItsHoleGoesDownInItAsFarAsItIsLedAndLeansOnItsWall)
{
  std::vector<Pose> hand;
  for (int i = 0; i <= 40; ++i)
  {
    hand.push_back(turned(0.0, depth + 1.0 - 0.5 * i));
  }
  hand.push_back(turned(0.0, 1.0, 0.5)); // aside, by more than there is room
  const auto touch = lead(vtkHapticToolShape::Peg, vtkHapticToolShape::Hole, hand);
  vtkDataArray* const force = touch->GetOutput()->GetPointData()->GetArray("Force");
  for (vtkIdType i = 0; i < 41; ++i)
  {
    EXPECT_EQ(force->GetComponent(i, 2), 0.0) << i; // there is room all the way
  }
  const Vec3 last(touch->GetOutput()->GetPoint(41));
  EXPECT_NEAR(last.x(), clearance, 0.15 * clearance) << "aside as far as there is room, and a little by leaning";
  EXPECT_LT(force->GetComponent(41, 0), 0.0);
}

TEST(ToolShape, AScrewThatIsPulledOutOfItsNutTurnsByTheFormula)
{
  // Turned with its pitch it is free. Pulled by h without a turn it turns by t and rises by z = play + p t / 2 pi, such
  // that (h - z)^2 + L^2 t^2 is least: t = k (h - play) / (L^2 + k^2) with k = p / 2 pi.
  std::vector<Pose> hand;
  const double k = pitch / (2.0 * pi);
  for (int i = 0; i <= 20; ++i)
  {
    hand.push_back(turned(0.1 * i, 0.1 * i * k));
  }
  const double h = 3.0;
  hand.push_back(turned(2.0, 2.0 * k + h));
  const auto touch = lead(vtkHapticToolShape::Screw, vtkHapticToolShape::Nut, hand);
  vtkPointData* const data = touch->GetOutput()->GetPointData();
  ASSERT_EQ(touch->GetOutput()->GetNumberOfPoints(), 22);
  for (vtkIdType i = 0; i < 21; ++i)
  {
    EXPECT_EQ(data->GetArray("Force")->GetComponent(i, 2), 0.0) << i;
  }
  const double play = clearance * (pitch / 2.0) / (pitch / 2.0); // radial room over the slope of the flank
  const double turn = k * (h - play) / (lever * lever + k * k);
  EXPECT_NEAR(data->GetArray("Angle")->GetComponent(21, 0) * pi / 180.0, turn, 0.05 * turn);
  EXPECT_NEAR(touch->GetOutput()->GetPoint(21)[2], 2.0 * k + play + k * turn, 0.05 * h);
}

TEST(ToolShape, SizesThatMakeNoShapeAreRefusedInWords)
{
  const auto refusal = [](const std::function<void(vtkHapticToolShape&)>& change)
  {
    vtkNew<vtkHapticToolShape> source;
    change(*source);
    const std::vector<std::string> problems = errorsOf(source);
    return problems.empty() ? std::string() : problems.front();
  };
  EXPECT_THAT(refusal([](auto& s) { s.SetRadius(0.0); }), HasSubstr("finite numbers above 0"));
  EXPECT_THAT(refusal([](auto& s) { s.SetLength(std::nan("")); }), HasSubstr("finite numbers above 0"));
  EXPECT_THAT(refusal([](auto& s) { s.SetChamfer(5.0); }), HasSubstr("the chamfer must be"));
  EXPECT_THAT(refusal(
                [](auto& s)
                {
                  s.SetShape(vtkHapticToolShape::Burr);
                  s.SetLength(9.0);
                }),
    HasSubstr("longer than its ball"));
  EXPECT_THAT(refusal(
                [](auto& s)
                {
                  s.SetShape(vtkHapticToolShape::Screw);
                  s.SetPitch(1e-3);
                }),
    HasSubstr("too many turns"));
}
