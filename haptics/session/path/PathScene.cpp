// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <sstream>
#include <thread>

#include "haptics/session/path/PathKind.h"
#include "haptics/session/scene/TouchedData.h"

namespace palpate
{
namespace
{

/// Stiffness per scene unit of the hand.
std::shared_ptr<const MaterialFields> perSceneUnit(
  const std::shared_ptr<const MaterialFields>& fields, double scale_u_per_m)
{
  if (!fields)
  {
    return nullptr;
  }
  auto scaled = std::make_shared<MaterialFields>(*fields);
  for (double& stiffness : scaled->stiffness_N_per_m)
  {
    stiffness /= scale_u_per_m;
  }
  return scaled;
}

/// An array that is in none of the data is a mistake of a person; in some of many it may be missing.
std::string refuseMaterials(const PathInputs& inputs)
{
  const bool all = std::ranges::all_of(inputs.surfaces, [](const auto& each) { return !each.materialProblem.empty(); });
  const PathSurface& first = inputs.surfaces.front();
  return all ? first.name + ": " + first.materialProblem : "";
}

/// A ramp ends at the coupling's stiffness.
void noteCoupling(const SettingStore& settings, PathReport& report)
{
  const std::vector<double>& felt = settings.of("StiffnessFeltRange").numbers;
  const double coupling_N_per_m = settings.number("Stiffness");
  if (!settings.text("StiffnessArray").empty() && std::max(felt[0], felt[1]) > coupling_N_per_m)
  {
    std::ostringstream text;
    text << "{StiffnessFeltRange}: at most " << coupling_N_per_m
         << " N/m is rendered, the stiffness of the coupling ({Stiffness})";
    report.notes.push_back(text.str());
  }
}

} // namespace

std::optional<SurfaceInput> sceneInput(const PathSurface& surface, const SettingStore& settings, std::string& refusal)
{
  const bool plane = areWalls(settings);
  SurfaceInput faces{ surface.name, surface.mesh, Material(), perSceneUnit(surface.fields, settings.number("Scale")) };
  faces.holeEdges = surface.holeEdges;
  if (!surface.curves)
  {
    refusal = plane ? surface.name + ": a plane world consists of lines, but these data have polygons; extract their "
                                     "edges or a slice (Feature Edges, Slice), or omit {LinesAsWalls}"
                    : "";
    return plane ? std::nullopt : std::optional(std::move(faces));
  }
  const TouchedLines lines{ surface.name, surface.mesh, faces.fields };
  LineSurface made =
    plane ? wallsAcross(lines, settings.number("Radius"), Pose()) : tubesOf(lines, settings.number("LineRadius"));
  if (!made.input)
  {
    refusal = surface.name + ": " + (plane ? "a plane world lies in the plane z = 0: " : "") + made.problem +
              (plane ? "; curves in space are touched as tubes ({LineRadius}, without {LinesAsWalls})" : "");
  }
  else if (plane)
  {
    made.input->name = surface.name; // all that is touched of it
  }
  return made.input;
}

std::vector<std::string> cleaningNotes(const std::vector<SurfaceReport>& reports)
{
  std::vector<std::string> notes;
  for (const SurfaceReport& each : reports)
  {
    if (each.clean.trianglesOut < each.clean.trianglesIn || !each.holeEdges.empty())
    {
      notes.push_back(each.name + ": " + each.summary());
    }
  }
  return notes;
}

std::shared_ptr<const Scene> pathScene(const PathInputs& inputs, PathReport& report)
{
  std::vector<SurfaceInput> surfaces;
  for (const PathSurface& each : inputs.surfaces)
  {
    const auto input = sceneInput(each, inputs.settings, report.refusal);
    if (!input)
    {
      return nullptr;
    }
    surfaces.push_back(*input);
  }
  const bool curves = std::ranges::any_of(inputs.surfaces, &PathSurface::curves);
  if (inputs.settings.number("LineRadius") > 0.0 && !curves)
  {
    report.refusal = inputs.surfaces.front().name + ": no lines; omit {LineRadius}";
    return nullptr;
  }
  report.refusal = refuseMaterials(inputs);
  const WholeScene whole =
    report.refusal.empty() ? wholeScene(surfaces, std::thread::hardware_concurrency()) : WholeScene{};
  if (!whole.refusal.empty())
  {
    report.refusal = whole.refused + ": cannot be touched: " + whole.refusal;
  }
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    if (const std::string& note = inputs.surfaces[i].materialNote; !note.empty())
    {
      report.remarks.push_back(surfaces[i].name + ": " + note);
    }
  }
  const std::vector<std::string> cleaned = cleaningNotes(whole.reports);
  report.remarks.insert(report.remarks.end(), cleaned.begin(), cleaned.end());
  noteCoupling(inputs.settings, report);
  return whole.scene;
}

} // namespace palpate
