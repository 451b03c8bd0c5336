// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/labyrinth/Labyrinth.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace palpate
{
namespace
{

bool finite(const std::optional<Eigen::Vector2d>& place)
{
  return !place || place->allFinite();
}

bool onePoint(const CurveSet& curves)
{
  const Eigen::Vector2d& first_W = curves.points_W[curves.segments.front()[0]];
  return std::all_of(curves.segments.begin(), curves.segments.end(),
    [&](const auto& segment)
    { return curves.points_W[segment[0]] == first_W && curves.points_W[segment[1]] == first_W; });
}

std::string dot(const Eigen::Vector2d& p_W)
{
  std::ostringstream text;
  text << "all lines are a single point, (" << p_W.x() << ", " << p_W.y() << "): a line needs two points";
  return text.str();
}

} // namespace

std::string refuseWorld(const Labyrinth& labyrinth)
{
  const auto because = [&](const std::string& reason) { return labyrinth.name + ": " + reason; };
  if (labyrinth.curves.segments.empty())
  {
    return because("it has no lines");
  }
  const auto& points = labyrinth.curves.points_W;
  const bool linesFinite = std::all_of(points.begin(), points.end(), [](const auto& p) { return p.allFinite(); });
  if (!linesFinite || !finite(labyrinth.start_W) || !finite(labyrinth.exit_W))
  {
    return because("a point is not finite");
  }
  if (onePoint(labyrinth.curves))
  {
    return because(dot(points[labyrinth.curves.segments.front()[0]]));
  }
  if (!(labyrinth.corridor_u > 0.0 && std::isfinite(labyrinth.corridor_u)))
  {
    return because("the width of its corridors must be above zero");
  }
  return {};
}

std::string refuse(const Labyrinth& labyrinth)
{
  if (std::string problem = refuseWorld(labyrinth); !problem.empty())
  {
    return problem;
  }
  const auto because = [&](const char* reason) { return labyrinth.name + ": " + reason; };
  if (!labyrinth.start_W)
  {
    return because("no start (field array Start, id start in a drawing, a green spot in a picture): a structure to "
                   "explore, not a labyrinth");
  }
  if (!labyrinth.exit_W)
  {
    return because(
      "no exit (field array Exit, id exit in a drawing, a red spot in a picture): the labyrinth cannot be completed");
  }
  return {};
}

PlaneBox fence(const Labyrinth& labyrinth)
{
  const auto& points = labyrinth.curves.points_W;
  PlaneBox lines{ points.front(), points.front() };
  for (const Eigen::Vector2d& p : points)
  {
    lines.low_W = lines.low_W.cwiseMin(p);
    lines.high_W = lines.high_W.cwiseMax(p);
  }
  PlaneBox box = lines;
  for (const auto& place : { labyrinth.start_W, labyrinth.exit_W })
  {
    if (place)
    {
      box.low_W = box.low_W.cwiseMin(2.0 * *place - lines.low_W);
      box.high_W = box.high_W.cwiseMax(2.0 * *place - lines.high_W);
    }
  }
  return box;
}

CurveSet fenced(const Labyrinth& labyrinth)
{
  CurveSet curves = labyrinth.curves;
  const PlaneBox box = fence(labyrinth);
  const auto first = static_cast<std::uint32_t>(curves.points_W.size());
  curves.points_W.insert(curves.points_W.end(),
    { box.low_W, { box.high_W.x(), box.low_W.y() }, box.high_W, { box.low_W.x(), box.high_W.y() } });
  for (std::uint32_t i = 0; i < 4; ++i)
  {
    curves.segments.push_back({ first + i, first + (i + 1) % 4 });
  }
  return curves;
}

SurfaceInput wallsOf(const Labyrinth& labyrinth)
{
  const CurveSet curves = fenced(labyrinth);
  SurfaceInput input;
  input.name = labyrinth.name;
  input.mesh = std::make_shared<TriangleMesh>(raiseWalls(curves, wallHalfHeight(curves, labyrinth.radius_u())));
  return input;
}

WorkspaceMap fitted(const Labyrinth& labyrinth, double workspaceRadius_m)
{
  const PlaneBox box = fence(labyrinth);
  const Eigen::Vector2d middle_W = 0.5 * (box.low_W + box.high_W);
  WorkspaceMap map;
  map.scale_u_per_m = (box.high_W - box.low_W).maxCoeff() / (std::numbers::sqrt2 * workspaceRadius_m);
  map.offset_W = { middle_W.x(), middle_W.y(), 0.0 };
  return map;
}

} // namespace palpate
