// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "testing/support/Random.h"
#include "testing/support/Says.h"
#include "testing/support/TemporaryFolder.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkHapticMarkRecords.h"
#include "vtkHapticMarksSource.h"
#include "vtkHapticSurfaceDistance.h"
#include "vtkHapticSurfacePath.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLPolyDataReader.h"

namespace palpate::testing::measured
{
namespace
{

vtkSmartPointer<vtkPolyData> cube(double half)
{
  vtkNew<vtkCubeSource> source;
  source->SetXLength(2 * half);
  source->SetYLength(2 * half);
  source->SetZLength(2 * half);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> scatter(std::size_t count, double half)
{
  test::Random random(test::testSeed(61));
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points.push_back(random.inCube(half));
  }
  return makePath(points);
}

double distanceToBox(const Vec3& x, double half)
{
  const Vec3 out = x.cwiseAbs() - Vec3::Constant(half);
  return out.cwiseMax(0.0).norm() + std::min(0.0, out.maxCoeff()); // Quilez: below 0 inside
}

void compare(vtkHapticSurfaceDistance* filter, vtkPolyData* surface, vtkPolyData* reference)
{
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(reference);
  filter->SetInputData(surface);
  filter->SetReferenceConnection(producer->GetOutputPort());
  filter->Update();
}

TEST(SurfaceDistance, FromABoxIsItsFormulaWhateverWayItsFacesAreTurned)
{
  const auto box = cube(1.0);
  vtkNew<vtkReverseSense> turned;
  turned->SetInputData(box);
  turned->Update();
  const auto points = scatter(test::testCount(2000), 2.0);
  for (vtkPolyData* reference : { box.Get(), turned->GetOutput() })
  {
    vtkNew<vtkHapticSurfaceDistance> filter;
    compare(filter, points, reference);
    vtkPointData* arrays = filter->GetOutput()->GetPointData();
    ASSERT_TRUE(arrays->GetArray("Distance") && arrays->GetArray("SignedDistance"));
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      const double expected = distanceToBox(Vec3(points->GetPoint(i)), 1.0);
      EXPECT_NEAR(arrays->GetArray("SignedDistance")->GetComponent(i, 0), expected, 1e-12) << i;
      EXPECT_NEAR(arrays->GetArray("Distance")->GetComponent(i, 0), std::abs(expected), 1e-12) << i;
    }
  }
}

TEST(SurfaceDistance, FromASphereOfTrianglesIsWhatVtkHas)
{
  const auto reference = makeSphere(1.0, 24);
  const auto points = scatter(test::testCount(2000), 2.0);
  vtkNew<vtkHapticSurfaceDistance> filter;
  compare(filter, points, reference);
  vtkNew<vtkImplicitPolyDataDistance> theirs;
  theirs->SetInput(reference);
  vtkDataArray* ours = filter->GetOutput()->GetPointData()->GetArray("SignedDistance");
  ASSERT_TRUE(ours);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    EXPECT_NEAR(ours->GetComponent(i, 0), theirs->EvaluateFunction(p), 1e-6) << i; // a sphere of single precision
  }
}

TEST(SurfaceDistance, FromAnOpenSurfaceHasNoSign)
{
  vtkNew<vtkHapticSurfaceDistance> filter;
  compare(filter, scatter(10, 2.0), makePlane(5.0));
  ASSERT_TRUE(filter->GetOutput()->GetPointData()->GetArray("Distance"));
  EXPECT_FALSE(filter->GetOutput()->GetPointData()->GetArray("SignedDistance"));
  for (vtkIdType i = 0; i < 10; ++i)
  {
    double p[3];
    filter->GetOutput()->GetPoint(i, p);
    EXPECT_NEAR(filter->GetOutput()->GetPointData()->GetArray("Distance")->GetComponent(i, 0), std::abs(p[2]), 1e-12);
  }
}

/// z = rise x + base over the unit square. Columns of cells become wider with x, so that a mean over points is another.
vtkSmartPointer<vtkPolyData> slope(double rise, double base, int columns, double power, double size = 1.0)
{
  vtkNew<vtkPlaneSource> source;
  source->SetResolution(columns, 3);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkPolyData* const plane = source->GetOutput();
  for (vtkIdType i = 0; i < plane->GetNumberOfPoints(); ++i)
  {
    const Vec3 p(plane->GetPoint(i));
    const double x = std::pow(p.x() + 0.5, power);
    plane->GetPoints()->SetPoint(i, size * x, size * p.y(), size * (rise * x + base));
  }
  return plane;
}

/// Mean, RMS and maximum of the distance to the plane z = 0.
std::array<double, 3> distanceToGround(vtkPolyData* surface, double size = 1.0)
{
  vtkNew<vtkHapticSurfaceDistance> filter;
  compare(filter, surface, makePlane(100.0 * size));
  std::array<double, 3> found{};
  const char* const names[] = { "MeanDistance", "RMSDistance", "MaximumDistance" };
  for (int i = 0; i < 3; ++i)
  {
    vtkDataArray* const array = filter->GetOutput()->GetFieldData()->GetArray(names[i]);
    found[i] = array ? array->GetComponent(0, 0) : std::numeric_limits<double>::infinity();
  }
  EXPECT_EQ(surface->GetFieldData()->GetNumberOfArrays(), 0) << "the input has no part in it";
  return found;
}

TEST(SurfaceDistance, BetweenParallelPlanesIsEverywhereTheSameAtAnyScale)
{
  for (const double size : { 1e-9, 1.0, 1e9 })
  {
    for (const double value : distanceToGround(slope(0.0, 0.25, 5, 2.0, size), size))
    {
      EXPECT_NEAR(value, 0.25 * size, 1e-12 * size);
    }
  }
}

TEST(SurfaceDistance, OfASlopeHasMeanAndRmsOverItsAreaWhateverItsCellsAre)
{
  const double rise = 0.7, base = 0.2;
  for (const double power : { 1.0, 3.0 })
  {
    const auto [mean, rms, maximum] = distanceToGround(slope(rise, base, 6, power));
    EXPECT_NEAR(mean, rise / 2 + base, 1e-12); // the integral of z over x from 0 to 1
    EXPECT_NEAR(rms, std::sqrt(rise * rise / 3 + rise * base + base * base), 1e-12);
    EXPECT_NEAR(maximum, rise + base, 1e-12);
  }
}

TEST(SurfaceDistance, OfASlopeThroughTheReferenceGoesToTheTruthWithTheSquareOfTheCells)
{
  for (const int columns : { 4, 8, 16, 32, 64 })
  {
    // |x - 1/3|: between 0 and 1 its mean is 5/18 and its mean square 1/9. In the one cell that has the crossing, f h
    // and (1 - f) h from its ends, f = 1/3 or 2/3, the line between the ends encloses f (1 - f) h^2 more, and its
    // square 2/3 f (1 - f) h^3 more.
    const double h = 1.0 / columns, share = 2.0 / 9.0;
    const auto [mean, rms, maximum] = distanceToGround(slope(1.0, -1.0 / 3.0, columns, 1.0));
    EXPECT_NEAR(mean, 5.0 / 18.0 + share * h * h, 1e-12);
    EXPECT_NEAR(rms, std::sqrt(1.0 / 9.0 + 2.0 / 3.0 * share * h * h * h), 1e-12);
    EXPECT_NEAR(maximum, 2.0 / 3.0, 1e-12);
  }
}

TEST(SurfaceDistance, CountsNoLinesNoGhostsAndNoPointThatIsNotFinite)
{
  const auto surface = slope(0.7, 0.2, 6, 1.0);
  vtkNew<vtkUnsignedCharArray> ghosts; // 3 rows of 6 cells, the last column of which is another rank's
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->InsertNextValue(0); // of the line, which comes before the polygons
  for (int cell = 0; cell < 18; ++cell)
  {
    ghosts->InsertNextValue(cell % 6 == 5 ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  surface->GetPoints()->InsertNextPoint(0.0, 0.0, 50.0);
  surface->GetPoints()->SetPoint(0, 0.0, std::nan(""), 0.2);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 1, 28 });
  surface->SetLines(lines);
  surface->GetCellData()->AddArray(ghosts);
  const auto [mean, rms, maximum] = distanceToGround(surface);
  // Without the triangle at the point that is not finite the height is that of x from 0 to 5/6, less half a cell of
  // 1/18 x 1/6 whose centre is at 1/18; or a whole cell where the diagonal goes to that point.
  const double height_half = 0.7 / 18.0 + 0.2, height_cell = 0.7 / 12.0 + 0.2, cell = 1.0 / 18.0;
  const double whole = 15.0 * cell * (0.7 * 5.0 / 12.0 + 0.2);
  const double half = (whole - 0.5 * cell * height_half) / (14.5 * cell);
  const double both = (whole - cell * height_cell) / (14.0 * cell);
  EXPECT_LT(std::min(std::abs(mean - half), std::abs(mean - both)), 1e-12) << mean;
  EXPECT_GT(rms, mean);
  EXPECT_NEAR(maximum, 0.7 * 5.0 / 6.0 + 0.2, 1e-12);
}

TEST(SurfaceDistance, OfPointsWithoutAreaHasTheMeanOverThePoints)
{
  const auto [mean, rms, maximum] = distanceToGround(makePath({ { 0, 0, 1 }, { 1, 0, -2 }, { 5, 0, 6 } }));
  EXPECT_NEAR(mean, 3.0, 1e-12);
  EXPECT_NEAR(rms, std::sqrt(41.0 / 3.0), 1e-12);
  EXPECT_NEAR(maximum, 6.0, 1e-12);
  for (const double value : distanceToGround(vtkNew<vtkPolyData>()))
  {
    EXPECT_TRUE(std::isnan(value));
  }
}

TEST(SurfaceDistance, IsTheArrayThatColoursAndIsSaidInASentence)
{
  vtkNew<vtkHapticSurfaceDistance> filter;
  EXPECT_STREQ(filter->GetText(), "");
  compare(filter, slope(0.0, 0.25, 5, 1.0), cube(2.0));
  ASSERT_TRUE(filter->GetOutput()->GetPointData()->GetScalars());
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "Distance");
  EXPECT_TRUE(test::says(filter->GetText(), { "mean 1.", "root mean square 1.", "maximum 1.75 u" }));
}

TEST(Measuring, OfAPartOfTheDataIsRefusedInWords)
{
  const auto surface = cube(1.0);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(surface);
  vtkNew<vtkHapticSurfaceDistance> distance;
  distance->SetInputData(surface);
  distance->SetReferenceConnection(producer->GetOutputPort());
  vtkNew<vtkHapticSurfacePath> path;
  path->SetInputData(surface);
  path->SetMarksConnection(producer->GetOutputPort());
  for (vtkPolyDataAlgorithm* filter : std::initializer_list<vtkPolyDataAlgorithm*>{ distance, path })
  {
    const auto errors = errorsOf(static_cast<vtkObject*>(filter), [&] { filter->UpdatePiece(1, 2, 0); });
    ASSERT_FALSE(errors.empty());
    EXPECT_NE(errors.front().find("requested in 2 pieces"), std::string::npos) << errors.front();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

vtkSmartPointer<vtkTable> marksAt(const std::vector<Vec3>& places)
{
  vtkHapticMarkRecords marks;
  for (const Vec3& p : places)
  {
    marks.Records.push_back({ "box", { { "X", p.x() }, { "Y", p.y() }, { "Z", p.z() } } });
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  marks.FillTable(table);
  return table;
}

TEST(SurfacePathFilter, GoesFromMarkToMarkOfATableOrOfPointsAndSaysHowLong)
{
  const std::vector<Vec3> places = { { -1, -1, -1 }, { 1, 1, 1 }, { 0, 0, 1 } };
  const auto points = makePath(places);
  const auto table = marksAt(places);
  for (vtkDataObject* marks : std::initializer_list<vtkDataObject*>{ points, table })
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(marks);
    vtkNew<vtkHapticSurfacePath> filter;
    filter->SetInputData(cube(1.0));
    filter->SetMarksConnection(producer->GetOutputPort());
    filter->Update();
    vtkPolyData* ways = filter->GetOutput();
    ASSERT_EQ(ways->GetNumberOfLines(), 2);
    vtkDataArray* length = ways->GetCellData()->GetArray("Length");
    EXPECT_NEAR(length->GetComponent(0, 0), 2.0 * std::sqrt(5.0), 1e-9); // a side of 2, unfolded
    EXPECT_NEAR(length->GetComponent(1, 0), std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(ways->GetCellData()->GetArray("Straight")->GetComponent(0, 0), 2.0 * std::sqrt(3.0), 1e-9);
    const vtkIdType last = ways->GetCell(0)->GetPointId(static_cast<int>(ways->GetCell(0)->GetNumberOfPoints()) - 1);
    EXPECT_NEAR(ways->GetPointData()->GetArray("Way")->GetComponent(last, 0), length->GetComponent(0, 0), 1e-12);
    filter->ClosedOn();
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), 3);
  }
}

TEST(SurfacePathFilter, RefusesFewerThanTwoMarksAndATableWithoutPlaces)
{
  vtkNew<vtkTable> empty;
  const auto one = makePath({ { 0, 0, 0 } });
  for (vtkDataObject* marks : std::initializer_list<vtkDataObject*>{ one, empty })
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(marks);
    vtkNew<vtkHapticSurfacePath> filter;
    filter->SetInputData(cube(1.0));
    filter->SetMarksConnection(producer->GetOutputPort());
    const auto errors = errorsOf(filter);
    ASSERT_FALSE(errors.empty());
    EXPECT_NE(errors.front().find("at least two marks"), std::string::npos) << errors.front();
  }
}

vtkHapticMarkRecords twoMarks()
{
  vtkHapticMarkRecords marks;
  marks.Records.push_back({ "a, \"b\"\nc", { { "X", 0.1 }, { "Y", -2e-300 }, { "Z", 1.0 / 3.0 }, { "p,q", 7.0 } } });
  marks.Records.push_back({ "", { { "X", 1 }, { "Y", 2 }, { "Z", 3 }, { "density", NAN } } });
  return marks;
}

TEST(Marks, ComeBackFromTheirTextToTheBit)
{
  const vtkHapticMarkRecords marks = twoMarks();
  vtkHapticMarkRecords back;
  ASSERT_EQ(back.FromText(marks.ToText()), "");
  ASSERT_EQ(back.Records.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_EQ(back.Records[i].Source, marks.Records[i].Source);
    for (const auto& [name, value] : marks.Records[i].Numbers)
    {
      const double read = back.Records[i].Number(name);
      EXPECT_TRUE(read == value || (std::isnan(read) && std::isnan(value))) << name;
    }
  }
  EXPECT_TRUE(std::isnan(back.Records[1].Number("p,q"))) << "the other mark's";
  EXPECT_EQ(back.ToText(), marks.ToText());
}

TEST(Marks, AreAPointEachWithAllThatWasFound)
{
  vtkNew<vtkHapticMarksSource> source;
  source->SetText(twoMarks().ToText().c_str());
  source->Update();
  vtkPolyData* points = source->GetOutput();
  ASSERT_EQ(points->GetNumberOfVerts(), 2);
  EXPECT_EQ(Vec3(points->GetPoint(0)), Vec3(0.1, -2e-300, 1.0 / 3.0));
  EXPECT_EQ(points->GetPointData()->GetArray("p,q")->GetComponent(0, 0), 7.0);
  auto* names = vtkStringArray::SafeDownCast(points->GetPointData()->GetAbstractArray("Source"));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->GetValue(0), "a, \"b\"\nc");
  EXPECT_EQ(vtkTable::SafeDownCast(source->GetOutputDataObject(1))->GetNumberOfRows(), 2);
}

TEST(Marks, ABrokenTextIsRefusedWithItsMark)
{
  vtkHapticMarkRecords marks;
  EXPECT_TRUE(test::says(marks.FromText("Source,X,Y\n"), { "1", "columns", "Source" }));
  EXPECT_TRUE(test::says(marks.FromText("Source,X,Y,Z\na,1,2,3\nb,1,2\n"), { "2", "3 fields", "4 columns" }));
  EXPECT_TRUE(test::says(marks.FromText("Source,X,Y,Z\na,1,2,three\n"), { "1", "'three'", "number" }));
  EXPECT_TRUE(marks.Records.empty());
  for (std::size_t length = 0; length < twoMarks().ToText().size(); ++length)
  {
    static_cast<void>(marks.FromText(twoMarks().ToText().substr(0, length))); // whatever is said, it ends
  }
}

TEST(Marks, AreWrittenAsCsvAndVtpOrNotAtAll)
{
  const test::TemporaryFolder folder;
  EXPECT_EQ(twoMarks().Write(folder.file("marks.vtp")), "");
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.file("marks.vtp").c_str());
  reader->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), 2);
  EXPECT_EQ(reader->GetOutput()->GetPoint(1)[2], 3.0);
  EXPECT_EQ(twoMarks().Write(folder.file("marks.csv")), "");
  EXPECT_NE(twoMarks().Write(folder.file("marks.txt")).find("csv or vtp"), std::string::npos);
  EXPECT_NE(twoMarks().Write(folder.file("no/such/marks.csv")).find("could not be written"), std::string::npos);
  EXPECT_NE(vtkHapticMarkRecords().Write(folder.file("none.csv")).find("no marks"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.file("none.csv")));
}

} // namespace
} // namespace palpate::testing::measured
