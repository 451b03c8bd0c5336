// SPDX-License-Identifier: GPL-3.0-or-later
// Copies of glyphs, against the picture that VTK draws of them.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/support/Random.h"
#include "vtkActor.h"
#include "vtkBitArray.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkHapticConversion.h"
#include "vtkHapticGlyphs.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

namespace palpate::testing::glyphs
{
namespace
{

using ::testing::HasSubstr;

constexpr int points = 40;
constexpr int pixels = 200; // of a picture, each way
constexpr double size = 10.0;

template<typename Array>
void addArray(vtkPolyData* data, const char* name, int components, const std::function<double()>& value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints() * components; ++i)
  {
    array->SetComponent(i / components, static_cast<int>(i % components), value());
  }
  data->GetPointData()->AddArray(array);
}

vtkSmartPointer<vtkPolyData> someCloud(test::Random& random)
{
  vtkNew<vtkPoints> places;
  for (int i = 0; i < points; ++i)
  {
    places->InsertNextPoint(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(places);
  const auto any = [&] { return random.uniform(-1.5, 1.5); };
  addArray<vtkDoubleArray>(cloud, "one", 1, any);
  addArray<vtkDoubleArray>(cloud, "three", 3, any);
  addArray<vtkDoubleArray>(cloud, "degrees", 3, [&] { return random.uniform(-180.0, 180.0); });
  addArray<vtkDoubleArray>(cloud, "four", 4, any);
  addArray<vtkBitArray>(cloud, "mask", 1, [&] { return random.uniform(0.0, 1.0) < 0.7 ? 1.0 : 0.0; });
  vtkDataArray* const four = cloud->GetPointData()->GetArray("four");
  for (vtkIdType i = 0; i < points; ++i)
  {
    double q[4];
    four->GetTuple(i, q);
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    four->SetTuple4(i, q[0] / length, q[1] / length, q[2] / length, q[3] / length);
  }
  return cloud;
}

bool flip(test::Random& random)
{
  return random.uniform(0.0, 1.0) < 0.5;
}

/// A cone, and a box with a smaller one above it.
vtkSmartPointer<vtkMultiBlockDataSet> table(vtkPolyData* cone, vtkPolyData* box)
{
  vtkNew<vtkCubeSource> small;
  small->SetCenter(0.3, 0.0, 1.8);
  small->SetXLength(0.5);
  small->Update();
  vtkNew<vtkMultiBlockDataSet> two;
  two->SetBlock(0, box);
  two->SetBlock(1, small->GetOutput());
  auto all = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  all->SetBlock(0, cone);
  all->SetBlock(1, two);
  return all;
}

/// A cone and a box that no turn takes into themselves, in any way the mapper can draw them; as a table of composite
/// glyphs if `asTable`.
vtkSmartPointer<vtkGlyph3DMapper> someMapper(test::Random& random, bool asTable = false)
{
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(5);
  cone->SetHeight(2.0);
  cone->SetCenter(0.5, 0.25, 0.0);
  vtkNew<vtkCubeSource> box;
  box->SetXLength(1.5);
  box->SetYLength(0.5);
  box->SetCenter(0.3, 0.0, 0.6);
  auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
  mapper->SetInputData(someCloud(random));
  if (asTable)
  {
    cone->Update();
    box->Update();
    mapper->SetSourceTableTree(table(cone->GetOutput(), box->GetOutput()));
    mapper->UseSourceTableTreeOn();
  }
  else
  {
    mapper->SetSourceConnection(0, cone->GetOutputPort());
    mapper->SetSourceConnection(1, box->GetOutputPort());
  }
  mapper->SetRange(0.25, 1.25);
  mapper->SetScaling(flip(random));
  mapper->SetScaleFactor(random.uniform(0.5, 2.0));
  mapper->SetScaleMode(static_cast<int>(random.uniform(0.0, 3.0)));
  mapper->SetScaleArray(
    mapper->GetScaleMode() == vtkGlyph3DMapper::SCALE_BY_COMPONENTS || flip(random) ? "three" : "one");
  mapper->SetClamping(flip(random));
  mapper->SetOrient(flip(random));
  mapper->SetOrientationMode(static_cast<int>(random.uniform(0.0, 3.0)));
  const char* const orientations[] = { "three", "degrees", "four" };
  mapper->SetOrientationArray(orientations[mapper->GetOrientationMode()]);
  mapper->SetSourceIndexing(flip(random));
  mapper->SetSourceIndexArray("one");
  mapper->SetMasking(flip(random));
  mapper->SetMaskArray("mask");
  mapper->ScalarVisibilityOff();
  mapper->Update();
  return mapper;
}

/// How far away each pixel of a picture is, from 0 to 1 (nothing there).
std::vector<float> depthsOf(vtkMapper* mapper)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(pixels, pixels);
  window->AddRenderer(renderer);
  const double bounds[] = { -size, size, -size, size, -size, size };
  renderer->ResetCamera(bounds);
  renderer->GetActiveCamera();
  renderer->ResetCameraClippingRange(-3 * size, 3 * size, -3 * size, 3 * size, -3 * size, 3 * size);
  window->Render();
  vtkNew<vtkFloatArray> depths;
  window->GetZbufferData(0, 0, pixels - 1, pixels - 1, depths);
  return { depths->GetPointer(0), depths->GetPointer(0) + depths->GetNumberOfValues() };
}

double volumeOf(const TriangleMesh& mesh)
{
  double six = 0.0;
  for (const auto& corners : mesh.triangles)
  {
    const Vec3 &a = mesh.vertices_W[corners[0]], &b = mesh.vertices_W[corners[1]], &c = mesh.vertices_W[corners[2]];
    six += a.dot(b.cross(c));
  }
  return six / 6.0;
}
} // namespace

TEST(HapticGlyphs, LieWhereVTKDrawsThemWhateverTheMapperIsToldToDo)
{
  test::Random random(test::testSeed(151));
  std::size_t all = 0;
  for (std::size_t i = 0; i < test::testCount(30); ++i)
  {
    const auto mapper = someMapper(random, i % 3 == 2);
    const vtkHapticShape shape = vtkHapticGlyphsOf(mapper);
    ASSERT_EQ(shape.Problem, "") << i;
    vtkNew<vtkCompositePolyDataMapper> copies;
    copies->SetInputDataObject(shape.Data);
    copies->ScalarVisibilityOff();
    const std::vector<float> drawn = depthsOf(mapper), felt = depthsOf(copies);
    ASSERT_EQ(drawn.size(), felt.size());
    std::size_t covered = 0, different = 0;
    for (std::size_t k = 0; k < drawn.size(); ++k)
    {
      constexpr float near = 1e-3F; // of the depth of the picture; the mapper's matrices are in single precision
      covered += drawn[k] < 1.0F ? 1 : 0;
      different += std::abs(drawn[k] - felt[k]) > near ? 1 : 0;
    }
    all += covered;
    EXPECT_LE(different, 2 + covered / 100) << i << ": at borders a pixel may fall either way";
  }
  EXPECT_GT(all, 100 * test::testCount(30)) << "glyphs were in the pictures";
}

TEST(HapticGlyphs, KeepTheirOutsideOutsideWhereAScaleMirrorsThem)
{
  vtkNew<vtkCubeSource> box;
  box->SetXLength(3.0);
  vtkNew<vtkPoints> place;
  place->InsertNextPoint(7.0, 8.0, 9.0);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(place);
  addArray<vtkDoubleArray>(cloud, "scale", 1, [] { return 2.0; });
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(cloud);
  mapper->SetSourceConnection(box->GetOutputPort());
  mapper->SetScaleFactor(-1.0);
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->SetScaleArray("scale");
  mapper->Update();
  const vtkHapticShape shape = vtkHapticGlyphsOf(mapper);
  ASSERT_EQ(shape.Problem, "");
  const auto mesh = vtkHapticToMesh(shape.Data).Mesh;
  ASSERT_TRUE(mesh);
  EXPECT_NEAR(volumeOf(*mesh), 3.0 * 2.0 * 2.0 * 2.0, 1e-4);
}

TEST(HapticGlyphs, CarryTheArraysAndTheIdOfTheirPoint)
{
  test::Random random(test::testSeed(152));
  const auto mapper = someMapper(random);
  mapper->SetSourceIndexing(false);
  mapper->SetMasking(false);
  const vtkHapticShape shape = vtkHapticGlyphsOf(mapper);
  auto* const copies = vtkPolyData::SafeDownCast(vtkMultiBlockDataSet::SafeDownCast(shape.Data)->GetBlock(0));
  auto* const cloud = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  const vtkIdType each = mapper->GetSource(0)->GetNumberOfPoints();
  ASSERT_EQ(copies->GetNumberOfPoints(), points * each);
  for (vtkIdType i = 0; i < copies->GetNumberOfPoints(); ++i)
  {
    const vtkIdType point = i / each;
    ASSERT_EQ(copies->GetPointData()->GetArray("vtkOriginalPointIds")->GetComponent(i, 0), point);
    ASSERT_EQ(copies->GetPointData()->GetArray("one")->GetComponent(i, 0),
      cloud->GetPointData()->GetArray("one")->GetComponent(point, 0));
  }
}

TEST(HapticGlyphs, MoreThanCanBeFeltAreRefusedWithTheirNumber)
{
  test::Random random(test::testSeed(153));
  const auto mapper = someMapper(random);
  mapper->SetSourceIndexing(false);
  mapper->SetMasking(false);
  const vtkIdType each = mapper->GetSource(0)->GetNumberOfPolys();
  EXPECT_EQ(vtkHapticGlyphsOf(mapper, points * each).Problem, "");
  const vtkHapticShape refused = vtkHapticGlyphsOf(mapper, points * each - 1);
  EXPECT_FALSE(refused.Data);
  EXPECT_THAT(refused.Problem, HasSubstr(std::to_string(points) + " glyphs have " + std::to_string(points * each)));
  EXPECT_THAT(refused.Problem, HasSubstr("draw fewer glyphs"));
}

TEST(HapticGlyphs, AreNamedAnewOnlyOnceSomethingOfTheirShapeHasChanged)
{
  test::Random random(test::testSeed(154));
  const auto mapper = someMapper(random);
  const std::uint64_t before = vtkHapticGlyphsKey(mapper);
  mapper->ScalarVisibilityOn();
  EXPECT_EQ(vtkHapticGlyphsKey(mapper), before);
  mapper->SetScaleFactor(7.0);
  const std::uint64_t larger = vtkHapticGlyphsKey(mapper);
  EXPECT_NE(larger, before);
  mapper->SetOrientationArray("other");
  EXPECT_NE(vtkHapticGlyphsKey(mapper), larger);
  const std::uint64_t other = vtkHapticGlyphsKey(mapper);
  mapper->GetInputDataObject(0, 0)->Modified();
  EXPECT_NE(vtkHapticGlyphsKey(mapper), other);
}

} // namespace palpate::testing::glyphs
