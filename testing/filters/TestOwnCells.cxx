// SPDX-License-Identifier: GPL-3.0-or-later
// Graded meshes as fluid dynamics has them. The judges are VTK's probe of the cells and the formula of the profile.
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "GradedMeshes.h"
#include "VtkScenes.h"
#include "testing/support/LongForm.h"
#include "testing/support/Random.h"
#include "testing/support/Says.h"
#include "vtkAMRBox.h"
#include "vtkAppendFilter.h"
#include "vtkCallbackCommand.h"
#include "vtkCellType.h"
#include "vtkFloatArray.h"
#include "vtkHapticFieldData.h"
#include "vtkHapticFieldPacket.h"
#include "vtkHapticVtkVersions.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkTouchAlongPath.h"
#include "vtkUniformGrid.h"
#include "vtkUnstructuredGrid.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace
{
vtkSmartPointer<vtkTouchAlongPath> touched(vtkDataObject* data, const std::vector<Vec3>& hands_W, double value)
{
  auto touch = vtkSmartPointer<vtkTouchAlongPath>::New();
  touch->SetInputDataObject(0, data);
  touch->SetPathData(makePath(hands_W));
  touch->SetSetting("Stiffness", 400.0);
  touch->SetSetting("FieldArray", "u");
  touch->SetSetting("FieldIsosurface", 1);
  touch->SetSetting("FieldIsovalue", value);
  EXPECT_THAT(errorsOf(touch), IsEmpty());
  return touch;
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
      const double cell = cellAt(channelLayers(), surface);
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

TEST(OwnCells, OfAnOGridAreFeltWithinAQuarterOfTheLocalCellOverItsSeamAndNeverCrossed)
{
  const auto data = oGrid();
  // HapticSessionGraded feels .9 in a session.
  for (const double u : test::casesOf<double>({ 0.5, 0.9, 0.99 }, { 0.5, 0.99 }))
  {
    std::vector<Vec3> hands_W;
    const auto at = [](double turn) { return Vec3(std::cos(turn), 0.8 * std::sin(turn), 0.6 * std::sin(turn)); };
    for (double r = 1.15; r > 0.95; r -= handStep_u)
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
    std::vector<Vec3> felt_W;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      felt_W.emplace_back(output->GetPoint(i));
    }
    ASSERT_EQ(felt_W.size(), hands_W.size());
    const std::vector<double> surface = radiiOf(u, felt_W, data), values = probed(output, data);
    for (std::size_t i = 0; i < hands_W.size(); ++i)
    {
      const double cell = cellAt(oGridLayers(), surface[i] - 1.0);
      ASSERT_GE(values[i], u - 1e-4) << "row " << i; // as near as VTK's search of a bent cell
      if (i >= inside)
      {
        ASSERT_NEAR(felt_W[i].norm(), surface[i], 0.25 * cell) << u << ", row " << i;
        ASSERT_LT((felt_W[i].normalized() - hands_W[i].normalized()).norm(), 0.1) << "it comes along, row " << i;
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
    const MadeFieldBlock made = field.Source->brickAround({ hand_W, 1.0, 1 });
    ASSERT_TRUE(made.brick && made.brick->cells());
    EXPECT_LE(made.brick->bytes(), FieldBlock::mostBytes);
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

/// The text about a surface of data with an array "u".
std::string saidOf(vtkDataObject* data, double value, const Vec3& hand_W)
{
  vtkHapticFieldArrays arrays;
  arrays.Scalar = "u";
  const vtkHapticFieldResult field = vtkHapticToField(data, arrays);
  EXPECT_TRUE(field.Source) << field.Problem;
  const MadeFieldBlock made = field.Source->brickAround({ hand_W, 2.0, 1 });
  EXPECT_TRUE(made.brick);
  FieldPlan plan;
  EXPECT_EQ(latticeText(plan, made, hand_W), "") << "no surface is felt";
  plan.isosurface = true;
  plan.isovalue = value;
  return latticeText(plan, made, hand_W);
}

/// x + 0.3 y + 0.1 z at the points of a grid.
template<class Grid>
void addSlope(Grid* grid)
{
  vtkNew<vtkFloatArray> values;
  values->SetName("u");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const Vec3 p(grid->GetPoint(i));
    values->InsertNextValue(static_cast<float>(p.dot(Vec3(1.0, 0.3, 0.1))));
  }
  grid->GetPointData()->AddArray(values);
}

TEST(OwnCells, ThatAreQuadraticOrPolyhedraAreFeltOnALatticeWhichIsSaidWithItsSpacing)
{
  const auto box = gridOf(
    { 5, 5, 5 }, [](int i, int j, int k) { return Vec3(i, j, k); }, [](const Vec3& p) { return p.x(); });
  for (const int type : { VTK_QUADRATIC_TETRA, VTK_POLYHEDRON })
  {
    vtkNew<vtkUnstructuredGrid> grid;
    vtkNew<vtkPoints> points;
    points->DeepCopy(box->GetPoints());
    grid->SetPoints(points);
    grid->Allocate(100);
    for (vtkIdType i = 0; i < box->GetNumberOfCells(); ++i)
    {
      vtkNew<vtkIdList> c;
      box->GetCellPoints(i, c);
      grid->InsertNextCell(VTK_HEXAHEDRON, c);
    }
    if (type == VTK_POLYHEDRON)
    {
      vtkNew<vtkIdList> c;
      box->GetCellPoints(0, c);
      const vtkIdType faces[] = { 4, c->GetId(0), c->GetId(3), c->GetId(2), c->GetId(1), 4, c->GetId(4), c->GetId(5),
        c->GetId(6), c->GetId(7), 4, c->GetId(0), c->GetId(1), c->GetId(5), c->GetId(4), 4, c->GetId(2), c->GetId(3),
        c->GetId(7), c->GetId(6), 4, c->GetId(1), c->GetId(2), c->GetId(6), c->GetId(5), 4, c->GetId(0), c->GetId(4),
        c->GetId(7), c->GetId(3) };
      grid->InsertNextCell(VTK_POLYHEDRON, 6, faces);
    }
    else
    {
      const std::array<Vec3, 4> corner{ Vec3(5, 0, 0), Vec3(6, 0, 0), Vec3(5, 1, 0), Vec3(5, 0, 1) };
      std::array<vtkIdType, 10> ids{};
      const std::array<std::array<int, 2>, 10> ends{ { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 3, 3 }, { 0, 1 }, { 1, 2 },
        { 0, 2 }, { 0, 3 }, { 1, 3 }, { 2, 3 } } };
      std::transform(ends.begin(), ends.end(), ids.begin(),
        [&](const std::array<int, 2>& end)
        {
          const Vec3 p = 0.5 * (corner[static_cast<std::size_t>(end[0])] + corner[static_cast<std::size_t>(end[1])]);
          return points->InsertNextPoint(p.data());
        });
      grid->InsertNextCell(VTK_QUADRATIC_TETRA, 10, ids.data());
    }
    addSlope(grid.Get());
    const std::string said = saidOf(grid, 2.0, Vec3(2, 2, 2));
    EXPECT_THAT(said, HasSubstr("polyhedra or quadratic"));
    EXPECT_TRUE(test::says(said, { "isosurfaces", "samples 0." })) << "some half of a cell apart";
  }
}

TEST(OwnCells, OfSeveralLevelsAndOfMoreThanFourMillionAreFeltOnALatticeWhichIsSaid)
{
  vtkNew<vtkOverlappingAMR> levels;
  vtkHapticSizeLevels(*levels, { 1 });
  const double origin[3] = { 0.0, 0.0, 0.0 }, spacing[3] = { 1.0, 1.0, 1.0 };
  levels->SetOrigin(origin);
  levels->SetSpacing(0, spacing);
  vtkNew<vtkUniformGrid> grid;
  const int dimensions[3] = { 6, 6, 6 };
  grid->SetDimensions(dimensions);
  addSlope(grid.Get());
  levels->SetAMRBox(0, 0, vtkAMRBox(origin, dimensions, spacing, origin, vtkHapticThreeAxes));
  levels->SetDataSet(0, 0, grid);
  EXPECT_THAT(saidOf(levels, 2.0, Vec3(2, 2, 2)), HasSubstr("grids of several levels"));
  vtkNew<vtkImageData> many;
  many->SetDimensions(161, 161, 161);
  addSlope(many.Get());
  vtkNew<vtkMultiBlockDataSet> whole;
  whole->SetBlock(0, many);
  const std::string said = saidOf(whole, 80.0, Vec3(80, 80, 80));
  EXPECT_THAT(said, HasSubstr("more than 4 million"));
  EXPECT_THAT(said, HasSubstr("rendered from samples 0.5 u apart"));
}

TEST(OwnCells, ThatAreNotFeltAreAWarningOfTheFilterAndThoseThatAreFeltAreNone)
{
  const auto warningsOf = [](vtkDataObject* data, int smoothing)
  {
    const auto touch = touched(data, { Vec3(1.1, 0.2, 1.4), Vec3(1.1, 0.1, 1.4) }, 0.9);
    touch->SetSetting("FieldSmoothing", smoothing);
    std::string warnings;
    vtkNew<vtkCallbackCommand> listener;
    listener->SetClientData(&warnings);
    listener->SetCallback([](vtkObject*, unsigned long, void* all, void* text)
      { *static_cast<std::string*>(all) += static_cast<const char*>(text); });
    touch->AddObserver(vtkCommand::WarningEvent, listener);
    touch->Update();
    return warnings;
  };
  const auto data = channel(25, 13);
  EXPECT_THAT(warningsOf(data, 0), IsEmpty());
  EXPECT_TRUE(test::says(warningsOf(data, 1), { "not from its own cells", "smoothed" }));
}
} // namespace
