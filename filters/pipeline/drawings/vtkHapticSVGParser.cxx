// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSVGParser.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>

#include "vtkHapticSVGPath.h"
#include "vtkHapticTextScanner.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

namespace
{
using Point = vtkHapticPlaneLines::Point;
using Line = vtkHapticPlaneLines::Line;
using Attributes = std::map<std::string_view, std::string_view>;

constexpr double SharePerDiagonal = 1e-4;

std::string_view ValueOf(const Attributes& attributes, std::string_view name)
{
  const auto found = attributes.find(name);
  return found == attributes.end() ? std::string_view() : found->second;
}

/// A length in user units; 0 where there is none.
double LengthOf(const Attributes& attributes, std::string_view name)
{
  std::string_view text = ValueOf(attributes, name);
  if (text.ends_with("px"))
  {
    text.remove_suffix(2);
  }
  if (text.empty())
  {
    return 0.0;
  }
  const std::optional<double> value = palpate::signedNumberIn<double>(text);
  if (!value || !std::isfinite(*value))
  {
    throw std::runtime_error(
      vtkHapticText::Quoted(text) + " is not a length in user units; save the drawing with plain numbers");
  }
  return *value;
}

Point PlaceOf(const Attributes& attributes, std::string_view x, std::string_view y)
{
  return { LengthOf(attributes, x), LengthOf(attributes, y) };
}

void AppendPoints(const std::vector<Point>& points, bool closed, vtkHapticPlaneLines& lines)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    i == 0 ? lines.MoveTo(points[i]) : lines.LineTo(points[i]);
  }
  if (closed && !points.empty())
  {
    lines.Close();
  }
}

void AppendRect(const Attributes& attributes, vtkHapticPlaneLines& lines)
{
  const Point low = PlaceOf(attributes, "x", "y"), size = PlaceOf(attributes, "width", "height");
  AppendPoints({ low, low + Point(size.x(), 0.0), low + size, low + Point(0.0, size.y()) }, true, lines);
}

void AppendEllipse(const Point& center, const Point& radii, vtkHapticPlaneLines& lines)
{
  const Point first = center + Point(radii.x(), 0.0);
  lines.MoveTo(first);
  lines.ArcTo(center, radii.asDiagonal(), 0.0, 2.0 * std::numbers::pi, first);
}

/// False for an element that is no shape.
bool AppendShape(std::string_view name, const Attributes& attributes, vtkHapticPlaneLines& lines)
{
  if (name == "path")
  {
    vtkHapticSVGPath::Append(ValueOf(attributes, "d"), lines);
  }
  else if (name == "line")
  {
    AppendPoints({ PlaceOf(attributes, "x1", "y1"), PlaceOf(attributes, "x2", "y2") }, false, lines);
  }
  else if (name == "polyline" || name == "polygon")
  {
    AppendPoints(vtkHapticSVGPath::ParsePoints(ValueOf(attributes, "points")), name == "polygon", lines);
  }
  else if (name == "rect")
  {
    AppendRect(attributes, lines);
  }
  else if (name == "circle")
  {
    const double radius = LengthOf(attributes, "r");
    AppendEllipse(PlaceOf(attributes, "cx", "cy"), { radius, radius }, lines);
  }
  else if (name == "ellipse")
  {
    AppendEllipse(PlaceOf(attributes, "cx", "cy"), PlaceOf(attributes, "rx", "ry"), lines);
  }
  else
  {
    return false;
  }
  return true;
}

bool IsHidden(std::string_view name, const Attributes& attributes)
{
  constexpr std::string_view notDrawn[] = { "defs", "symbol", "clipPath", "mask", "marker", "pattern", "metadata" };
  std::string style(ValueOf(attributes, "style"));
  std::erase(style, ' ');
  return std::find(std::begin(notDrawn), std::end(notDrawn), name) != std::end(notDrawn) ||
         ValueOf(attributes, "display") == "none" || style.find("display:none") != std::string::npos;
}

bool IsLeftOut(std::string_view name)
{
  return name == "text" || name == "image" || name == "use" || name == "foreignObject";
}

Point CenterOf(const std::vector<Line>& lines)
{
  Eigen::AlignedBox2d box;
  for (const Line& line : lines)
  {
    for (const Point& p : line)
    {
      box.extend(p);
    }
  }
  if (box.isEmpty())
  {
    throw std::runtime_error("an element without size has no centre");
  }
  return box.center();
}

/// Turns y upwards: the height of the drawing, or 0 where it says none, stays above the origin.
Eigen::Affine2d UpwardsFrom(double height)
{
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  map.linear()(1, 1) = -1.0;
  map.translation().y() = height;
  return map;
}
} // namespace

/// Follows the elements of one drawing. Expat calls from C, so nothing is thrown through it: the first problem is kept,
/// and later elements are passed over.
class vtkHapticSVGElements : public vtkXMLParser
{
public:
  static vtkHapticSVGElements* New();
  vtkTypeMacro(vtkHapticSVGElements, vtkXMLParser);

  [[nodiscard]] vtkHapticDrawing TakeDrawing()
  {
    vtkHapticDrawing& drawing = this->Drawing;
    if (drawing.Problem.empty() && !this->HasRoot)
    {
      drawing.Problem = "not an SVG drawing: the first element is not svg";
    }
    if (drawing.Problem.empty() && drawing.Lines.empty())
    {
      drawing.Problem = "the drawing has no lines to touch";
    }
    if (!drawing.Problem.empty())
    {
      drawing.Lines.clear();
    }
    for (const auto& [name, count] : this->LeftOut)
    {
      drawing.Note += (drawing.Note.empty() ? "left out: " : ", ") + std::to_string(count) + " " + name;
    }
    return std::move(drawing);
  }

protected:
  vtkHapticSVGElements() = default;
  ~vtkHapticSVGElements() override = default;

  void StartElement(const char* fullName, const char** pairs) override
  {
    const std::string_view full(fullName);
    const std::string_view name = full.substr(full.find(':') + 1); // npos + 1 is 0
    if (!this->Drawing.Problem.empty())
    {
      return;
    }
    const std::string key(name.substr(0, 24));
    this->Last = key + " " + std::to_string(++this->Elements[key]);
    try
    {
      Attributes attributes;
      for (; pairs[0]; pairs += 2)
      {
        attributes.emplace(pairs[0], pairs[1]);
      }
      this->Open(name, attributes);
    }
    catch (const std::exception& error)
    {
      this->Drawing.Problem = this->Last + " of the drawing: " + error.what();
    }
  }

  void EndElement(const char*) override
  {
    if (this->Drawing.Problem.empty())
    {
      this->Maps.pop_back();
      this->Hidden -= this->Hidden > 0;
    }
  }

  void ReportXmlParseError() override
  {
    if (this->Drawing.Problem.empty())
    {
      this->Drawing.Problem = "not XML, damaged or cut short" + (this->Last.empty() ? "" : " behind " + this->Last);
    }
  }

private:
  vtkHapticSVGElements(const vtkHapticSVGElements&) = delete;
  void operator=(const vtkHapticSVGElements&) = delete;

  void Open(std::string_view name, const Attributes& attributes)
  {
    if (this->Maps.empty())
    {
      this->OpenRoot(name, attributes);
      return;
    }
    this->Maps.push_back(this->Maps.back() * vtkHapticSVGPath::ParseTransform(ValueOf(attributes, "transform")));
    if (this->Hidden > 0 || IsHidden(name, attributes))
    {
      ++this->Hidden;
      return;
    }
    if (IsLeftOut(name))
    {
      ++this->LeftOut[std::string(name)];
      return;
    }
    this->AddShape(name, attributes);
  }

  void OpenRoot(std::string_view name, const Attributes& attributes)
  {
    this->HasRoot = name == "svg";
    const std::vector<double> box = vtkHapticSVGPath::ParseNumbers(ValueOf(attributes, "viewBox"));
    if (!box.empty() && !(box.size() == 4 && box[2] > 0.0 && box[3] > 0.0))
    {
      throw std::runtime_error("its viewBox must be four numbers, the last two above 0");
    }
    // Without a viewBox a user unit is a pixel, of which drawings have about a thousand.
    const double diagonal = box.empty() ? 1000.0 : std::hypot(box[2], box[3]);
    this->Drawing.Tolerance = SharePerDiagonal * diagonal;
    this->Lines.SetTolerance(this->Drawing.Tolerance);
    this->Maps.push_back(UpwardsFrom(box.empty() ? 0.0 : 2.0 * box[1] + box[3]));
  }

  void AddShape(std::string_view name, const Attributes& attributes)
  {
    this->Lines.SetMap(this->Maps.back());
    if (!this->HasRoot || !AppendShape(name, attributes, this->Lines))
    {
      return;
    }
    std::vector<Line> lines = this->Lines.Take();
    const std::string_view id = ValueOf(attributes, "id");
    if (id == "start" || id == "exit")
    {
      (id == "start" ? this->Drawing.Start : this->Drawing.Exit) = CenterOf(lines);
      return;
    }
    std::move(lines.begin(), lines.end(), std::back_inserter(this->Drawing.Lines));
  }

  vtkHapticDrawing Drawing;
  vtkHapticPlaneLines Lines;
  std::vector<Eigen::Affine2d> Maps; // of the elements that are open
  std::size_t Hidden = 0;            // how many of them are hidden or in a hidden one
  bool HasRoot = false;
  std::map<std::string, int> Elements; // met so far, by name
  std::string Last;                    // the last of them, as a person counts
  std::map<std::string, int> LeftOut;
};

vtkStandardNewMacro(vtkHapticSVGElements);

vtkHapticDrawing vtkHapticParseSVG(std::string_view content)
{
  vtkHapticDrawing drawing;
  if (content.size() > std::numeric_limits<unsigned int>::max())
  {
    drawing.Problem = "it is longer than 4 GB";
    return drawing;
  }
  vtkNew<vtkHapticSVGElements> elements;
  elements->Parse(content.data(), static_cast<unsigned int>(content.size()));
  return elements->TakeDrawing();
}
