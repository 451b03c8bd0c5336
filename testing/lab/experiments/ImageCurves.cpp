// SPDX-License-Identifier: GPL-3.0-or-later
// Row 49: the contour of a circle of radius R on pixels of size h = 1. Linear interpolation of r^2 - R^2 is off by
// t (1 - t) h^2 in r^2, so points by at most h^2 / (8 R); a chord through a pixel adds at most the sagitta of its
// diagonal, together h^2 / (4 R). The field r^2 - R^2 reaches both bounds, the distance r - R stays below.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "testing/lab/Experiments.h"
#include "testing/lab/Felt.h"
#include "testing/lab/backends/ImageContour.h"

namespace palpate::lab
{
namespace image_curves_experiment
{

using Field = PixelField;
using Curves = std::vector<std::vector<Vec3>>;

constexpr const char* ours = "image curves";
constexpr const char* stairs = "edges of pixels";

struct Circle
{
  double x, y, radius;

  [[nodiscard]] double off(double px, double py) const
  {
    return std::abs(std::hypot(px - this->x, py - this->y) - this->radius);
  }
  [[nodiscard]] int size() const { return static_cast<int>(2 * this->radius) + 8; }
};

struct Errors
{
  double vertex_u = 0.0, chord_u = 0.0;
  std::size_t points = 0;
};

void add(Errors& errors, const Curves& curves, const Circle& circle)
{
  for (const std::vector<Vec3>& curve : curves)
  {
    errors.points += curve.size();
    for (std::size_t i = 1; i < curve.size(); ++i)
    {
      errors.vertex_u = std::max(errors.vertex_u, circle.off(curve[i].x(), curve[i].y()));
      for (const double share : { 0.25, 0.5, 0.75 })
      {
        const Vec3 p = (1 - share) * curve[i - 1] + share * curve[i];
        errors.chord_u = std::max(errors.chord_u, circle.off(p.x(), p.y()));
      }
    }
  }
}

/// The lines between pixels inside of a circle and pixels outside of it.
Curves pixelEdges(const Circle& circle)
{
  const auto inside = [&](int x, int y) { return std::hypot(x - circle.x, y - circle.y) < circle.radius; };
  Curves edges;
  for (int y = 0; y + 1 < circle.size(); ++y)
  {
    for (int x = 0; x + 1 < circle.size(); ++x)
    {
      if (inside(x, y) != inside(x + 1, y))
      {
        edges.push_back({ { x + 0.5, y - 0.5, 0 }, { x + 0.5, y + 0.5, 0 } });
      }
      if (inside(x, y) != inside(x, y + 1))
      {
        edges.push_back({ { x - 0.5, y + 0.5, 0 }, { x + 0.5, y + 0.5, 0 } });
      }
    }
  }
  return edges;
}

/// The largest errors over circles with their centres in many places between the pixels.
template<class CurvesOf>
Errors worst(double radius, int places, CurvesOf curvesOf)
{
  Errors errors;
  for (int i = 0; i < places; ++i)
  {
    const double share = static_cast<double>(i) / places;
    const Circle circle{ radius + 3 + share, radius + 3 + 0.7 * share, radius };
    add(errors, curvesOf(circle), circle);
  }
  return errors;
}

Field squares(const Circle& c)
{
  return [c](double x, double y) { return (x - c.x) * (x - c.x) + (y - c.y) * (y - c.y) - c.radius * c.radius; };
}

Field distance(const Circle& c)
{
  return [c](double x, double y) { return std::hypot(x - c.x, y - c.y) - c.radius; };
}

void judgeContour(ImageContour contour, double radius, int places, Table& table)
{
  const double vertex_u = 1 / (8 * radius), chord_u = 1 / (4 * radius), share = 0.05;
  const std::string name = caseName({ { "radius", radius } });
  const Errors square = worst(radius, places, [&](const Circle& c) { return contour(c.size(), squares(c), 0.0); });
  table.within({ name + " field=squares", ours, "error of points", "h" }, square.vertex_u, vertex_u, share * vertex_u);
  table.within({ name + " field=squares", ours, "error of lines", "h" }, square.chord_u, chord_u, share * chord_u);
  const Errors linear = worst(radius, places, [&](const Circle& c) { return contour(c.size(), distance(c), 0.0); });
  table.atMost({ name + " field=distance", ours, "error of points", "h" }, linear.vertex_u, vertex_u);
  table.atMost({ name + " field=distance", ours, "error of lines", "h" }, linear.chord_u, chord_u);
}

/// As coarse as a hand does not feel: the least force over the stiffness, in pixels of a quarter millimetre.
void judgeSimplified(ImageContour contour, double radius, int places, Table& table)
{
  constexpr double stiffness_N_per_m = 500.0, pixel_m = 0.25e-3;
  const double tolerance_u = leastForce_N / stiffness_N_per_m / pixel_m;
  const std::string name = caseName({ { "radius", radius }, { "tolerance", tolerance_u } });
  const Errors whole = worst(radius, places, [&](const Circle& c) { return contour(c.size(), squares(c), 0.0); });
  const Errors felt =
    worst(radius, places, [&](const Circle& c) { return contour(c.size(), squares(c), tolerance_u); });
  table.atMost({ name, ours, "error of lines", "h" }, felt.chord_u, tolerance_u + whole.chord_u);
  // The contour has two or three points a pixel along the circle; n lines of a polygon are off by R (1 - cos(pi / n)),
  // and halving takes at most twice as many as it must.
  const double fewest = std::acos(-1.0) / std::acos(1.0 - tolerance_u / radius);
  table.atMost({ name, ours, "points over the fewest possible" }, felt.points / (places * fewest), 2.5);
}

/// Squares of a grid, each of another label than its neighbours: the same borders for 2 labels and for 160.
Field squaresOf(int labels)
{
  constexpr int side = 32;
  return [labels](double x, double y)
  { return static_cast<double>((7 * (static_cast<int>(x) / side) + 13 * (static_cast<int>(y) / side)) % labels); };
}

Field waves()
{
  return [](double x, double y) { return std::sin(x / 20) * std::sin(y / 20); };
}

/// Strokes of 6 pixels every 32, along both axes.
Field strokes()
{
  return [](double x, double y) { return std::fmod(x, 32) < 6 || std::fmod(y, 32) < 6 ? 0.0 : 1.0; };
}

/// A row for the cost of one run, judged by another of the same machine and minute.
void judgeCost(
  const std::string& name, const char* limit, double allowed, const Cost& cost, const Cost& other, Table& table)
{
  table.within({ name, ours, limit }, cost.p50_us <= allowed * other.p50_us, 1.0, 0.0).cost = cost;
}

/// Every pixel is looked at once, whatever the image is: so the cost is that of the pixels and of the lines among them,
/// and the work says how far it is.
void judgeRuns(ImageRunner runner, int size, Table& table)
{
  constexpr int fewerPixels = 4; // along each side
  constexpr double notMoreThan = 2.0, longestStep = 0.15;
  const std::pair<const char*, std::pair<ImageKind, Field>> runs[] = { { "contour", { ImageKind::Contour, waves() } },
    { "labels", { ImageKind::Labels, squaresOf(160) } }, { "drawing", { ImageKind::Drawing, strokes() } } };
  for (const auto& [kind, image] : runs)
  {
    const std::string name = caseName({ { "pixels", static_cast<double>(size) } }) + " " + kind;
    const ImageRun large = runner(image.first, size, image.second);
    const ImageRun small = runner(image.first, size / fewerPixels, image.second);
    judgeCost(name, "within twice the cost of 16 images of a sixteenth", notMoreThan * fewerPixels * fewerPixels,
      large.cost, small.cost, table);
    table.atMost({ name, ours, "longest step of progress" }, large.longestStep, longestStep);
  }
}

/// A walk for each label would cost 80 times as much.
void judgeLabels(ImageRunner runner, int size, Table& table)
{
  constexpr double notMoreThan = 2.0;
  const auto costOf = [&](int labels) { return runner(ImageKind::Labels, size, squaresOf(labels)).cost; };
  const auto [many, few] = test::costsInTurn([&] { return costOf(160); }, [&] { return costOf(2); });
  const std::string name = caseName({ { "pixels", static_cast<double>(size) }, { "labels", 160.0 } });
  judgeCost(name, "within twice the cost of 2 labels", notMoreThan, many, few, table);
}

} // namespace image_curves_experiment

void runImageCurves(const Conditions& conditions, Table& table)
{
  using namespace image_curves_experiment;
  const int places = conditions.pick(5, 20, 100);
  const ImageContour contour = imageContour();
  for (const double radius : { 10.0, 50.0, 200.0 })
  {
    const std::string name = caseName({ { "radius", radius } });
    if (contour)
    {
      judgeContour(contour, radius, places, table);
      judgeSimplified(contour, radius, places, table);
    }
    else
    {
      table.absent({ name, ours, "error of points", "h" });
    }
    table.atLeast({ name, stairs, "error of lines", "h" }, worst(radius, places, pixelEdges).chord_u, 0.5);
    conditions.progress(radius / 400.0);
  }
  if (const ImageRunner runner = imageRunner())
  {
    judgeRuns(runner, conditions.pick(1024, 4096, 4096), table);
    judgeLabels(runner, conditions.pick(512, 1024, 4096), table);
    conditions.progress(1.0);
  }
}

} // namespace palpate::lab
