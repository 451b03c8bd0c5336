// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliFaults.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <vector>

namespace
{
std::string FirstOf(const std::vector<std::uint32_t>& numbers)
{
  constexpr std::size_t shown = 8;
  std::ostringstream text;
  for (std::size_t i = 0; i < std::min(numbers.size(), shown); ++i)
  {
    text << (i > 0 ? " " : "") << numbers[i];
  }
  text << (numbers.size() > shown ? " ..." : "");
  return text.str();
}

std::set<std::uint32_t> PointsOf(const palpate::TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles)
{
  std::set<std::uint32_t> points;
  for (const std::uint32_t t : triangles)
  {
    points.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
  }
  return points;
}
} // namespace

nlohmann::ordered_json vtkHapticCliToJson(const palpate::SurfaceFaults& faults, const palpate::TriangleMesh& mesh)
{
  using Json = nlohmann::ordered_json;
  Json json{ { "holes", Json::array() }, { "flipped", Json::array() }, { "thin", Json::array() } };
  for (const palpate::SurfaceHole& hole : faults.holes)
  {
    json["holes"].push_back({ { "length_u", hole.length_u },
      { "centre_u", { hole.centre_W.x(), hole.centre_W.y(), hole.centre_W.z() } }, { "points", hole.vertices } });
  }
  for (const palpate::FlippedPart& part : faults.flipped)
  {
    json["flipped"].push_back({ { "triangles", part.triangles }, { "points", PointsOf(mesh, part.triangles) } });
  }
  for (const palpate::ThinPlace& place : faults.thin)
  {
    json["thin"].push_back({ { "thickness_u", place.thickness_u }, { "triangle", place.triangle },
      { "points", mesh.triangles[place.triangle] } });
  }
  return json;
}

std::string vtkHapticCliHoles(const palpate::SurfaceFaults& faults)
{
  if (faults.holes.empty())
  {
    return {};
  }
  const palpate::SurfaceHole& hole = faults.holes.front();
  std::ostringstream text;
  text << faults.holes.size() << "; the longest rim has " << hole.length_u << " scene units round ("
       << hole.centre_W.x() << ", " << hole.centre_W.y() << ", " << hole.centre_W.z() << "), points "
       << FirstOf(hole.vertices);
  return text.str();
}

std::string vtkHapticCliFlipped(const palpate::SurfaceFaults& faults)
{
  if (faults.flipped.empty())
  {
    return {};
  }
  const std::vector<std::uint32_t>& largest = faults.flipped.front().triangles;
  return std::to_string(faults.flipped.size()) + (faults.flipped.size() == 1 ? " part" : " parts") +
         "; the largest has " + std::to_string(largest.size()) + " triangles: " + FirstOf(largest);
}

std::string vtkHapticCliThin(const palpate::SurfaceFaults& faults)
{
  if (faults.thin.empty())
  {
    return {};
  }
  std::vector<std::uint32_t> triangles;
  for (const palpate::ThinPlace& place : faults.thin)
  {
    triangles.push_back(place.triangle);
  }
  std::ostringstream text;
  text << triangles.size() << " triangles have a thin wall behind them, the thinnest of "
       << faults.thin.front().thickness_u << " scene units: " << FirstOf(triangles);
  return text.str();
}
