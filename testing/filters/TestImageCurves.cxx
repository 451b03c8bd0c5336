// SPDX-License-Identifier: GPL-3.0-or-later
// Row 49 and the images that are no plain ones.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "FunctionImages.h"
#include "VtkScenes.h"
#include "testing/support/Polylines.h"
#include "testing/support/Random.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDiscreteFlyingEdges2D.h"
#include "vtkImageCurves.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;

namespace
{
using Curve = std::vector<Vec3>;

std::vector<Curve> curvesOf(vtkPolyData* data)
{
  std::vector<Curve> curves;
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  for (data->GetLines()->InitTraversal(); data->GetLines()->GetNextCell(count, points);)
  {
    curves.emplace_back();
    for (vtkIdType i = 0; i < count; ++i)
    {
      Vec3 p_W;
      data->GetPoint(points[i], p_W.data());
      curves.back().push_back(p_W);
    }
  }
  return curves;
}

vtkSmartPointer<vtkImageCurves> contourAt(vtkImageData* image, double value)
{
  const auto filter = filterOf(image);
  filter->UseMiddleOff();
  filter->SetValue(value);
  return filter;
}

std::vector<Curve> run(vtkImageCurves* filter)
{
  EXPECT_THAT(errorsOf(filter), ::testing::IsEmpty());
  return curvesOf(filter->GetOutput());
}

/// r^2 - R^2 round a centre.
std::function<double(const Vec3&)> circle(const Vec3& centre_W, double radius)
{
  return [=](const Vec3& p_W) { return (p_W - centre_W).squaredNorm() - radius * radius; };
}

struct Errors
{
  double Vertex = 0.0;
  double Chord = 0.0;
};

Errors errorsOfCircle(const std::vector<Curve>& curves, const Vec3& centre_W, double radius)
{
  Errors errors;
  for (const Curve& curve : curves)
  {
    for (std::size_t i = 1; i < curve.size(); ++i)
    {
      errors.Vertex = std::max(errors.Vertex, std::abs((curve[i] - centre_W).norm() - radius));
      for (const double share : { 0.25, 0.5, 0.75 })
      {
        const Vec3 p_W = (1 - share) * curve[i - 1] + share * curve[i];
        errors.Chord = std::max(errors.Chord, std::abs((p_W - centre_W).norm() - radius));
      }
    }
  }
  return errors;
}

void expectRefused(vtkImageCurves* filter, const char* reason)
{
  filter->Modified();
  EXPECT_THAT(errorsOf(filter), ::testing::Contains(HasSubstr(reason)));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << reason;
}
} // namespace

// Linear interpolation of r^2 between two pixels h apart is off by at most h^2 / 4 in r^2, so h^2 / (8 R) in r; a chord
// of at most sqrt(2) h adds its sagitta h^2 / (4 R). Both with the sign inwards, so the chord's bound is the larger
// one.
TEST(ImageCurves, AContouredCircleReachesTheBoundsOfItsPixelsAndStaysWithinThem)
{
  for (const double radius : { 10.0, 50.0, 200.0 })
  {
    Errors most;
    for (const double offset : { 0.0, 0.13, 0.29, 0.5 })
    {
      const Vec3 centre_W(radius + 3 + offset, radius + 3 + 0.7 * offset, 0);
      const auto curves = run(contourAt(squareImage(static_cast<int>(2 * radius) + 8, circle(centre_W, radius)), 0.0));
      ASSERT_EQ(curves.size(), 1u);
      EXPECT_EQ(curves[0].front(), curves[0].back());
      const Errors errors = errorsOfCircle(curves, centre_W, radius);
      most = { std::max(most.Vertex, errors.Vertex), std::max(most.Chord, errors.Chord) };
    }
    const double vertexBound = 1 / (8 * radius), chordBound = 1 / (4 * radius);
    const double nextTerm = 1 + 1 / radius; // the bounds are the first term of a series in h / R
    EXPECT_LE(most.Vertex, vertexBound * nextTerm) << radius;
    EXPECT_GE(most.Vertex, 0.95 * vertexBound) << radius;
    EXPECT_LE(most.Chord, chordBound * nextTerm) << radius;
    EXPECT_GE(most.Chord, 0.95 * chordBound) << radius;
  }
}

TEST(ImageCurves, ASimplifiedCircleStaysWithinTheToleranceItReportsAndAsksFor)
{
  const double radius = 100.0;
  const Vec3 centre_W(105.3, 104.8, 0);
  const auto image = squareImage(212, circle(centre_W, radius));
  const auto whole = run(contourAt(image, 0.0));
  std::size_t before = whole[0].size();
  for (const double tolerance : { 0.01, 0.1, 1.0, 5.0 })
  {
    const auto filter = contourAt(image, 0.0);
    filter->SetTolerance(tolerance);
    const auto curves = run(filter);
    ASSERT_EQ(curves.size(), 1u);
    const double error = filter->GetOutput()->GetCellData()->GetArray("Error")->GetTuple1(0);
    EXPECT_LE(error, tolerance);
    EXPECT_LE(test::hausdorffFromBelow(whole[0], curves[0], 4), error + 1e-9);
    EXPECT_LE(errorsOfCircle(curves, centre_W, radius).Chord, tolerance + 1.01 / (4 * radius));
    EXPECT_LT(curves[0].size(), before);
    before = curves[0].size();
  }
}

TEST(ImageCurves, WhatCannotBeFeltIsLeastForceOverStiffnessInUnitsOfTheScene)
{
  const auto filter = contourAt(squareImage(40, circle({ 20, 20, 0 }, 15.0)), 0.0);
  filter->SetSimplifyBy(vtkImageCurves::ByFeel);
  filter->SetScale(1000.0); // a scene in millimetres
  EXPECT_DOUBLE_EQ(filter->GetAllowedError(), 0.14);
  ASSERT_FALSE(run(filter).empty());
  EXPECT_LE(filter->GetOutput()->GetCellData()->GetArray("Error")->GetRange()[1], 0.14);
  EXPECT_LT(filter->GetOutput()->GetNumberOfPoints(), 40);
}

// The field is one of space, so its contour is the same circle wherever the pixels are.
TEST(ImageCurves, ASliceInAnyPlaneTurnedShiftedAndOfOblongPixelsGivesTheCurveWhereItIs)
{
  for (int flat = 0; flat < 3; ++flat)
  {
    std::array<int, 6> extent{ 7, 106, -20, 79, 3, 102 };
    extent[static_cast<std::size_t>(2 * flat + 1)] = extent[static_cast<std::size_t>(2 * flat)];
    Vec3 centre_W, across_W;
    const auto place = [&](vtkImageData* image)
    {
      image->SetSpacing(0.5, 0.8, 0.65);
      image->SetOrigin(10, -20, 30);
      const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 2) / 3).toRotationMatrix();
      image->SetDirectionMatrix(
        turn(0, 0), turn(0, 1), turn(0, 2), turn(1, 0), turn(1, 1), turn(1, 2), turn(2, 0), turn(2, 1), turn(2, 2));
      const double middle[3] = { (extent[0] + extent[1]) / 2.0, (extent[2] + extent[3]) / 2.0,
        (extent[4] + extent[5]) / 2.0 };
      image->TransformContinuousIndexToPhysicalPoint(middle, centre_W.data());
      across_W = turn.col(flat);
    };
    const double radius = 20.0;
    const auto image = imageOf(
      extent, [&](const Vec3& p_W) { return (p_W - centre_W).squaredNorm() - radius * radius; }, place);
    const auto curves = run(contourAt(image, 0.0));
    ASSERT_EQ(curves.size(), 1u) << flat;
    // The longest chord is the diagonal of a pixel.
    EXPECT_LE(errorsOfCircle(curves, centre_W, radius).Chord, 1.01 * (0.8 * 0.8 + 0.65 * 0.65) / (8 * radius)) << flat;
    for (const Vec3& p_W : curves[0])
    {
      ASSERT_NEAR(across_W.dot(p_W - centre_W), 0.0, 1e-9) << flat;
    }
  }
}

TEST(ImageCurves, ColoursAndSixteenBitsAreHeldLikeTheirGreyFractions)
{
  const Vec3 centre_W(30.2, 29.7, 0);
  const auto disc = [&](const Vec3& p_W) { return (p_W - centre_W).norm() < 20.0 ? 200.0 : 10.0; };
  const auto grey = run(filterOf(squareImage(60, disc)));
  ASSERT_EQ(grey.size(), 1u);
  EXPECT_EQ(run(filterOf(squareImage(60, disc, VTK_UNSIGNED_CHAR, 3))), grey); // r = g = b: their luminance
  EXPECT_EQ(run(filterOf(squareImage(60, disc, VTK_UNSIGNED_CHAR, 4))), grey);
  const auto deep = [&](const Vec3& p_W) { return 300.0 * disc(p_W); };
  EXPECT_EQ(run(filterOf(squareImage(60, deep, VTK_UNSIGNED_SHORT))), grey);
}

TEST(ImageCurves, ACurveThatLeavesTheImageIsOpenAndOneRoundMissingPixelsEndsThere)
{
  const auto curves = run(filterOf(squareImage(20, [](const Vec3& p_W) { return p_W.x(); })));
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].size(), 2u); // straight: nothing between its ends is kept
  const double half = 19.0 / 2;
  EXPECT_EQ(curves[0].front().x(), half);
  const auto broken = run(filterOf(squareImage(
    20, [](const Vec3& p_W) { return p_W.y() == 10 ? std::numeric_limits<double>::quiet_NaN() : p_W.x(); })));
  ASSERT_EQ(broken.size(), 2u);
  for (const Curve& curve : broken)
  {
    for (const Vec3& p_W : curve)
    {
      EXPECT_EQ(p_W.x(), half);
      EXPECT_GE(std::abs(p_W.y() - 10), 1.0);
    }
  }
}

// Two halves of other labels, and a square in the middle of the border: the border of two areas is one curve.
TEST(ImageCurves, BordersOfLabelsLieHalfWayBetweenPixelsAndAreSharedByTheirAreas)
{
  const auto halves = [](const Vec3& p_W) { return p_W.x() < 10 ? 3.0 : 8.0; };
  const auto one = run(filterOf(squareImage(21, halves, VTK_INT), vtkImageCurves::Labels));
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].size(), 2u);
  EXPECT_EQ(one[0].front().x(), 9.5);
  EXPECT_EQ(std::abs(one[0].front().y() - one[0].back().y()), 20.0);
  const auto three = [&](const Vec3& p_W)
  { return std::max(std::abs(p_W.x() - 10), std::abs(p_W.y() - 10)) < 4 ? 5.0 : halves(p_W); };
  double length = 0.0;
  const auto filter = filterOf(squareImage(21, three, VTK_INT), vtkImageCurves::Labels);
  for (const Curve& curve : run(filter))
  {
    for (std::size_t i = 1; i < curve.size(); ++i)
    {
      length += (curve[i] - curve[i - 1]).norm();
    }
  }
  // Once round a square of 7 with four corners cut over half a pixel, and the border above and below it, each counted
  // once; where three meet there are two short pieces more.
  const double round = 4 * 7.0 - 4 * (1 - std::sqrt(0.5)), above = 2 * 6.5;
  EXPECT_NEAR(length, round + above, 2.0);
}

namespace
{
/// The ends of a piece of a border, from left to right, in half pixels.
using Piece = std::array<int, 4>;

void addPieces(std::set<Piece>& pieces, const Vec3& a_W, const Vec3& b_W)
{
  const double longest = (b_W - a_W).cwiseAbs().maxCoeff();
  const bool slanted = a_W.x() != b_W.x() && a_W.y() != b_W.y();
  const int count = static_cast<int>(std::lround(slanted ? 2 * longest : longest));
  const auto twice = [](double x) { return static_cast<int>(std::lround(2 * x)); };
  for (int k = 0; k < count; ++k)
  {
    const Vec3 from_W = a_W + (b_W - a_W) * k / count, to_W = a_W + (b_W - a_W) * (k + 1) / count;
    std::array<std::array<int, 2>, 2> ends{ { { twice(from_W.x()), twice(from_W.y()) },
      { twice(to_W.x()), twice(to_W.y()) } } };
    std::sort(ends.begin(), ends.end());
    pieces.insert({ ends[0][0], ends[0][1], ends[1][0], ends[1][1] });
  }
}

/// The borders of each area by itself, as VTK has them.
std::set<Piece> bordersByVTK(vtkImageData* image, int labels)
{
  std::set<Piece> pieces;
  for (int label = 1; label < labels; ++label)
  {
    vtkNew<vtkDiscreteFlyingEdges2D> border;
    border->SetInputData(image);
    border->SetValue(0, label);
    border->Update();
    for (const Curve& line : curvesOf(border->GetOutput()))
    {
      addPieces(pieces, line.front(), line.back());
    }
  }
  return pieces;
}
} // namespace

// VTK's filter loses pieces at the last row and column, so there the images have one area only.
TEST(ImageCurves, BordersOfManyLabelsAreTheBordersOfEachTogether)
{
  test::Random random(test::testSeed(672));
  for (const int labels : { 2, 3, 7, 40 })
  {
    const int size = 40;
    const auto image = squareImage(
      size,
      [&](const Vec3& p_W)
      {
        const bool atEdge = std::max(p_W.x(), p_W.y()) > size - 3 || std::min(p_W.x(), p_W.y()) < 2;
        return atEdge ? 0.0 : std::floor(random.uniform(0, labels - 0.001));
      },
      VTK_INT);
    std::set<Piece> pieces;
    for (const Curve& curve : run(filterOf(image, vtkImageCurves::Labels)))
    {
      for (std::size_t i = 1; i < curve.size(); ++i)
      {
        addPieces(pieces, curve[i - 1], curve[i]);
      }
    }
    EXPECT_EQ(pieces, bordersByVTK(image, labels)) << labels;
  }
}

TEST(ImageCurves, ABorderGoesOnToTheEdgesOfTheImageAndNotRoundPixelsThatAreMissing)
{
  const auto corner = [](const Vec3& p_W) { return std::min(p_W.x(), p_W.y()) >= 2 ? 1.0 : 0.0; };
  const auto curves = run(filterOf(squareImage(5, corner), vtkImageCurves::Labels));
  ASSERT_EQ(curves.size(), 1u);
  const Curve expected{ { 4, 1.5, 0 }, { 2, 1.5, 0 }, { 1.5, 2, 0 }, { 1.5, 4, 0 } };
  EXPECT_THAT(curves[0], ::testing::AnyOf(expected, Curve(expected.rbegin(), expected.rend())));
  const auto missing = [](const Vec3& p_W) { return p_W.y() == 10 ? std::nan("") : p_W.x() < 10 ? 3.0 : 8.0; };
  const auto broken = run(filterOf(squareImage(21, missing), vtkImageCurves::Labels));
  ASSERT_EQ(broken.size(), 2u);
  for (const Curve& curve : broken)
  {
    EXPECT_EQ(std::abs(curve.front().y() - curve.back().y()), 9.0);
  }
}

TEST(ImageCurves, ADrawingBecomesTheMiddleLineOfItsStrokesWithItsGapsClosed)
{
  const Vec3 centre_W(50, 50, 0);
  const auto ring = [&](const Vec3& p_W)
  {
    const Vec3 r_W = p_W - centre_W;
    return std::abs(r_W.norm() - 35.0) < 2.5 && std::abs(std::atan2(r_W.y(), r_W.x())) > 0.1 ? 20.0 : 240.0;
  };
  const auto image = squareImage(100, ring, VTK_UNSIGNED_CHAR);
  const auto open = run(filterOf(image, vtkImageCurves::Drawing));
  ASSERT_EQ(open.size(), 1u);
  EXPECT_NE(open[0].front(), open[0].back());
  const auto filter = filterOf(image, vtkImageCurves::Drawing);
  filter->SetTolerance(1.0);
  const double blank = 2 * 32.5 * std::sin(0.1); // between the ends' inner corners
  filter->SetGap(blank - 1.5);
  EXPECT_EQ(run(filter).size(), 1u);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("Closed")->GetTuple1(0), 0.0);
  filter->SetGap(blank + 1.5);
  const auto closed = run(filter);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("Closed")->GetTuple1(0), 1.0);
  for (const Vec3& p_W : closed[0])
  {
    EXPECT_NEAR((p_W - centre_W).norm(), 35.0, 1.5);
  }
  const auto inverse =
    filterOf(squareImage(100, [&](const Vec3& p_W) { return 260.0 - ring(p_W); }), vtkImageCurves::Drawing);
  inverse->InkIsDarkOff();
  EXPECT_EQ(run(inverse), open);
}

TEST(ImageCurves, AWarningSaysThatMostOfADrawingIsInkAndWhatToSwitch)
{
  const auto image = squareImage(40, [](const Vec3& p_W) { return std::fmod(p_W.x(), 10.0) < 2.0 ? 0.0 : 1.0; });
  const auto filter = filterOf(image, vtkImageCurves::Drawing);
  for (const bool dark : { true, false })
  {
    filter->SetInkIsDark(dark);
    std::string said;
    vtkNew<vtkCallbackCommand> listen;
    listen->SetClientData(&said);
    listen->SetCallback([](vtkObject*, unsigned long, void* client, void* text)
      { *static_cast<std::string*>(client) = static_cast<const char*>(text); });
    const unsigned long tag = filter->AddObserver(vtkCommand::WarningEvent, listen);
    filter->Update();
    filter->RemoveObserver(tag);
    EXPECT_NEAR(filter->GetInkShare(), dark ? 0.2 : 0.8, 1e-12);
    EXPECT_EQ(said.empty(), dark) << said;
    EXPECT_THAT(
      said, dark ? HasSubstr("")
                 : HasSubstr("80 % of the image count as strokes: if the lines are the rest, turn \"Ink is dark\" on"));
  }
}

TEST(ImageCurves, ShortCurvesAreLeftOutOnDemand)
{
  const auto image = squareImage(60, [](const Vec3& p_W)
    { return std::min((p_W - Vec3(20, 20, 0)).norm() - 15.0, (p_W - Vec3(50, 50, 0)).norm() - 2.0); });
  EXPECT_EQ(run(contourAt(image, 0.0)).size(), 2u);
  const auto filter = contourAt(image, 0.0);
  filter->SetShortestCurve(20.0); // 2 pi 2 < 20 < 2 pi 15
  EXPECT_EQ(run(filter).size(), 1u);
}

TEST(ImageCurves, ImagesWithoutCurvesAreRefusedWithTheReason)
{
  const auto flat = [](const Vec3&) { return 7.0; };
  expectRefused(filterOf(squareImage(8, flat)), "one colour: all its values are 7");
  const std::array<int, 6> cube{ 0, 7, 0, 6, 0, 5 }, row{ 0, 7, 2, 2, 0, 0 };
  const auto slope = [](const Vec3& p_W) { return p_W.x(); };
  expectRefused(filterOf(imageOf(cube, slope)), "a volume of 8 x 7 x 6 points; cut out one slice");
  expectRefused(filterOf(imageOf(row, slope)), "not flat");
  expectRefused(filterOf(squareImage(8, slope, VTK_FLOAT, 2)), "2 values per pixel");
  expectRefused(
    contourAt(squareImage(8, slope), 9.0), "the value 9 meets no curve; the image holds values from 0 to 7");
  expectRefused(filterOf(squareImage(8, slope, VTK_UNSIGNED_CHAR, 3), vtkImageCurves::Labels), "a label map needs one");
  expectRefused(
    filterOf(squareImage(8, [](const Vec3& p_W) { return 0.5 * p_W.x(); }), vtkImageCurves::Labels), "not a label map");
  expectRefused(filterOf(squareImage(8, [](const Vec3&) { return std::nan(""); })), "no value of the image is finite");
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 1);
  expectRefused(filterOf(bare), "no values on its points");
  bare->GetCellData()->SetScalars(squareImage(3, slope)->GetPointData()->GetScalars());
  expectRefused(filterOf(bare), "Cell Data to Point Data");
}

TEST(ImageCurves, NumbersThatCannotBeAreRefused)
{
  const auto image = squareImage(8, [](const Vec3& p_W) { return p_W.x(); });
  for (const double bad : { -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    for (const auto set : { &vtkImageCurves::SetTolerance, &vtkImageCurves::SetGap, &vtkImageCurves::SetShortestCurve })
    {
      const auto filter = filterOf(image);
      (filter->*set)(bad);
      expectRefused(filter, "must be 0 or more");
    }
  }
  const auto filter = filterOf(image);
  filter->SetSimplifyBy(vtkImageCurves::ByFeel);
  filter->SetStiffness(0.0);
  expectRefused(filter, "Stiffness");
}
