// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticImageLines.h"

#include <cmath>
#include <set>
#include <stdexcept>
#include <unordered_map>

#include "vtkCellArray.h"
#include "vtkDiscreteFlyingEdges2D.h"
#include "vtkFlyingEdges2D.h"
#include "vtkHapticImagePlane.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using palpate::LooseLines;
using palpate::Vec3;

namespace
{
/// More labels than this are a field and no label map.
constexpr std::size_t MostLabels = 4096;

/// VTK keeps points in single precision: in a large image too little for the bounds of a contour. A point lies between
/// two pixels, so its place there is worked out anew.
Vec3 Sharpened(const vtkHapticImagePlane& plane, double value, const double p[3])
{
  const double i = std::floor(p[0]), j = std::floor(p[1]);
  const bool alongI = p[0] > i, alongJ = p[1] > j;
  if (alongI == alongJ)
  {
    return { p[0], p[1], 0.0 };
  }
  const auto column = static_cast<std::int64_t>(i), row = static_cast<std::int64_t>(j);
  const double here = plane.GetValue(column, row);
  const double there = plane.GetValue(column + alongI, row + alongJ);
  const double share = (value - here) / (there - here);
  return { i + (alongI ? share : 0.0), j + (alongJ ? share : 0.0), 0.0 };
}

void AddSegments(vtkCellArray* cells, const std::vector<std::uint32_t>& indexOf, LooseLines& lines)
{
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(count, points);)
  {
    const std::uint32_t a = indexOf[static_cast<std::size_t>(points[0])];
    const std::uint32_t b = indexOf[static_cast<std::size_t>(points[1])];
    if (lines.points_W[a].allFinite() && lines.points_W[b].allFinite())
    {
      lines.segments.push_back({ a, b });
    }
  }
}

std::set<double> LabelsOf(const vtkHapticImagePlane& plane)
{
  std::set<double> labels;
  double last = std::nan("");
  for (std::int64_t j = 0; j < plane.GetHeight(); ++j)
  {
    for (std::int64_t i = 0; i < plane.GetWidth(); ++i)
    {
      const double label = plane.GetValue(i, j);
      if (label == last || std::isnan(label))
      {
        continue;
      }
      last = label;
      labels.insert(label);
      if (label != std::floor(label) || labels.size() > MostLabels)
      {
        throw std::runtime_error("this is no label map: it has values that are not whole, or more than " +
                                 std::to_string(MostLabels) + " of them; take its contour instead");
      }
    }
  }
  return labels;
}

/// Points of borders lie half way between pixels: the same ones of two areas get the same index.
class SharedPoints
{
public:
  explicit SharedPoints(LooseLines& lines) : Lines(lines) {}

  std::uint32_t IndexOf(const double p[3])
  {
    const auto key = static_cast<std::uint64_t>(2 * p[1] + 0.5) << 32 | static_cast<std::uint64_t>(2 * p[0] + 0.5);
    const auto [place, isNew] = this->Known.try_emplace(key, static_cast<std::uint32_t>(this->Lines.points_W.size()));
    if (isNew)
    {
      this->Lines.points_W.emplace_back(p[0], p[1], 0.0);
    }
    return place->second;
  }

private:
  LooseLines& Lines;
  std::unordered_map<std::uint64_t, std::uint32_t> Known;
};

palpate::Bitmap InkOf(const vtkHapticImagePlane& plane, double value, bool inkIsDark)
{
  palpate::Bitmap drawing;
  drawing.width = plane.GetWidth();
  drawing.height = plane.GetHeight();
  drawing.ink.reserve(static_cast<std::size_t>(drawing.width) * drawing.height);
  for (std::int64_t j = 0; j < drawing.height; ++j)
  {
    for (std::int64_t i = 0; i < drawing.width; ++i)
    {
      const double here = plane.GetValue(i, j);
      drawing.ink.push_back((inkIsDark ? here < value : here > value) ? 1 : 0);
    }
  }
  return drawing;
}
} // namespace

LooseLines vtkHapticImageLines::Contour(const vtkHapticImagePlane& plane, double value)
{
  vtkNew<vtkFlyingEdges2D> contour;
  contour->SetInputData(plane.GetPixels());
  contour->SetValue(0, value);
  contour->ComputeScalarsOff();
  contour->Update();
  vtkPolyData* found = contour->GetOutput();
  LooseLines lines;
  std::vector<std::uint32_t> indexOf(static_cast<std::size_t>(found->GetNumberOfPoints()));
  lines.points_W.reserve(indexOf.size());
  for (std::size_t i = 0; i < indexOf.size(); ++i)
  {
    indexOf[i] = static_cast<std::uint32_t>(i);
    lines.points_W.push_back(Sharpened(plane, value, found->GetPoint(static_cast<vtkIdType>(i))));
  }
  AddSegments(found->GetLines(), indexOf, lines);
  return lines;
}

LooseLines vtkHapticImageLines::Labels(const vtkHapticImagePlane& plane, const std::function<bool(double)>& goes)
{
  double range[2];
  plane.GetRange(range);
  std::set<double> labels = LabelsOf(plane);
  labels.erase(labels.begin()); // what is left has the borders of the least label too
  LooseLines lines;
  SharedPoints shared(lines);
  double done = 0.0;
  for (const double label : labels)
  {
    if (!goes(done++ / static_cast<double>(labels.size())))
    {
      break;
    }
    vtkNew<vtkDiscreteFlyingEdges2D> border;
    border->SetInputData(plane.GetPixels());
    border->SetValue(0, label);
    border->ComputeScalarsOff();
    border->Update();
    vtkPolyData* found = border->GetOutput();
    std::vector<std::uint32_t> indexOf(static_cast<std::size_t>(found->GetNumberOfPoints()));
    for (std::size_t i = 0; i < indexOf.size(); ++i)
    {
      indexOf[i] = shared.IndexOf(found->GetPoint(static_cast<vtkIdType>(i)));
    }
    AddSegments(found->GetLines(), indexOf, lines);
  }
  return lines;
}

LooseLines vtkHapticImageLines::Drawing(const vtkHapticImagePlane& plane, double value, bool inkIsDark, double gap)
{
  const palpate::Bitmap drawing = InkOf(plane, value, inkIsDark);
  palpate::Bitmap thinned = drawing;
  palpate::thin(thinned);
  LooseLines lines = palpate::linesOf(thinned);
  if (gap > 0.0)
  {
    palpate::mendGaps(lines, drawing, { plane.GetSpacing(0), plane.GetSpacing(1) }, gap);
  }
  return lines;
}
