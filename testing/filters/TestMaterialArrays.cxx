// SPDX-License-Identifier: GPL-3.0-or-later
// Materials of a surface, from arrays of its points and cells.
#include <cmath>
#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "testing/support/Says.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkHapticConversion.h"
#include "vtkHapticMaterialArrays.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTouchAlongPath.h"
#include "vtkUnstructuredGrid.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

namespace
{
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double half = 10.0;        // u, of the plane
constexpr double stiffness = 1000.0; // N/m, of the coupling; a unit is a metre
constexpr double depth = 0.5;        // u

vtkSmartPointer<vtkDoubleArray> makeArray(const char* name, const std::vector<double>& values, int components = 1)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

/// The plane z = 0 with a point array "a" of a function of the place.
vtkSmartPointer<vtkPolyData> makePlaneWith(const std::function<double(const Vec3&)>& value)
{
  auto plane = makePlane(half);
  std::vector<double> values;
  for (vtkIdType i = 0; i < plane->GetNumberOfPoints(); ++i)
  {
    values.push_back(value(Vec3(plane->GetPoint(i))));
  }
  plane->GetPointData()->AddArray(makeArray("a", values));
  return plane;
}

vtkHapticMaterialSettings stiffnessFrom(const char* name)
{
  vtkHapticMaterialSettings settings;
  settings.Stiffness.Array = name;
  return settings;
}

vtkHapticMaterialResult materialOf(vtkDataObject* data, const vtkHapticMaterialSettings& settings)
{
  return vtkHapticToMaterial(data, vtkHapticToMesh(data).PartPoints, settings);
}

/// Down from above at each x, then pressed and at rest there: a row of forces. `top_u`: z of the touched surface.
std::vector<Vec3> pressedAt(vtkTouchAlongPath* touch, const std::vector<double>& xs, double y = 1.0, double top_u = 0.0)
{
  std::vector<Vec3> path_W;
  for (const double x : xs)
  {
    path_W.insert(path_W.end(), { Vec3(x, y, top_u + 1.0), Vec3(x, y, top_u - depth), Vec3(x, y, top_u - depth) });
  }
  touch->SetPathData(makePath(path_W));
  touch->SetSetting("Stiffness", stiffness);
  EXPECT_THAT(errorsOf(touch), IsEmpty());
  std::vector<Vec3> forces_W;
  vtkDataArray* force = touch->GetOutput()->GetPointData()->GetArray("Force");
  for (std::size_t i = 0; force && i < xs.size(); ++i)
  {
    Vec3 force_W;
    force->GetTuple(static_cast<vtkIdType>(3 * i + 2), force_W.data());
    forces_W.push_back(force_W);
  }
  return forces_W;
}

double xOf(const Vec3& p)
{
  return p.x();
}

const std::vector<double> places = { -9.5, -6.0, -2.5, 0.0, 1.0, 4.0, 8.0 };
/// The array runs along x from 200 to 900 N/m over the pressed part.
void expectForcesOfARamp(const std::vector<Vec3>& forces_W)
{
  const double slope = 700.0 / (2.0 * half); // N/m per u
  ASSERT_EQ(forces_W.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double wall = 200.0 + slope * (places[i] + half);
    const Vec3 expected_W(-0.5 * depth * depth * slope, 0.0, wall * depth); // -grad of k(x) d^2 / 2
    EXPECT_LT((forces_W[i] - expected_W).norm(), 1e-12 * stiffness) << places[i];
  }
}
} // namespace

TEST(MaterialArrays, StiffnessFollowsALinearArrayAtEachPlace)
{
  vtkNew<vtkTouchAlongPath> touch;
  touch->SetInputData(makePlaneWith(xOf));
  touch->SetSetting("StiffnessArray", "a");
  touch->SetSetting("StiffnessFeltRange", 200.0, 900.0);
  expectForcesOfARamp(pressedAt(touch, places));
}

TEST(MaterialArrays, ATubeFollowsTheArrayOfItsLineAtEachPlace)
{
  constexpr double tube = 2.0, ball = 0.25; // u
  const auto line = makePath({ Vec3(-half, 0.0, 0.0), Vec3(half, 0.0, 0.0) });
  line->GetPointData()->AddArray(makeArray("a", { -half, half }));
  vtkNew<vtkTouchAlongPath> touch;
  touch->SetInputData(line);
  touch->SetSetting("LineRadius", tube);
  touch->SetSetting("Radius", ball);
  touch->SetSetting("StiffnessArray", "a");
  touch->SetSetting("StiffnessFeltRange", 200.0, 900.0);
  expectForcesOfARamp(pressedAt(touch, places, 0.0, tube + ball));
}

TEST(MaterialArrays, ALineWithoutTheArrayIsAnErrorUnlessASurfaceBesideItHasIt)
{
  const auto line = makePath({ Vec3(-half, 0.0, 5.0), Vec3(half, 0.0, 5.0) });
  vtkNew<vtkTouchAlongPath> touch;
  touch->SetInputData(line);
  touch->SetPathData(makePath({ Vec3(0.0, 0.0, 9.0), Vec3(0.0, 0.0, 8.0) }));
  touch->SetSetting("LineRadius", 0.5);
  touch->SetSetting("StiffnessArray", "a");
  const auto errors = errorsOf(touch);
  ASSERT_FALSE(errors.empty());
  EXPECT_THAT(errors.front(), HasSubstr("no array 'a'"));
  vtkNew<vtkMultiBlockDataSet> both;
  both->SetBlock(0, line);
  both->SetBlock(1, makePlaneWith(xOf));
  touch->SetInputData(both);
  EXPECT_THAT(errorsOf(touch), IsEmpty());
}

TEST(MaterialArrays, ADataRangeIsLevelBeyondItsEndsAndTheFeltRangeMayFall)
{
  vtkNew<vtkTouchAlongPath> touch;
  touch->SetInputData(makePlaneWith([](const Vec3& p) { return 100.0 * p.x(); }));
  touch->SetSetting("StiffnessArray", "a");
  touch->SetSetting("StiffnessDataRange", 2000.0, 3000.0); // beyond all there is
  touch->SetSetting("StiffnessFeltRange", 800.0, 200.0);
  for (const Vec3& force_W : pressedAt(touch, places))
  {
    EXPECT_NEAR(force_W.z(), 800.0 * depth, 1e-12 * stiffness);
  }
  touch->SetSetting("StiffnessDataRange", -3000.0, -2000.0);
  for (const Vec3& force_W : pressedAt(touch, places))
  {
    EXPECT_NEAR(force_W.z(), 200.0 * depth, 1e-12 * stiffness);
  }
  touch->SetSetting("StiffnessDataRange", 1000.0, -1000.0); // either end may be the higher one
  EXPECT_NEAR(pressedAt(touch, { -5.0 }).front().z(), 350.0 * depth, 1e-12 * stiffness);
  touch->SetSetting("StiffnessDataRange", -1000.0, 1000.0);
  const Vec3 middle_W = pressedAt(touch, { 0.0 }).front();
  EXPECT_NEAR(middle_W.z(), 500.0 * depth, 1e-12 * stiffness);
}

TEST(MaterialArrays, NoMoreThanTheCouplingIsFelt)
{
  vtkNew<vtkTouchAlongPath> touch;
  touch->SetInputData(makePlaneWith([](const Vec3&) { return 1.0; }));
  touch->SetSetting("StiffnessArray", "a");
  touch->SetSetting("StiffnessFeltRange", 5.0 * stiffness, 5.0 * stiffness);
  EXPECT_NEAR(pressedAt(touch, { 3.0 }).front().z(), stiffness * depth, 1e-12 * stiffness);
}

TEST(MaterialArrays, FrictionFollowsAnArray)
{
  vtkNew<vtkTouchAlongPath> touch;
  touch->SetInputData(makePlaneWith([](const Vec3& p) { return p.y(); }));
  touch->SetSetting("FrictionArray", "a");
  touch->SetSetting("FrictionFeltRange", 0.0, 0.8);
  for (const double y : { -5.0, 0.0, 7.0 })
  {
    std::vector<Vec3> path_W = { Vec3(-5.0, y, 1.0), Vec3(-5.0, y, -depth) };
    for (double x = -4.9; x < 5.0; x += 0.1)
    {
      path_W.emplace_back(x, y, -depth); // along x the coefficient is the same
    }
    touch->SetPathData(makePath(path_W));
    touch->SetSetting("Stiffness", stiffness);
    ASSERT_THAT(errorsOf(touch), IsEmpty());
    Vec3 last_W;
    vtkDataArray* force = touch->GetOutput()->GetPointData()->GetArray("Force");
    force->GetTuple(force->GetNumberOfTuples() - 1, last_W.data());
    const double mu = 0.8 * (y + half) / (2.0 * half);
    EXPECT_LT((last_W - stiffness * depth * Vec3(-mu, 0.0, 1.0)).norm(), 1e-9) << y;
  }
}

TEST(MaterialArrays, ATextureIsTheForceOfItsPotential)
{
  vtkNew<vtkTouchAlongPath> touch;
  touch->SetInputData(makePlaneWith(xOf));
  touch->SetSetting("TextureArray", "a");
  touch->SetSetting("TextureFeltRange", -0.2, 0.2); // u over 2 half
  const double slope = 0.2 / half;
  const std::vector<Vec3> forces_W = pressedAt(touch, places);
  ASSERT_EQ(forces_W.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double deep = depth + slope * (places[i] - half); // below the highest place, at the rim
    const Vec3 expected_W = stiffness * deep * Vec3(-slope, 0.0, 1.0);
    EXPECT_LT((forces_W[i] - expected_W).norm(), 1e-12 * stiffness) << places[i];
  }
}

TEST(MaterialArrays, NumbersOfAnySizeAreNumbers)
{
  constexpr double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  const auto plane = makePlane(half);
  plane->GetPointData()->AddArray(makeArray("huge", { -huge, huge, 0.0, 0.5 * huge }));
  plane->GetPointData()->AddArray(makeArray("tiny", { 0.0, tiny, 0.0, 2 * tiny }));
  plane->GetPointData()->AddArray(
    makeArray("v", { 0.75 * huge, 0, 0, 0, 0, -0.5 * huge, 0, 0.25 * huge, 0, 0, 0, 0 }, 3));
  plane->GetCellData()->AddArray(makeArray("cells", { huge, 0.5 * huge })); // around points 0 1 2 and 0 2 3
  vtkHapticMaterialSettings settings = stiffnessFrom("");
  settings.Stiffness.FeltRange = { 0.0, 400.0 };
  const std::pair<const char*, std::array<double, 4>> cases[] = {
    { "huge", { 0.0, 400.0, 200.0, 300.0 } },
    { "tiny", { 0.0, 200.0, 0.0, 400.0 } },
    { "v", { 400.0, 800.0 / 3.0, 400.0 / 3.0, 0.0 } },
    { "cells", { 200.0, 400.0, 200.0, 0.0 } },
  };
  for (const auto& [name, felt] : cases)
  {
    settings.Stiffness.Array = name;
    const vtkHapticMaterialResult material = materialOf(plane, settings);
    ASSERT_NE(material.Fields, nullptr) << material.Problem;
    EXPECT_THAT(material.Note, Not(HasSubstr("without a number"))) << name;
    for (std::size_t i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(material.Fields->stiffness_N_per_m[i], felt[i], 1e-9) << name << ' ' << i;
    }
  }
}

TEST(MaterialArrays, CellsOfOneValueAreOneValueAtEveryPoint)
{
  vtkNew<vtkPolyData> fan; // points with one to nine cells around them
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  for (int i = 0; i < 10; ++i)
  {
    points->InsertNextPoint(std::cos(0.3 * i), std::sin(0.3 * i), 0);
  }
  fan->SetPoints(points);
  fan->AllocateEstimate(9, 3);
  for (vtkIdType i = 1; i < 10; ++i)
  {
    const vtkIdType ids[3] = { 0, i, i + 1 };
    fan->InsertNextCell(VTK_TRIANGLE, 3, ids);
  }
  for (const double value : { 0.1, 0.7, 1e-3, -3.3, 1.7e308 })
  {
    fan->GetCellData()->AddArray(makeArray("c", std::vector<double>(9, value)));
    vtkHapticMaterialSettings settings = stiffnessFrom("c");
    settings.Stiffness.FeltRange = { 100.0, 500.0 };
    const vtkHapticMaterialResult material = materialOf(fan, settings);
    ASSERT_NE(material.Fields, nullptr) << material.Problem;
    for (const double felt : material.Fields->stiffness_N_per_m)
    {
      EXPECT_EQ(felt, 300.0) << value; // the middle: there is no range to place it in
    }
  }
}

TEST(MaterialArrays, CellsCountAtAPointAsTheMeanOfThoseAroundIt)
{
  const auto plane = makePlane(half); // cells 0 1 2 and 0 2 3
  plane->GetCellData()->AddArray(makeArray("c", { 1.0, 3.0 }));
  vtkHapticMaterialSettings settings = stiffnessFrom("c");
  settings.Stiffness.DataRange = { 0.0, 4.0 };
  settings.Stiffness.FeltRange = { 0.0, 400.0 };
  const vtkHapticMaterialResult material = materialOf(plane, settings);
  ASSERT_NE(material.Fields, nullptr) << material.Problem;
  EXPECT_THAT(material.Fields->stiffness_N_per_m, ElementsAre(200.0, 100.0, 200.0, 300.0));
}

TEST(MaterialArrays, OfAVectorItsLengthOrOneComponentCounts)
{
  const auto plane = makePlane(half);
  plane->GetPointData()->AddArray(makeArray("v", { 3, 4, 0, 0, 0, -2, 1, 0, 0, 0, 0, 0 }, 3));
  vtkHapticMaterialSettings settings = stiffnessFrom("v");
  settings.Stiffness.DataRange = { -10.0, 10.0 };
  settings.Stiffness.FeltRange = { 0.0, 20.0 };
  EXPECT_THAT(materialOf(plane, settings).Fields->stiffness_N_per_m, ElementsAre(15.0, 12.0, 11.0, 10.0));
  settings.Stiffness.Component = 2;
  EXPECT_THAT(materialOf(plane, settings).Fields->stiffness_N_per_m, ElementsAre(10.0, 8.0, 10.0, 10.0));
}

TEST(MaterialArrays, PointsWithoutANumberAreCountedAndFeelLikeTheSurfaceItself)
{
  vtkNew<vtkTouchAlongPath> touch;
  const auto plane = makePlaneWith([](const Vec3& p) { return p.x() < 0.0 ? notANumber : 1.0; }); // two of four points
  touch->SetInputData(plane);
  touch->SetSetting("StiffnessArray", "a");
  touch->SetSetting("StiffnessDataRange", 0.0, 1.0);
  touch->SetSetting("StiffnessFeltRange", 0.0, 400.0);
  const double slope = (400.0 - stiffness) / (2.0 * half);
  const std::vector<Vec3> forces_W = pressedAt(touch, places);
  ASSERT_EQ(forces_W.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double wall = stiffness + slope * (places[i] + half);
    const Vec3 expected_W(-0.5 * depth * depth * slope, 0.0, wall * depth);
    EXPECT_LT((forces_W[i] - expected_W).norm(), 1e-12 * stiffness) << places[i];
  }
  EXPECT_THAT(materialOf(plane, stiffnessFrom("a")).Note, HasSubstr("2 points without a number"));
}

TEST(MaterialArrays, BlocksWithoutTheArrayFeelLikeTheSurfaceItself)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePlane(half));
  blocks->SetBlock(1, vtkNew<vtkPolyData>());
  blocks->SetBlock(2, makePlaneWith([](const Vec3&) { return 7.0; }));
  vtkHapticMaterialSettings settings = stiffnessFrom("a");
  settings.Stiffness.DataRange = { 0.0, 7.0 };
  settings.Stiffness.FeltRange = { 0.0, 70.0 };
  const vtkHapticMaterialResult material = materialOf(blocks, settings);
  ASSERT_NE(material.Fields, nullptr) << material.Problem;
  ASSERT_THAT(material.Fields->stiffness_N_per_m, SizeIs(8));
  for (std::size_t i = 0; i < 8; ++i)
  {
    const double felt = material.Fields->stiffness_N_per_m[i];
    EXPECT_TRUE(i < 4 ? std::isnan(felt) : felt == 70.0) << i << ": " << felt;
  }
}

TEST(MaterialArrays, AVolumeMeshFeelsTheArraysOfItsSkin)
{
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(makePlane(half)->GetPoints());
  const vtkIdType ids[3] = { 0, 2, 3 };
  grid->InsertNextCell(VTK_TRIANGLE, 3, ids); // point 1 is in no cell
  grid->GetPointData()->AddArray(makeArray("a", { 1.0, 9.0, 2.0, 3.0 }));
  vtkHapticMaterialSettings settings = stiffnessFrom("a");
  settings.Stiffness.DataRange = { 0.0, 10.0 };
  settings.Stiffness.FeltRange = { 0.0, 100.0 };
  const vtkHapticConversionResult converted = vtkHapticToMesh(grid);
  const vtkHapticMaterialResult material = vtkHapticToMaterial(grid, converted.PartPoints, settings);
  ASSERT_NE(material.Fields, nullptr) << material.Problem;
  ASSERT_EQ(material.Fields->stiffness_N_per_m.size(), converted.Mesh->vertices_W.size());
  for (std::size_t i = 0; i < converted.Mesh->vertices_W.size(); ++i)
  {
    const Vec3& p = converted.Mesh->vertices_W[i];
    const double expected = p.x() < 0 ? (p.y() < 0 ? 10.0 : 30.0) : (p.y() < 0 ? 90.0 : 20.0);
    EXPECT_NEAR(material.Fields->stiffness_N_per_m[i], expected, 1e-12) << p.transpose();
  }
}

TEST(MaterialArrays, AnArrayThatCannotBeUsedIsAnErrorOfOneLine)
{
  const auto plane = makePlaneWith(xOf);
  plane->GetPointData()->AddArray(makeArray("short", { 1.0, 2.0, 3.0 }));
  plane->GetPointData()->AddArray(makeArray("empty", { notANumber, notANumber, notANumber, notANumber }));
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfValues(4);
  plane->GetPointData()->AddArray(words);
  const std::pair<const char*, const char*> cases[] = {
    { "missing", "it has no array 'missing'; it has 'a', 'empty', 'short'" },
    { "short", "its array 'short' has 3 values for 4 points" },
    { "words", "its array 'words' holds no numbers" },
    { "empty", "its array 'empty' has no finite value" },
  };
  for (const auto& [name, sentence] : cases)
  {
    const vtkHapticMaterialResult material = materialOf(plane, stiffnessFrom(name));
    EXPECT_EQ(material.Problem, sentence);
    EXPECT_EQ(material.Fields, nullptr);
    EXPECT_THAT(material.Note, HasSubstr("its own stiffness"));
    vtkNew<vtkTouchAlongPath> touch;
    touch->SetInputData(plane);
    touch->SetPathData(makePath({ Vec3(0, 1, 1), Vec3(0, 1, -1) }));
    touch->SetSetting("FrictionArray", name);
    const std::vector<std::string> errors = errorsOf(touch);
    ASSERT_FALSE(errors.empty()) << name;
    EXPECT_THAT(errors.front(), HasSubstr(sentence));
    EXPECT_EQ(touch->GetOutput()->GetNumberOfPoints(), 0);
  }
  vtkHapticMaterialSettings settings = stiffnessFrom("a");
  settings.Stiffness.Component = 1;
  EXPECT_TRUE(test::says(materialOf(plane, settings).Problem, { "'a' has 1 component", "number 1" }));
}

TEST(MaterialArrays, RangesThatCannotBeAreNamed)
{
  const auto refused = [](const std::function<void(vtkHapticMaterialSettings&)>& change, const char* saying)
  {
    vtkHapticMaterialSettings settings;
    change(settings);
    EXPECT_THAT(settings.Check(), HasSubstr(saying));
  };
  EXPECT_EQ(vtkHapticMaterialSettings().Check(), "");
  refused([](auto& m) { m.Stiffness.FeltRange = { -1.0, 100.0 }; }, "stiffness [N/m]");
  refused([](auto& m) { m.Friction.FeltRange = { 0.0, 10.5 }; }, "friction must be two finite numbers from 0 to 10");
  refused([](auto& m) { m.Friction.FeltRange = { notANumber, 1.0 }; }, "friction");
  refused([](auto& m) { m.Texture.FeltRange = { 0.0, std::numeric_limits<double>::infinity() }; }, "texture");
  refused([](auto& m) { m.Texture.DataRange = { notANumber, 1.0 }; }, "data range for the texture");
  refused([](auto& m) { m.Texture.Component = -2; }, "component");
}

TEST(MaterialArrays, OnlyGeometryAndPlaceChangeTheKeyThatATreeIsKeptUnder)
{
  const auto plane = makePlaneWith(xOf);
  const std::uint64_t geometry = vtkHapticContentKey(plane, nullptr), arrays = vtkHapticArraysKey(plane);
  plane->GetPointData()->GetArray("a")->SetComponent(0, 0, 5.0);
  plane->GetPointData()->GetArray("a")->Modified();
  EXPECT_EQ(vtkHapticContentKey(plane, nullptr), geometry);
  EXPECT_NE(vtkHapticArraysKey(plane), arrays);
  plane->GetPoints()->SetPoint(0, -9.0, -9.0, 0.0);
  plane->GetPoints()->Modified();
  EXPECT_NE(vtkHapticContentKey(plane, nullptr), geometry);
}
