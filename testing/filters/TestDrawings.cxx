// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings (SVG) and pictures (PNG) as lines in the plane.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/core/Types.h"
#include "testing/support/Polylines.h"
#include "testing/support/TemporaryFolder.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkHapticReaders.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPolyData.h"

using namespace palpate;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Matcher;
using ::testing::Not;

namespace
{
using Curve = std::vector<Vec3>;
constexpr double diagonal = 1000.0; // of the view box below
constexpr double tolerance = 1e-4 * diagonal;
constexpr double height = 800.0;

/// A file that is there as long as the test.
class Drawings : public ::testing::Test
{
protected:
  vtkHapticReadResult readText(const std::string& text)
  {
    const std::filesystem::path path = this->folder_ / "a.svg";
    std::ofstream(path) << text;
    return vtkHapticReadSurface(path, std::nullopt);
  }

  /// Elements in a view box of 600 by 800.
  vtkHapticReadResult readElements(const std::string& elements)
  {
    return this->readText("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 600 800'>" + elements + "</svg>");
  }

  vtkHapticReadResult readPath(const std::string& data) { return this->readElements("<path d='" + data + "'/>"); }

  /// The lines of a drawing, y downwards as its file has them.
  std::vector<Curve> lines(const vtkHapticReadResult& result)
  {
    std::vector<Curve> found;
    EXPECT_TRUE(result.Surface) << result.Problem;
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; result.Surface && i < result.Surface->GetNumberOfLines(); ++i)
    {
      result.Surface->GetLines()->GetCellAtId(i, ids);
      found.emplace_back();
      for (const vtkIdType id : *ids)
      {
        const double* p = result.Surface->GetPoint(id);
        found.back().emplace_back(p[0], height - p[1], p[2]);
      }
    }
    return found;
  }

  Curve onlyLine(const std::string& data)
  {
    const auto found = this->lines(this->readPath(data));
    EXPECT_EQ(found.size(), 1u) << data;
    return found.empty() ? Curve() : found.front();
  }

  static Vec3 place(const vtkHapticReadResult& result, const char* name)
  {
    vtkDataArray* array = result.Surface->GetFieldData()->GetArray(name);
    return array ? Vec3(array->GetTuple3(0)) : Vec3::Constant(std::nan(""));
  }

  const test::TemporaryFolder temporary_;
  const std::filesystem::path folder_ = this->temporary_.path();
};

/// The farthest that a point of the curve, at 10 000 places, is from the line.
template<class At>
double farthest(const Curve& line, const At& at)
{
  double error = 0.0;
  for (int i = 0; i <= 10000; ++i)
  {
    error = std::max(error, test::distanceToPolyline(at(i / 10000.0), line));
  }
  return error;
}

void expectSame(const Curve& found, const Curve& expected, const std::string& what)
{
  ASSERT_EQ(found.size(), expected.size()) << what;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_LT((found[i] - expected[i]).norm(), 1e-12) << what << ", point " << i;
  }
}
} // namespace

TEST_F(Drawings, APathMayBeWrittenInManyWays)
{
  const Curve square = { { 10, 20, 0 }, { 30, 20, 0 }, { 30, 40, 0 }, { 10, 40, 0 }, { 10, 20, 0 } };
  for (const std::string data :
    { "M10 20 L30 20 L30 40 L10 40 Z", "m10,20 20,0 0,20-20,0z", "M10 20H30V40H10V20", "M10 20h20v20h-20z",
      " M 1e1 +20 L 30 20 30 4.0e1,10 40 10 20 ", "M10 20l20 0 0 20-20 0.0.0-20", "M5 5M10 20H30V40H10Z" })
  {
    expectSame(this->onlyLine(data), square, data);
  }
}

TEST_F(Drawings, WhatFollowsAClosedPathBeginsWhereItBegan)
{
  const auto found = this->lines(this->readPath("M10 20h20v20z l-5 -5"));
  ASSERT_EQ(found.size(), 2u);
  expectSame(found[1], { { 10, 20, 0 }, { 5, 15, 0 } }, "second");
}

TEST_F(Drawings, CurvesBecomeChordsWithinATenThousandthOfTheDiagonal)
{
  const Vec3 a(100, 100, 0), b(400, 50, 0), c(-100, 600, 0), d(300, 500, 0);
  const auto cubic = [&](double t) -> Vec3
  { return std::pow(1 - t, 3) * a + 3 * t * std::pow(1 - t, 2) * b + 3 * t * t * (1 - t) * c + t * t * t * d; };
  const auto quadratic = [&](double t) -> Vec3 { return (1 - t) * (1 - t) * a + 2 * t * (1 - t) * b + t * t * c; };
  const Curve cubicLine = this->onlyLine("M100 100 C400 50 -100 600 300 500");
  const Curve quadraticLine = this->onlyLine("M100 100 q300 -50 -200 500");
  EXPECT_LE(farthest(cubicLine, cubic), tolerance);
  EXPECT_LE(farthest(quadraticLine, quadratic), tolerance);
  EXPECT_GT(farthest({ cubicLine.front(), cubicLine.back() }, cubic), 100.0 * tolerance); // a chord alone is not it
  // No more chords than the bound |x''| h^2 / 8 asks for.
  const double bend = 6.0 * std::max((a - 2.0 * b + c).norm(), (b - 2.0 * c + d).norm());
  EXPECT_LE(static_cast<double>(cubicLine.size()), 2.0 + std::sqrt(bend / (8.0 * tolerance)));
  EXPECT_LE(
    static_cast<double>(quadraticLine.size()), 2.0 + std::sqrt(2.0 * (a - 2.0 * b + c).norm() / (8.0 * tolerance)));
}

TEST_F(Drawings, SmoothCommandsMirrorTheLastControl)
{
  expectSame(this->onlyLine("M0 0 C10 0 20 10 20 20 S40 60 60 60"),
    this->onlyLine("M0 0 C10 0 20 10 20 20 C20 30 40 60 60 60"), "S after C");
  expectSame(this->onlyLine("M0 0 Q10 0 20 20 T60 60"), this->onlyLine("M0 0 Q10 0 20 20 Q30 40 60 60"), "T after Q");
  expectSame(this->onlyLine("M0 0 L20 20 S40 60 60 60"), this->onlyLine("M0 0 L20 20 C20 20 40 60 60 60"), "S after L");
}

/// Two circles of radius 50 pass (100, 100) and (150, 150); each has a short and a long arc.
TEST_F(Drawings, AnArcTakesTheCircleAndTheWayThatItsFlagsSay)
{
  struct Case
  {
    const char* flags;
    Vec3 center;
    double from, sweep; // rad
  };
  constexpr double quarter = 0.5 * std::numbers::pi;
  for (const auto& [flags, center, from, sweep] :
    { Case{ "0 1", { 100, 150, 0 }, -quarter, quarter }, Case{ "0 0", { 150, 100, 0 }, 2 * quarter, -quarter },
      Case{ "1 1", { 150, 100, 0 }, 2 * quarter, 3 * quarter },
      Case{ "1,0", { 100, 150, 0 }, -quarter, -3 * quarter } })
  {
    const Curve line = this->onlyLine(std::string("M100 100 A50 50 0 ") + flags + " 150 150");
    const double first = from, whole = sweep;
    const Vec3 middle = center;
    const auto arc = [&](double t) -> Vec3
    { return middle + 50.0 * Vec3(std::cos(first + t * whole), std::sin(first + t * whole), 0.0); };
    EXPECT_LE(farthest(line, arc), tolerance) << flags;
    for (const Vec3& p : line)
    {
      EXPECT_NEAR((p - center).norm(), 50.0, 1e-10) << flags;
    }
    EXPECT_LT((line.back() - Vec3(150, 150, 0)).norm(), 1e-12) << flags;
  }
}

TEST_F(Drawings, AnArcTooSmallToReachIsMadeLargerAndOneWithoutRadiusIsALine)
{
  const Curve grown = this->onlyLine("M100 100a1 1 0 01100 0"); // flags need no blanks behind them
  for (const Vec3& p : grown)
  {
    EXPECT_NEAR((p - Vec3(150, 100, 0)).norm(), 50.0, 1e-10);
  }
  expectSame(this->onlyLine("M100 100 A0 50 0 0 1 200 100"), { { 100, 100, 0 }, { 200, 100, 0 } }, "no radius");
}

TEST_F(Drawings, ShapesStandWhereTheirTransformsPutThem)
{
  const auto found = this->lines(this->readElements("<g transform='translate(10,20) scale(2)'>"
                                                    "<line x1='1' y1='2' x2='3px' y2='4'/></g>"
                                                    "<polyline points='1,2 3,4' transform='rotate(90)'/>"
                                                    "<polygon points='0 0 1 0 1 1' transform='matrix(2 0 1 3 5 6)'/>"
                                                    "<rect x='1' y='2' width='3' height='4'/>"
                                                    "<line x2='1' y2='1' transform='skewX(45)'/>"
                                                    "<line x2='1' transform='rotate(90 1 0)'/>"));
  const std::vector<Curve> expected = { { { 12, 24, 0 }, { 16, 28, 0 } }, { { -2, 1, 0 }, { -4, 3, 0 } },
    { { 5, 6, 0 }, { 7, 6, 0 }, { 8, 9, 0 }, { 5, 6, 0 } },
    { { 1, 2, 0 }, { 4, 2, 0 }, { 4, 6, 0 }, { 1, 6, 0 }, { 1, 2, 0 } }, { { 0, 0, 0 }, { 2, 1, 0 } },
    { { 1, -1, 0 }, { 1, 0, 0 } } };
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    expectSame(found[i], expected[i], "shape " + std::to_string(i));
  }
}

TEST_F(Drawings, StartAndExitAreCentresOfShapesAndNoLines)
{
  const vtkHapticReadResult result = this->readElements("<line x2='9'/><g transform='translate(100 0) rotate(30)'>"
                                                        "<circle id='start' cx='10' r='3'/></g>"
                                                        "<rect id='exit' x='50' y='60' width='2' height='4'/>");
  EXPECT_EQ(this->lines(result).size(), 1u);
  const double angle = std::numbers::pi / 6.0;
  EXPECT_LT((place(result, "Start") - Vec3(100 + 10 * std::cos(angle), height - 10 * std::sin(angle), 0)).norm(), 1e-9);
  EXPECT_LT((place(result, "Exit") - Vec3(51, height - 62, 0)).norm(), 1e-12);
}

TEST_F(Drawings, WhatIsNotDisplayedIsNoLineAndWhatCannotBeALineIsSaid)
{
  const vtkHapticReadResult result =
    this->readElements("<line x2='9'/><g display='none'><g><line x2='8'/></g><line x2='7'/></g>"
                       "<defs><line x2='6'/></defs><path style='fill:red; display: none' d='M0 0h5'/>"
                       "<text x='1'>A<tspan>b</tspan></text><use href='#a'/><text>c</text><line y2='9'/>");
  EXPECT_EQ(this->lines(result).size(), 2u);
  EXPECT_THAT(result.Note, HasSubstr("left out: 2 text, 1 use"));
}

TEST_F(Drawings, ABrokenOneIsRefusedWithTheFileTheElementAndThePlace)
{
  struct Case
  {
    std::string elements, reason;
  };
  for (const auto& [elements, reason] :
    { Case{ "<path d='10 10'/>", "expected a command after 0 characters" }, Case{ "<path d='L10 10'/>", "M first" },
      Case{ "<path d='M1'/>", "expected a number after 2" }, Case{ "<path d='M1 2 L'/>", "expected a number after 6" },
      Case{ "<path d='M1 2 X3'/>", "one of the path commands" },
      Case{ "<path d='M1 2 A1 1 0 2 0 5 5'/>", "expected 0 or 1" }, Case{ "<path d='M1 nan'/>", "expected a number" },
      Case{ "<path d='M1 2z3 4'/>", "expected a command" }, Case{ "<path d='M1 2 3e999 4'/>", "expected a number" },
      Case{ "<path d='M1 2 L1e150 4'/>", "out of range" }, Case{ "<polyline points='1 2 3'/>", "second number" },
      Case{ "<line x1='5%' x2='9'/>", "'5%' is not a length" }, Case{ "<line x1='5mm' x2='9'/>", "not a length" },
      Case{ "<line x2='9' transform='spin(3)'/>", "expected matrix" },
      Case{ "<line x2='9' transform='scale'/>", "expected '('" },
      Case{ "<line x2='9' transform='scale(1'/>", "expected a number" },
      Case{ "<path d='M0 0 C1e60 0 0 1e60 5 5'/>", "out of range" },
      Case{ "<path id='start' d=''/>", "without size" } })
  {
    const vtkHapticReadResult result = this->readElements("<line x2='3'/>" + elements);
    EXPECT_FALSE(result.Surface) << elements;
    EXPECT_THAT(result.Problem, AllOf(HasSubstr("a.svg"), HasSubstr(reason))) << elements;
    EXPECT_THAT(result.Problem, ::testing::Not(HasSubstr("\n"))) << elements;
  }
  EXPECT_THAT(this->readElements("<path d='M0 0h9'/><path d='M0 0h'/>").Problem, HasSubstr("path 2 of the drawing"));
}

TEST_F(Drawings, WhatIsNoDrawingIsRefused)
{
  EXPECT_THAT(this->readText("<svg><path d='M0 0h9'/>").Problem, HasSubstr("cut short behind path 1"));
  EXPECT_THAT(this->readText("once upon a time").Problem, HasSubstr("not XML"));
  EXPECT_THAT(this->readText("<html><path d='M0 0h9'/></html>").Problem, HasSubstr("not an SVG"));
  EXPECT_THAT(this->readText("<svg></svg>").Problem, HasSubstr("no lines"));
  EXPECT_THAT(this->readText("<svg viewBox='0 0 0 9'><line x2='9'/></svg>").Problem, HasSubstr("viewBox"));
}

namespace
{
/// A ring of ink, three pixels wide, with a green and a red square in it, as PNG.
void writeRing(const std::filesystem::path& path, double radius, int scalarType = VTK_UNSIGNED_CHAR, bool clear = false)
{
  constexpr int size = 101;
  const double brightest = scalarType == VTK_UNSIGNED_CHAR ? 255.0 : 65535.0;
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(scalarType, clear ? 4 : 3);
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      const bool ink = std::abs(std::hypot(i - 50, j - 50) - radius) <= 1.5;
      const bool start = std::abs(i - 30) <= 2 && std::abs(j - 50) <= 2,
                 exit = std::abs(i - 70) <= 2 && std::abs(j - 60) <= 1;
      const double colour[3] = { start || ink ? 0.0 : 1.0,
        exit || ink ? 0.0
        : start     ? 0.8
                    : 1.0,
        start || exit || ink ? 0.0 : 1.0 };
      for (int component = 0; component < 3; ++component)
      {
        image->SetScalarComponentFromDouble(
          i, j, 0, component, clear && !ink ? colour[component] : brightest * colour[component]);
      }
      if (clear)
      {
        image->SetScalarComponentFromDouble(i, j, 0, 3, ink ? brightest : 0.0);
      }
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
}
} // namespace

TEST_F(Drawings, APictureBecomesTheMiddleOfItsInkAndItsMarks)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT })
  {
    const std::filesystem::path path = this->folder_ / "ring.png";
    writeRing(path, 40.0, type);
    const vtkHapticReadResult result = vtkHapticReadSurface(path, std::nullopt);
    ASSERT_TRUE(result.Surface) << result.Problem;
    EXPECT_GT(result.Surface->GetNumberOfPoints(), 8);
    for (vtkIdType i = 0; i < result.Surface->GetNumberOfPoints(); ++i)
    {
      EXPECT_NEAR((Vec3(result.Surface->GetPoint(i)) - Vec3(50, 50, 0)).norm(), 40.0, 1.5); // within the ink
    }
    EXPECT_EQ(place(result, "Start"), Vec3(30, 50, 0));
    EXPECT_EQ(place(result, "Exit"), Vec3(70, 60, 0));
  }
}

// The lines between would be walls in the middle of the corridors.
TEST_F(Drawings, APictureWithLightLinesIsSaidToBeMostlyDark)
{
  constexpr int size = 40;
  const std::filesystem::path path = this->folder_ / "light.png";
  for (const int line : { 0, 255 })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(size, size, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        image->SetScalarComponentFromDouble(i, j, 0, 0, i % 10 < 2 ? line : 255 - line); // a fifth is line
      }
    }
    vtkNew<vtkPNGWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputData(image);
    writer->Write();
    const vtkHapticReadResult result = vtkHapticReadSurface(path, std::nullopt);
    ASSERT_TRUE(result.Surface) << result.Problem;
    const auto said = HasSubstr("mostly dark (80 %); if its lines are the light ones, invert it");
    EXPECT_THAT(result.Note, line == 0 ? Matcher<std::string>(Not(said)) : Matcher<std::string>(said));
    EXPECT_THAT(result.Note, HasSubstr("middle of its dark strokes"));
  }
}

TEST_F(Drawings, WhatIsClearInAPictureIsPaper)
{
  const std::filesystem::path path = this->folder_ / "ring.png";
  writeRing(path, 40.0, VTK_UNSIGNED_CHAR, true);
  const vtkHapticReadResult result = vtkHapticReadSurface(path, std::nullopt);
  ASSERT_TRUE(result.Surface) << result.Problem;
  EXPECT_FALSE(result.Surface->GetFieldData()->GetArray("Start"));
  EXPECT_GT(result.Surface->GetNumberOfPoints(), 8);
  for (vtkIdType i = 0; i < result.Surface->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR((Vec3(result.Surface->GetPoint(i)) - Vec3(50, 50, 0)).norm(), 40.0, 1.5);
  }
}

TEST_F(Drawings, APictureCutShortAtAnyPlaceIsRefused)
{
  const std::filesystem::path whole = this->folder_ / "ring.png", cut = this->folder_ / "cut.png";
  writeRing(whole, 40.0);
  std::ifstream in(whole, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>() };
  const std::size_t content = bytes.find("IEND") - 8; // nothing that is needed follows the last row's check sum
  for (std::size_t length = 1; length < content; length += 7)
  {
    std::ofstream(cut, std::ios::binary) << bytes.substr(0, length);
    const vtkHapticReadResult result = vtkHapticReadSurface(cut, std::nullopt);
    EXPECT_FALSE(result.Surface) << length << " of " << bytes.size();
    EXPECT_THAT(result.Problem, AllOf(HasSubstr("cut.png"), HasSubstr("cut short"))) << length;
  }
}

TEST_F(Drawings, APictureOfOneColourOrOneRowIsRefused)
{
  const std::filesystem::path path = this->folder_ / "a.png";
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  for (const auto& [height_px, reason] : { std::pair(9, "one colour only"), std::pair(1, "one pixel") })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(9, height_px, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    for (int i = 0; i < 9 * height_px; ++i)
    {
      image->SetScalarComponentFromDouble(i % 9, i / 9, 0, 0, height_px == 1 ? 20 * i : 200);
    }
    writer->SetInputData(image);
    writer->Write();
    EXPECT_THAT(vtkHapticReadSurface(path, std::nullopt).Problem, HasSubstr(reason));
  }
}
