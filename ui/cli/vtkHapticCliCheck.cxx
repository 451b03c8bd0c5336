// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliCommands.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>

#include "haptics/contact/view/PlanFor.h"
#include "haptics/geometry/scene/ScenePlan.h"
#include "haptics/geometry/scene/SceneSimplifier.h"
#include "haptics/session/PlanText.h"
#include "haptics/session/path/PathRunner.h"
#include "haptics/session/settings/AutoChoice.h"
#include "vtkHapticCliFaults.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticCliScene.h"
#include "vtkHapticJson.h"
#include "vtkHapticPathData.h"

namespace
{
struct Box
{
  palpate::Vec3 Low_W = palpate::Vec3::Constant(std::numeric_limits<double>::infinity());
  palpate::Vec3 High_W = palpate::Vec3::Constant(-std::numeric_limits<double>::infinity());
};

/// With the vertices that the triangles of a mesh use.
Box Grown(Box box, const palpate::TriangleMesh& mesh)
{
  for (const auto& triangle : mesh.triangles)
  {
    for (const std::uint32_t corner : triangle)
    {
      box.Low_W = box.Low_W.cwiseMin(mesh.vertices_W[corner]);
      box.High_W = box.High_W.cwiseMax(mesh.vertices_W[corner]);
    }
  }
  return box;
}

/// The touchable data of a file: its polygons, its lines as tubes, or its lines as walls.
struct Input
{
  std::vector<palpate::SurfaceInput> Surfaces;
  std::shared_ptr<const palpate::TriangleMesh> Lines; ///< those of the walls, if it is a plane world
  std::string Material;                               ///< a note

  void Add(
    const palpate::PathSurface& surface, const palpate::SettingStore& settings, const vtkHapticCliCheckOptions& options)
  {
    std::string problem;
    std::optional<palpate::SurfaceInput> input = palpate::sceneInput(surface, settings, problem);
    problem = !surface.materialProblem.empty() ? surface.name + ": " + surface.materialProblem : problem;
    if (!problem.empty())
    {
      throw vtkHapticCliProblem(options.Settings.Said(problem));
    }
    this->Material = surface.materialNote; // lines have the arrays of the polygons beside them
    this->Surfaces.push_back(std::move(*input));
  }
};

/// A file as it is touched, and as large as it is itself: lines have no height, the walls on them do.
struct Subject
{
  const palpate::Scene& Scene;
  Box Bounds;
  palpate::SurfaceTraits Traits;

  Subject(const palpate::Scene& scene, const palpate::TriangleMesh* lines) : Scene(scene)
  {
    if (lines)
    {
      this->Bounds = Grown(Box(), *lines);
      this->Traits.walls_WP = { palpate::Pose() };
      return;
    }
    for (const palpate::Surface& surface : scene.surfaces())
    {
      this->Bounds = Grown(this->Bounds, surface.tree->mesh());
    }
  }
  [[nodiscard]] const palpate::Surface& Surface() const { return this->Scene.surfaces().front(); }
};

std::size_t BytesOf(const palpate::Scene& scene)
{
  std::size_t bytes = 0;
  for (const palpate::Surface& surface : scene.surfaces())
  {
    bytes += surface.tree->bytes();
  }
  return bytes;
}

std::string WorkOf(const palpate::Scene& scene)
{
  return std::to_string((BytesOf(scene) + 1023) / 1024) + " KiB of boxes beside the mesh; a tick visits at most " +
         std::to_string(palpate::ContactPlan().workBudget) + " of them";
}

/// A file says nothing of a device, so the surface is taken to lie in the hand with its longest side 100 mm long.
palpate::ScenePlan TouchPlanOf(const Subject& subject)
{
  constexpr double InHand_m = 0.1;
  palpate::TouchConditions conditions;
  conditions.scale_u_per_m = (subject.Bounds.High_W - subject.Bounds.Low_W).maxCoeff() / InHand_m;
  return palpate::planTouch(*subject.Surface().tree, conditions);
}

/// A session's choice for this file.
struct Choice
{
  std::vector<palpate::SurfaceChoice> Surfaces;
  palpate::RadiusLimit Radius;
  std::string Sentence;
};

/// Before simpler surfaces were looked for or after it. Coarser lines always are: that takes no longer than to read
/// them.
std::vector<palpate::SurfaceChoice> SurfaceChoicesOf(const Subject& subject, bool simplify)
{
  palpate::SimplifyRules rules;
  rules.touch = TouchPlanOf(subject).conditions;
  if (simplify)
  {
    rules.leastTriangles = rules.leastFine = 0;
  }
  std::vector<palpate::SurfaceChoice> choices = palpate::chooseAtFirst(subject.Scene, subject.Traits, rules);
  for (palpate::SurfaceChoice& choice : choices)
  {
    if (!simplify && !choice.curves && choice.reason.empty())
    {
      choice.reason = "pass --simplify to look for a simpler surface";
    }
  }
  return palpate::SceneSimplifier().simplify(subject.Scene, choices, rules, 2).choices;
}

Choice ChoiceOf(const Subject& subject, const vtkHapticCliCheckOptions& options)
{
  const palpate::Scene& scene = subject.Scene;
  Choice choice;
  palpate::TouchChoice touch;
  touch.plan.radius_u = touch.asked_u = options.Settings.Number("Radius");
  choice.Surfaces = SurfaceChoicesOf(subject, options.Simplify);
  const palpate::ChosenBall ball = palpate::chooseBall(scene, touch.plan, !options.ForceRadius);
  choice.Radius = ball.limit;
  touch.largest_u = ball.limit.largest_u;
  touch.plan = ball.plan;
  touch.plan.friction = options.Settings.Friction();
  touch.plan = palpate::planFor(scene, touch.plan);
  touch.frictionFromData = palpate::hasOwnFriction(scene);
  choice.Sentence = palpate::planText(choice.Surfaces, touch);
  return choice;
}

nlohmann::ordered_json ToJson(const palpate::ScenePlan& plan)
{
  nlohmann::ordered_json json;
  json["scale_u_per_m"] = plan.conditions.scale_u_per_m;
  json["penetration_m"] = plan.conditions.penetration_m;
  json["stiffness_N_per_m"] = plan.conditions.stiffness_N_per_m;
  json["deviation_u"] = plan.deviation_u;
  json["deviation_m"] = plan.deviation_m;
  json["force_error"] = plan.forceError;
  json["felt"] = plan.felt;
  json["triangles_needed"] = plan.trianglesNeeded;
  json["sharp_edges"] = plan.sharpEdges;
  json["sentence"] = plan.sentence();
  return json;
}

nlohmann::ordered_json ToJson(const palpate::RadiusLimit& limit)
{
  nlohmann::ordered_json json;
  json["asked_u"] = limit.asked_u;
  json["largest_u"] = limit.largest_u; // null where no ball is too large
  json["kept"] = limit.kept();
  json["sentence"] = limit.sentence();
  return json;
}

nlohmann::ordered_json ToJson(const palpate::SurfaceChoice& surface)
{
  nlohmann::ordered_json json;
  json["triangles"] = surface.felt < surface.triangles ? surface.felt : 0;
  json["bound_u"] = surface.bound_u;
  json["refusal"] = surface.reason;
  return json;
}

std::string SentenceOf(const palpate::SurfaceChoice& surface)
{
  std::ostringstream text;
  if (surface.felt < surface.triangles)
  {
    text << surface.felt << (surface.curves ? " segments" : " triangles")
         << " feel the same, with a proven distance of at most " << surface.bound_u << " u between the two surfaces";
  }
  else
  {
    text << "no simpler surface: " << surface.reason;
  }
  return text.str();
}

void AddReport(nlohmann::ordered_json& json, const palpate::SurfaceReport& report)
{
  json["touchable"] = report.refusal.empty();
  json["refusal"] = report.refusal;
  json["triangles_in"] = report.clean.trianglesIn;
  json["triangles_out"] = report.clean.trianglesOut;
  json["vertices_out"] = report.clean.verticesOut;
  json["dropped"] = { { "non_finite", report.clean.nonFinite }, { "collinear", report.clean.collinear },
    { "duplicate", report.clean.duplicate } };
  json["boundary_edges"] = report.clean.boundaryEdges;
  json["non_manifold_edges"] = report.clean.nonManifoldEdges;
  json["hole_edges"] = report.holeEdges;
}

/// Of the first surface; `lines` beside it have their own report.
nlohmann::ordered_json ToJson(
  const vtkHapticCliCheckOptions& options, const Input& input, const std::vector<palpate::SurfaceReport>& reports)
{
  nlohmann::ordered_json json{ { "file", options.File } };
  AddReport(json, reports.front());
  if (reports.size() > 1)
  {
    AddReport(json["lines"], reports.back());
  }
  json["material"] = input.Material;
  json["plane_world"] = input.Lines != nullptr;
  json["tube_radius_u"] = input.Surfaces.back().lineRadius_u.value_or(0.0);
  return json;
}

void AddScene(nlohmann::ordered_json& json, const Subject& subject, const vtkHapticCliCheckOptions& options)
{
  const Choice choice = ChoiceOf(subject, options);
  const Box& box = subject.Bounds;
  json["low_u"] = { box.Low_W.x(), box.Low_W.y(), box.Low_W.z() };
  json["high_u"] = { box.High_W.x(), box.High_W.y(), box.High_W.z() };
  json["tree_bytes"] = BytesOf(subject.Scene);
  json["work"] = WorkOf(subject.Scene);
  json["choice"] = choice.Sentence;
  json["plan"] = ToJson(TouchPlanOf(subject));
  json["radius"] = ToJson(choice.Radius);
  if (options.Simplify)
  {
    json["simplified"] = ToJson(choice.Surfaces.front());
  }
}

void Print(const nlohmann::ordered_json& json)
{
  // a file name may hold bytes that are not UTF-8
  std::cout << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

/// How lines are touched, if there are any.
std::string WorldOf(const Input& input)
{
  std::ostringstream text;
  if (input.Lines)
  {
    text << "a plane world: " << input.Lines->triangles.size() << " segments in the plane z = 0, felt in that plane "
         << "(touch --two-d) as walls, of two triangles each, across it";
  }
  else if (const palpate::SurfaceInput& last = input.Surfaces.back(); last.lineRadius_u)
  {
    text << "curves in space: " << last.mesh->triangles.size() << " segments, touched as tubes of "
         << *last.lineRadius_u << " scene units";
  }
  return text.str();
}

void PrintLine(const char* title, const std::string& text)
{
  if (!text.empty())
  {
    std::cout << "  " << std::left << std::setw(10) << title << text << '\n';
  }
}

/// Of the polygons of a file; none of lines.
palpate::SurfaceFaults FaultsOf(const Input& input, const vtkHapticCliCheckOptions& options)
{
  const palpate::SurfaceInput& surface = input.Surfaces.front();
  return input.Lines || surface.lineRadius_u ? palpate::SurfaceFaults()
                                             : palpate::findFaults(*surface.mesh, options.Thin_u);
}

void Print(const vtkHapticCliCheckOptions& options, const Input& input, const Subject& subject,
  const std::vector<palpate::SurfaceReport>& reports)
{
  const Choice choice = ChoiceOf(subject, options);
  const palpate::Vec3 low_W = subject.Bounds.Low_W, size_u = subject.Bounds.High_W - low_W;
  std::ostringstream size;
  size << size_u.x() << " x " << size_u.y() << " x " << size_u.z() << " scene units, from (" << low_W.x() << ", "
       << low_W.y() << ", " << low_W.z() << ")";
  std::cout << options.File << ": it can be touched\n";
  for (const palpate::SurfaceReport& report : reports)
  {
    PrintLine("repaired", report.summary());
  }
  const palpate::SurfaceFaults faults = FaultsOf(input, options);
  PrintLine("holes", vtkHapticCliHoles(faults));
  PrintLine("flipped", vtkHapticCliFlipped(faults));
  PrintLine("thin", vtkHapticCliThin(faults));
  PrintLine("size", size.str());
  PrintLine("work", WorkOf(subject.Scene));
  PrintLine("felt", choice.Sentence);
  if (subject.Surface().tree->coat_u() == 0.0) // tubes have none
  {
    PrintLine("facets", "100 mm long in the hand and " + TouchPlanOf(subject).sentence());
  }
  PrintLine("material", input.Material);
  PrintLine("radius", choice.Radius.sentence());
  PrintLine("simpler", options.Simplify ? SentenceOf(choice.Surfaces.front()) : "");
  PrintLine("world", WorldOf(input));
}

Input Read(const vtkHapticCliCheckOptions& options)
{
  const std::string& file = options.File;
  palpate::SettingStore settings = options.Settings.Store();
  const vtkHapticMaterialSettings materials = vtkHapticMaterialsOf(settings);
  const std::vector<palpate::PathSurface> surfaces = vtkHapticCliReadSurface(file, options.Iso, materials, true);
  const bool tubes = settings.number("LineRadius") > 0.0;
  const bool walls = !tubes && std::ranges::all_of(surfaces, &palpate::PathSurface::curves);
  if (tubes && std::ranges::none_of(surfaces, &palpate::PathSurface::curves))
  {
    throw vtkHapticCliProblem(file + ": no lines; omit --line-radius");
  }
  if (walls && !materials.Empty())
  {
    throw vtkHapticCliProblem(file + ": lines as walls have no arrays of materials; omit these options, or " +
                              "make tubes of the lines (--line-radius)");
  }
  settings.put("LinesAsWalls", static_cast<double>(walls ? palpate::AutoChoice::On : palpate::AutoChoice::Off));
  Input input;
  for (const palpate::PathSurface& surface : surfaces)
  {
    if (tubes || walls || !surface.curves)
    {
      input.Add(surface, settings, options);
    }
  }
  input.Lines = walls ? surfaces.front().mesh : nullptr;
  return input;
}

/// A machine that asked for JSON gets JSON for a refusal as well.
Input ReadOrRefuse(const vtkHapticCliCheckOptions& options)
{
  try
  {
    return Read(options);
  }
  catch (const vtkHapticCliProblem& problem)
  {
    if (options.Json)
    {
      Print(nlohmann::ordered_json{ { "file", options.File }, { "touchable", false }, { "refusal", problem.what() } });
    }
    throw;
  }
}
} // namespace

int vtkHapticCliCheck(const vtkHapticCliCheckOptions& options)
{
  const Input input = ReadOrRefuse(options);
  const palpate::WholeScene built = palpate::wholeScene(input.Surfaces);
  if (options.Json)
  {
    nlohmann::ordered_json described = ToJson(options, input, built.reports);
    if (built.scene)
    {
      AddScene(described, { *built.scene, input.Lines.get() }, options);
      described["faults"] = vtkHapticCliToJson(FaultsOf(input, options), *input.Surfaces.front().mesh);
    }
    Print(described);
  }
  vtkHapticCliCheckWhole(built);
  if (!options.Json)
  {
    Print(options, input, { *built.scene, input.Lines.get() }, built.reports);
  }
  return 0;
}
