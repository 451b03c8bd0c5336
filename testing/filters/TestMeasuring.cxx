// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "testing/support/Random.h"
#include "testing/support/Says.h"
#include "testing/support/TemporaryFolder.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkHapticMarkRecords.h"
#include "vtkHapticMarksSource.h"
#include "vtkHapticSurfaceDistance.h"
#include "vtkHapticSurfacePath.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTrivialProducer.h"
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
