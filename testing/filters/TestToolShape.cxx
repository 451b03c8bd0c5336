// SPDX-License-Identifier: GPL-3.0-or-later
// Tools to hold and their counterparts. Judges: VTK's own edges and volume, and the formulas of pegs and screws.
#include <cmath>
#include <functional>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "vtkDoubleArray.h"
#include "vtkFeatureEdges.h"
#include "vtkHapticConversion.h"
#include "vtkHapticNeedle.h"
#include "vtkHapticToolShape.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTouchAlongPath.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::Contains;
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

double volumeOf(vtkPolyDataAlgorithm& source)
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

void expectClosedOutward(vtkPolyDataAlgorithm& source)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(source.GetOutput());
  edges->FeatureEdgesOff();
  edges->BoundaryEdgesOn();
  edges->NonManifoldEdgesOn();
  edges->ManifoldEdgesOff();
  edges->Update();
  EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_NEAR(enclosedVolume(*vtkHapticToMesh(source.GetOutput()).Mesh), volumeOf(source), 1e-9 * volumeOf(source))
    << "positive if they face outward; VTK's own has no sign";
}

vtkSmartPointer<vtkTouchAlongPath> lead(
  vtkHapticToolShape& tool, vtkHapticToolShape& into, const std::vector<Pose>& hand)
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
  touch->SetInputData(into.GetOutput());
  touch->SetToolData(tool.GetOutput());
  touch->SetPathData(path);
  touch->SetTurnArray("turn");
  touch->SetSetting("ToolLever", lever);
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
    expectClosedOutward(*shapeOf(shape));
  }
}

TEST(ToolShape, ANeedleIsAClosedRodThatHangsFromItsHandAndEndsInAPoint)
{
  constexpr double length = 40.0, diameter = 2.0, point = 1.5 * diameter;
  constexpr int corners = 12;
  vtkNew<vtkHapticNeedle> needle;
  needle->SetLength(length);
  needle->SetDiameter(diameter);
  needle->SetResolution(corners);
  needle->Update();
  expectClosedOutward(*needle);
  const double across = polygon(diameter / 2.0, corners), volume = across * (length - point) + across * point / 3.0;
  EXPECT_NEAR(volumeOf(*needle), volume, 2e-3 * across * point) << "but for the point, which is a thousandth wide";
  double bounds[6];
  needle->GetOutput()->GetBounds(bounds);
  EXPECT_EQ(bounds[4], -length);
  EXPECT_EQ(bounds[5], 0.0);
  EXPECT_DOUBLE_EQ(bounds[1], diameter / 2.0);
}

TEST(ToolShape, ANeedleThatIsAllPointOrHasNoWidthIsRefusedInWords)
{
  for (const auto& [length, diameter] : { std::pair(1.5, 1.0), std::pair(10.0, 0.0), std::pair(10.0, -1.0) })
  {
    vtkNew<vtkHapticNeedle> needle;
    needle->SetLength(length);
    needle->SetDiameter(diameter);
    EXPECT_THAT(errorsOf(needle), Contains(HasSubstr("No needle was made"))) << length << " " << diameter;
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
  hand.push_back(turned(0.0, 1.0, 0.5)); // aside, by more than the clearance
  const auto touch = lead(*shapeOf(vtkHapticToolShape::Peg), *shapeOf(vtkHapticToolShape::Hole), hand);
  vtkDataArray* const force = touch->GetOutput()->GetPointData()->GetArray("Force");
  for (vtkIdType i = 0; i < 41; ++i)
  {
    EXPECT_EQ(force->GetComponent(i, 2), 0.0) << i; // there is clearance all the way
  }
  const Vec3 last(touch->GetOutput()->GetPoint(41));
  // It leans until it touches the mouth, 2 below the hand where the chamfer ends, and the other wall where its own
  // begins, 19 below: x - 2 t = c and x - 19 t = -c.
  const double lean = 2.0 * clearance / 17.0;
  EXPECT_NEAR(last.x(), clearance + 2.0 * lean, 0.01 * clearance) << "but for the corners of its polygon";
  EXPECT_NEAR(
    touch->GetOutput()->GetPointData()->GetArray("Angle")->GetComponent(41, 0) * pi / 180.0, lean, 0.02 * lean);
  EXPECT_LT(force->GetComponent(41, 0), 0.0);
}

TEST(ToolShape, AScrewIsFreeInItsNutAlongItsPitchAndPulledStraightTurnsAndRisesByPlayAndPitch)
{
  const auto screw = shapeOf(vtkHapticToolShape::Screw, 3), nut = shapeOf(vtkHapticToolShape::Nut, 3);
  for (const auto& shape : { screw, nut })
  {
    shape->SetLength(8.0);
    shape->Update();
  }
  const double perTurn = pitch / (2.0 * pi), pulled = 1.0, last = 0.6;
  const auto touch = lead(*screw, *nut,
    { turned(0.0, 0.0), turned(0.3, 0.3 * perTurn), turned(last, last * perTurn),
      turned(last, last * perTurn + pulled) });
  vtkPointData* const data = touch->GetOutput()->GetPointData();
  ASSERT_EQ(touch->GetOutput()->GetNumberOfPoints(), 4);
  for (vtkIdType i = 0; i < 3; ++i)
  {
    EXPECT_EQ(data->GetArray("Force")->GetComponent(i, 2), 0.0) << i;
  }
  double q[4];
  data->GetArray("Turn")->GetTuple(3, q);
  const double turn = 2.0 * std::atan2(q[3], q[0]) - last;
  EXPECT_GT(turn, 0.01) << "out of the nut";
  // The flank rises by one half of the pitch over the other half: the radial clearance is as much clearance along the
  // axis. The corners of both meet where they face each other; between, the clearance is less by the sagitta of a
  // chord.
  const double flatter = (radius + 0.5 * pitch + clearance) * (1.0 - std::cos(pi / 24.0));
  const double rise = touch->GetOutput()->GetPoint(3)[2] - last * perTurn - perTurn * turn;
  EXPECT_LE(rise, clearance * 1.001);
  EXPECT_GE(rise, clearance - flatter);
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
  EXPECT_EQ(refusal(
              [](auto& s)
              {
                s.SetShape(vtkHapticToolShape::Burr);
                s.SetRadius(0.5);
              }),
    "")
    << "a burr smaller than the chamfer that it has not";
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
