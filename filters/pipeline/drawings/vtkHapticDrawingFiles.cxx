// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticDrawingFiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <vector>

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHapticFileGuards.h"
#include "vtkHapticSVGParser.h"
#include "vtkImageCurves.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtk_png.h"

namespace
{
using Point = vtkHapticPlaneLines::Point;
constexpr double LeastBytesPerPixel = 0.125;
constexpr std::uint64_t MostPixels = std::uint64_t(1) << 28;

void AddPlace(vtkPolyData* world, const char* name, const std::optional<Point>& place)
{
  if (place)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(3);
    array->InsertNextTuple3(place->x(), place->y(), 0.0);
    world->GetFieldData()->AddArray(array);
  }
}

vtkSmartPointer<vtkPolyData> ToPolyData(const vtkHapticDrawing& drawing)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const vtkHapticPlaneLines::Line& line : drawing.Lines)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    const bool closed = line.size() > 3 && line.front() == line.back();
    lines->InsertNextCell(static_cast<int>(line.size()));
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      const bool again = closed && i + 1 == line.size();
      lines->InsertCellPoint(again ? first : points->InsertNextPoint(line[i].x(), line[i].y(), 0.0));
    }
  }
  auto world = vtkSmartPointer<vtkPolyData>::New();
  world->SetPoints(points);
  world->SetLines(lines);
  AddPlace(world, "Start", drawing.Start);
  AddPlace(world, "Exit", drawing.Exit);
  return world;
}

using Colour = std::array<std::uint8_t, 3>;

/// Pixels laid on white paper, the topmost row first.
struct Picture
{
  std::uint32_t Width = 0;
  std::uint32_t Height = 0;
  std::vector<Colour> Pixels;
};

/// libpng's simplified interface, which returns on every error: vtkPNGReader crashes on a file that is cut short.
Picture ReadPicture(const std::string& path)
{
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  Picture picture;
  if (png_image_begin_read_from_file(&image, path.c_str()))
  {
    picture.Width = image.width;
    picture.Height = image.height;
    const int size[3] = { static_cast<int>(image.width), static_cast<int>(image.height), 1 };
    const std::string problem = vtkHapticFileGuards::CheckImageBytes(path, size, LeastBytesPerPixel, true);
    if (!problem.empty() || std::uint64_t(image.width) * image.height > MostPixels)
    {
      png_image_free(&image);
      throw std::runtime_error(problem.empty() ? "it has more than 268 million pixels; make it smaller" : problem);
    }
    picture.Pixels.resize(std::size_t(image.width) * image.height);
    image.format = PNG_FORMAT_RGB;
    const png_color paper = { 255, 255, 255 };
    png_image_finish_read(&image, &paper, picture.Pixels.data(), 0, nullptr);
  }
  if (PNG_IMAGE_FAILED(image))
  {
    throw std::runtime_error(std::string("not a PNG picture, damaged or cut short (") + image.message + ")");
  }
  return picture;
}

/// Where pixels of one colour are, in the middle.
class Mark
{
public:
  void Add(double i, double j)
  {
    this->Sum += Point(i, j);
    ++this->Count;
  }

  [[nodiscard]] std::optional<Point> GetPlace() const
  {
    return this->Count > 0 ? std::optional<Point>(this->Sum / static_cast<double>(this->Count)) : std::nullopt;
  }

private:
  Point Sum = Point::Zero();
  std::size_t Count = 0;
};

/// The brightness of a picture, and its marks.
struct Ink
{
  vtkNew<vtkImageData> Grey;
  Mark Start;
  Mark Exit;
};

/// A mark stands out from grey: one of its colours is at least half, and twice the other two.
bool IsMark(const Colour& colour, std::size_t which)
{
  return colour[which] >= 128 && colour[which] >= 2 * std::max(colour[(which + 1) % 3], colour[(which + 2) % 3]);
}

void Separate(const Picture& picture, Ink& ink)
{
  ink.Grey->SetDimensions(static_cast<int>(picture.Width), static_cast<int>(picture.Height), 1);
  vtkNew<vtkUnsignedCharArray> grey;
  grey->SetNumberOfTuples(static_cast<vtkIdType>(picture.Pixels.size()));
  vtkIdType next = 0;
  for (std::uint32_t j = 0; j < picture.Height; ++j)
  {
    const std::size_t row = std::size_t(picture.Height - 1 - j) * picture.Width;
    for (std::uint32_t i = 0; i < picture.Width; ++i)
    {
      const Colour& colour = picture.Pixels[row + i];
      const bool start = IsMark(colour, 1), exit = IsMark(colour, 0);
      if (start || exit)
      {
        (start ? ink.Start : ink.Exit).Add(i, j);
      }
      const int mean = (colour[0] + colour[1] + colour[2]) / 3;
      grey->SetValue(next++, static_cast<unsigned char>(start || exit ? 255 : mean));
    }
  }
  ink.Grey->GetPointData()->SetScalars(grey);
}

void CheckInk(vtkImageData* grey)
{
  double range[2];
  grey->GetPointData()->GetScalars()->GetRange(range);
  if (!(range[0] < range[1]))
  {
    throw std::runtime_error("it has one colour only; a picture to touch has dark lines on light paper");
  }
  int size[3];
  grey->GetDimensions(size);
  if (std::min(size[0], size[1]) < 2)
  {
    throw std::runtime_error("it is only one pixel wide or high");
  }
}
} // namespace

namespace vtkHapticDrawingFiles
{
vtkSmartPointer<vtkPolyData> ReadSVG(const std::string& path, std::string& note)
{
  std::ifstream file(path, std::ios::binary);
  const std::string content{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  const vtkHapticDrawing drawing = vtkHapticParseSVG(content);
  if (!drawing.Problem.empty())
  {
    throw std::runtime_error(drawing.Problem);
  }
  note = drawing.Note;
  return ToPolyData(drawing);
}

vtkSmartPointer<vtkPolyData> ReadPNG(const std::string& path, std::string& note)
{
  Ink ink;
  Separate(ReadPicture(path), ink);
  CheckInk(ink.Grey);
  vtkNew<vtkImageCurves> curves;
  curves->SetInputData(ink.Grey);
  curves->SetKind(vtkImageCurves::Drawing);
  curves->SetTolerance(1.0);
  curves->Update();
  vtkSmartPointer<vtkPolyData> world = curves->GetOutput();
  AddPlace(world, "Start", ink.Start.GetPlace());
  AddPlace(world, "Exit", ink.Exit.GetPlace());
  note = "lines are the middle of its dark strokes, within a pixel";
  if (curves->GetInkShare() > vtkImageCurves::MostInk)
  {
    note = "it is mostly dark (" + std::to_string(std::lround(100.0 * curves->GetInkShare())) +
           " %); if its lines are the light ones, invert it: " + note;
  }
  return world;
}
} // namespace vtkHapticDrawingFiles
