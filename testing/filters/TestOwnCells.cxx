// SPDX-License-Identifier: GPL-3.0-or-later
// Graded meshes as fluid dynamics has them. The judges are VTK's probe of the cells and the formula of the profile.
#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "testing/support/Random.h"
#include "vtkAppendFilter.h"
#include "vtkFloatArray.h"
#include "vtkHapticFieldData.h"
#include "vtkHapticFieldPacket.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"
#include "vtkStructuredGrid.h"
#include "vtkTouchAlongPath.h"
#include "vtkUnstructuredGrid.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::IsEmpty;

namespace
{
constexpr double handStep_u = 0.012; ///< of a tick: 0.3 m/s where 25 mm of the hand are one unit
constexpr double layer_u = 0.0127;

double profile(double y)
{
  return 1.0 - std::exp(-y / layer_u);
}

/// Steps that grow until they are as long as asked.
std::vector<double> graded(double first, double growth, double end)
{
  std::vector<double> at{ 0.0 };
  for (double step = first; at.back() < end; step *= growth)
  {
    at.push_back(at.back() + step);
  }
  return at;
}

template<class Place, class Value>
vtkSmartPointer<vtkStructuredGrid> gridOf(const GridIndex& size, const Place& place, const Value& value)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> values;
  values->SetName("u");
  for (int n = 0; n < size[0] * size[1] * size[2]; ++n)
  {
    const Vec3 p = place(n % size[0], n / size[0] % size[1], n / (size[0] * size[1]));
    points->InsertNextPoint(p.data());
    values->InsertNextValue(static_cast<float>(value(p)));
  }
  grid->SetDimensions(size.data());
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(values);
  return grid;
}

/// Cells of 1e-3 at the wall y = 0, and of half a unit in the middle of the flow.
vtkSmartPointer<vtkStructuredGrid> channel(int along, int across)
{
  const std::vector<double> y = graded(1e-3, 1.2, 3.0);
  const double dx = 6.0 / (along - 1), dz = 3.0 / (across - 1);
  return gridOf(
    { along, static_cast<int>(y.size()), across },
    [&](int i, int j, int k) { return Vec3(dx * i, y[static_cast<std::size_t>(j)], dz * k); },
    [](const Vec3& p) { return profile(p.y()); });
}

/// Round a ball of radius 1, with a seam and two poles.
vtkSmartPointer<vtkStructuredGrid> oGrid()
{
  constexpr int turns = 48, bends = 25;
  const std::vector<double> r = graded(2e-3, 1.2, 4.0);
  return gridOf(
    { turns + 1, bends, static_cast<int>(r.size()) },
    [&](int i, int j, int k)
    {
      const double turn = 2.0 * std::numbers::pi * i / turns, bend = std::numbers::pi * j / (bends - 1);
      return Vec3((1.0 + r[static_cast<std::size_t>(k)]) *
                  Vec3(std::sin(bend) * std::cos(turn), std::sin(bend) * std::sin(turn), std::cos(bend)));
    },
    [](const Vec3& p) { return profile(p.norm() - 1.0); });
}

vtkSmartPointer<vtkTouchAlongPath> touched(vtkDataObject* data, const std::vector<Vec3>& hands_W, double value)
{
  auto touch = vtkSmartPointer<vtkTouchAlongPath>::New();
  touch->SetInputDataObject(0, data);
  touch->SetPathData(makePath(hands_W));
  touch->SetStiffness(400.0);
  touch->SetFieldArray("u");
  touch->FieldIsosurfaceOn();
  touch->SetFieldIsovalue(value);
  EXPECT_THAT(errorsOf(touch), IsEmpty());
  return touch;
}

/// What the cells of data have at the points of other data; NaN where VTK finds none.
std::vector<double> probed(vtkDataSet* at, vtkDataSet* data)
{
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(at);
  probe->SetSourceData(data);
  probe->Update();
  vtkDataArray* const found = probe->GetOutput()->GetPointData()->GetArray("u");
  vtkDataArray* const valid = probe->GetOutput()->GetPointData()->GetArray(probe->GetValidPointMaskArrayName());
  std::vector<double> values;
  for (vtkIdType i = 0; i < at->GetNumberOfPoints(); ++i)
  {
    values.push_back(valid->GetTuple1(i) != 0.0 ? found->GetTuple1(i) : std::nan(""));
  }
  return values;
}

vtkSmartPointer<vtkUnstructuredGrid> unstructured(vtkDataSet* data)
{
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(data);
  append->Update();
  return append->GetOutput();
}

TEST(OwnCells, OfAChannelAreFeltWithinAQuarterOfTheLocalCellAndNeverCrossedAtThirtyCentimetresASecond)
{
  const auto structured = channel(25, 13);
  const std::vector<double> y = graded(1e-3, 1.2, 3.0);
  const std::vector<vtkSmartPointer<vtkDataSet>> kinds{ structured, unstructured(structured) };
  for (vtkDataSet* data : kinds)
  {
    for (const double u : data == structured.Get() ? std::vector{ 0.5, 0.99 } : std::vector{ 0.9 })
    {
      std::vector<Vec3> hands_W;
      for (double at = 0.2; at > -0.2; at -= handStep_u) // through the wall
      {
        hands_W.emplace_back(1.1, at, 1.4);
      }
      const std::size_t inside = hands_W.size();
      for (double way = 0.0; way < 0.8; way += handStep_u) // and along it
      {
        hands_W.emplace_back(1.1 + way, -0.2, 1.4 + 0.4 * std::sin(2.0 * way));
      }
      const auto touch = touched(data, hands_W, u);
      vtkPolyData* const output = touch->GetOutput();
      const std::vector<double> felt = probed(output, data);
      const double surface = -layer_u * std::log(1.0 - u);
      const double cell =
        *std::upper_bound(y.begin(), y.end(), surface) - *(std::upper_bound(y.begin(), y.end(), surface) - 1);
      for (std::size_t i = 0; i < hands_W.size(); ++i)
      {
        const Vec3 x(output->GetPoint(static_cast<vtkIdType>(i)));
        ASSERT_GE(felt[i], u - 1e-6) << "row " << i << ", hand at " << hands_W[i].transpose();
        ASSERT_NEAR(x.y(), std::max(surface, hands_W[i].y()), 0.25 * cell) << u << ", row " << i;
      }
      EXPECT_NEAR(
        Vec3(output->GetPoint(static_cast<vtkIdType>(inside) + 60)).x(), hands_W[inside + 60].x(), handStep_u);
    }
  }
}

TEST(OwnCells, OfAnOGridAreFeltOverItsSeamAndNeverCrossed)
{
  const auto data = oGrid();
  for (const double u : { 0.9 })
  {
    std::vector<Vec3> hands_W;
    const auto at = [](double turn) { return Vec3(std::cos(turn), 0.8 * std::sin(turn), 0.6 * std::sin(turn)); };
    for (double r = 1.1; r > 0.95; r -= handStep_u)
    {
      hands_W.push_back(r * at(-0.5));
    }
    const std::size_t inside = hands_W.size();
    for (double turn = -0.5; turn < 0.7; turn += handStep_u) // over the seam
    {
      hands_W.push_back(0.95 * at(turn));
    }
    const auto touch = touched(data, hands_W, u);
    vtkPolyData* const output = touch->GetOutput();
    const std::vector<double> felt = probed(output, data);
    for (std::size_t i = 0; i < hands_W.size(); ++i)
    {
      const Vec3 x(output->GetPoint(static_cast<vtkIdType>(i)));
      ASSERT_GE(felt[i], u - 1e-4) << "row " << i; // as near as VTK's search of a bent cell
      if (i >= inside)
      {
        ASSERT_NEAR(felt[i], u, 0.02) << "row " << i;
        ASSERT_LT((x.normalized() - hands_W[i].normalized()).norm(), 0.1) << "it comes along, row " << i;
      }
    }
  }
}

TEST(OwnCells, OfMoreThanAreHandedOutAtATimeAreThoseAroundTheHandWithTheValuesOfVtksProbe)
{
  const auto data = channel(121, 61);
  ASSERT_GT(data->GetNumberOfCells(), 200'000);
  vtkHapticFieldArrays arrays;
  arrays.Scalar = "u";
  const vtkHapticFieldResult field = vtkHapticToField(data, arrays);
  ASSERT_TRUE(field.Source) << field.Problem;
  test::Random random(test::testSeed(2803));
  for (const Vec3& hand_W : { Vec3(1.0, 0.02, 1.0), Vec3(4.0, 1.0, 2.0) })
  {
    const MadeBrick made = field.Source->brickAround({ hand_W, 1.0, 1 });
    ASSERT_TRUE(made.brick && made.brick->cells());
    EXPECT_LE(made.brick->bytes(), Brick::mostBytes);
    EXPECT_LE(made.finerReach_u, made.brick->cells()->parts().reach_u);
    const double reach_u = made.brick->cells()->parts().reach_u;
    EXPECT_GT(reach_u, 0.3);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int i = 0; i < 500; ++i)
    {
      Vec3 p = hand_W + random.inCube(0.99 * reach_u);
      p.y() = std::fabs(p.y());
      points->InsertNextPoint(p.data());
    }
    vtkNew<vtkPolyData> places;
    places->SetPoints(points);
    const std::vector<double> values = probed(places, data);
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      const auto felt = made.brick->scalarFelt(Vec3(points->GetPoint(i)));
      const double value = values[static_cast<std::size_t>(i)];
      ASSERT_EQ(felt.has_value(), !std::isnan(value)) << Vec3(points->GetPoint(i)).transpose();
      ASSERT_TRUE(!felt || std::fabs(*felt - value) < 1e-6);
    }
  }
}

TEST(OwnCells, ComeFromAServerAsTheyAre)
{
  const auto data = channel(9, 5);
  vtkHapticFieldArrays arrays;
  arrays.Scalar = "u";
  vtkHapticFieldPacket packet;
  packet.Made = vtkHapticToField(data, arrays).Source->brickAround({ Vec3(1, 0.1, 1), 1.0, 1 });
  ASSERT_TRUE(packet.Made.brick && packet.Made.brick->cells());
  const auto there = vtkHapticUnpackField(vtkHapticPackField(packet));
  ASSERT_TRUE(there && there->Made.brick && there->Made.brick->cells());
  EXPECT_EQ(there->Made.brick->contentHash(), packet.Made.brick->contentHash());
}

/// Whether the surface of a height holds a hand that comes from above.
bool holds(vtkDataSet* data, double x, double y, double height)
{
  const auto touch = touched(data, { Vec3(x, y, height + 0.2), Vec3(x, y, height - 0.2) }, height);
  return Vec3(touch->GetOutput()->GetPoint(1)).z() > height - 0.1;
}

TEST(OwnCells, ThatAreHiddenAreFeltToTheirFaceAndOfAPointWithoutAValueItsCellsAlone)
{
  const auto make = [](bool hole)
  {
    return gridOf(
      { 9, 7, 7 }, [](int i, int j, int k) { return Vec3(i, j + 0.01 * i, k); },
      [hole](const Vec3& p) { return hole && p.x() == 4.0 && p.z() == 3.0 ? std::nan("") : p.z(); });
  };
  for (const bool isUnstructured : { false, true })
  {
    const auto hidden = make(false), without = make(true);
    vtkSmartPointer<vtkDataSet> felt = hidden, lacking = without;
    if (isUnstructured)
    {
      felt = unstructured(hidden);
      lacking = unstructured(without);
    }
    felt->AllocateCellGhostArray();
    for (vtkIdType i = 0; i < felt->GetNumberOfCells(); ++i)
    {
      const bool beyond = felt->GetCell(i)->GetBounds()[0] >= 4.0;
      felt->GetCellGhostArray()->SetValue(i, beyond ? vtkDataSetAttributes::HIDDENCELL : 0);
    }
    EXPECT_TRUE(holds(felt, 3.99, 2.5, 2.5));
    EXPECT_FALSE(holds(felt, 4.01, 2.5, 2.5));
    for (const double height : { 2.5, 3.5 })
    {
      EXPECT_TRUE(holds(lacking, 2.99, 2.5, height) && holds(lacking, 5.01, 2.5, height)) << height;
      EXPECT_FALSE(holds(lacking, 3.01, 2.5, height) || holds(lacking, 4.99, 2.5, height)) << height;
    }
    EXPECT_TRUE(holds(lacking, 4.0, 2.5, 1.5) && holds(lacking, 4.0, 2.5, 4.5)) << "next to them";
  }
}
} // namespace
