// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticImageLines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include "vtkHapticImagePlane.h"
#include "vtkHapticPixelSquares.h"

using palpate::LooseLines;

namespace
{
/// More labels than this are a field and no label map.
constexpr std::size_t MostLabels = 4096;

/// Shares of the work on a drawing: read, thinned; and the rest for its gaps, of which there are none without gap.
constexpr double ReadShare = 0.2, ThinnedShare = 0.6;
constexpr std::size_t RowsPerReport = 16;

bool AllFinite(const std::array<double, 4>& values)
{
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// Pixels that reach a value, and the rest.
struct Level
{
  double Value;

  template<class Draw>
  void Divide(const std::array<double, 4>& values, Draw draw) const
  {
    unsigned reached = 0;
    for (unsigned k = 0; k < 4; ++k)
    {
      reached |= values[k] >= this->Value ? 1U << k : 0U;
    }
    if (reached != 0 && reached != 15 && AllFinite(values))
    {
      draw(reached);
    }
  }

  [[nodiscard]] double GetShare(double a, double b) const { return (this->Value - a) / (b - a); }
};

/// Each area and the rest. The rest has the borders of the least label too.
struct Areas
{
  double Least;

  template<class Draw>
  void Divide(const std::array<double, 4>& values, Draw draw) const
  {
    if ((values[0] == values[1] && values[0] == values[2] && values[0] == values[3]) || !AllFinite(values))
    {
      return;
    }
    unsigned drawn = 0;
    for (unsigned k = 0; k < 4; ++k)
    {
      unsigned same = 0;
      for (unsigned other = 0; other < 4; ++other)
      {
        same |= values[other] == values[k] ? 1U << other : 0U;
      }
      if (values[k] != this->Least && !(drawn & same))
      {
        draw(same);
      }
      drawn |= same;
    }
  }

  [[nodiscard]] double GetShare(double, double) const { return 0.5; }
};

void CheckLabels(const vtkHapticImagePlane& plane)
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
        throw std::runtime_error("not a label map: the image has values that are not integers, or more than " +
                                 std::to_string(MostLabels) + " labels; use the kind Contour instead");
      }
    }
  }
}

palpate::Bitmap InkOf(const vtkHapticImagePlane& plane, double value, bool inkIsDark, const palpate::Goes& goes)
{
  palpate::Bitmap drawing;
  drawing.width = plane.GetWidth();
  drawing.height = plane.GetHeight();
  drawing.ink.reserve(static_cast<std::size_t>(drawing.width) * drawing.height);
  palpate::Steps steps(goes, RowsPerReport);
  for (std::uint32_t j = 0; j < drawing.height && steps.go(j, drawing.height); ++j)
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

LooseLines vtkHapticImageLines::Contour(const vtkHapticImagePlane& plane, double value, const palpate::Goes& goes)
{
  return vtkHapticPixelSquares(plane, Level{ value }).Walk(goes);
}

LooseLines vtkHapticImageLines::Labels(const vtkHapticImagePlane& plane, const palpate::Goes& goes)
{
  double range[2];
  plane.GetRange(range);
  CheckLabels(plane);
  return vtkHapticPixelSquares(plane, Areas{ range[0] }).Walk(goes);
}

vtkHapticImageLines::Drawn vtkHapticImageLines::Drawing(
  const vtkHapticImagePlane& plane, double value, bool inkIsDark, double gap, const palpate::Goes& goes)
{
  bool going = true;
  const palpate::Goes watched = [&](double share) { return going = going && goes(share); };
  const palpate::Bitmap drawing = InkOf(plane, value, inkIsDark, palpate::partOf(watched, 0.0, ReadShare));
  if (!going)
  {
    return {};
  }
  Drawn drawn;
  drawn.InkShare = static_cast<double>(std::count(drawing.ink.begin(), drawing.ink.end(), 1)) /
                   static_cast<double>(drawing.ink.size());
  palpate::Bitmap thinned = drawing;
  palpate::thin(thinned, palpate::partOf(watched, ReadShare, gap > 0.0 ? ThinnedShare : 1.0));
  drawn.Lines = palpate::linesOf(thinned);
  if (gap > 0.0 && going)
  {
    palpate::mendGaps(drawn.Lines, drawing, { plane.GetSpacing(0), plane.GetSpacing(1) }, gap,
      palpate::partOf(watched, ThinnedShare, 1.0));
  }
  return drawn;
}
