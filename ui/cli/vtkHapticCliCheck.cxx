// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliCommands.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "haptics/contact/PlanFor.h"
#include "haptics/contact/RadiusLimit.h"
#include "haptics/geometry/ScenePlan.h"
#include "haptics/geometry/SceneSimplifier.h"
#include "haptics/session/PlanSentence.h"
#include "vtkHapticCliPlane.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticCliScene.h"

namespace
{
struct Box
{
  palpate::Vec3 Low_W;
  palpate::Vec3 High_W;
};

/// Of what its triangles use.
Box BoundsOf(const palpate::TriangleMesh& mesh)
{
  const palpate::Vec3& first_W = mesh.vertices_W[mesh.triangles.front().front()];
  Box box{ first_W, first_W };
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

/// A file as it is touched, and as large as it is itself: lines have no height, the walls on them do.
struct Subject
{
  const palpate::Scene& Scene;
  Box Bounds;
  palpate::SurfaceTraits Traits;

  Subject(const palpate::Scene& scene, const palpate::TriangleMesh* lines)
    : Scene(scene), Bounds(BoundsOf(lines ? *lines : this->Surface().tree->mesh()))
  {
    if (lines)
    {
      this->Traits.walls_WP = { palpate::Pose() };
    }
  }
  [[nodiscard]] const palpate::Surface& Surface() const { return this->Scene.surfaces().front(); }
};

std::string PlanOf(const palpate::Surface& surface)
{
  const palpate::ContactPlan plan;
  return "every kept triangle is touched as it is, through a tree of " +
         std::to_string((surface.tree->bytes() + 1023) / 1024) + " KiB beside the mesh; a tick visits at most " +
         std::to_string(plan.nodeBudget) + " nodes";
}

/// A file says nothing of a device, so the surface is taken to lie in the hand with its longest side 100 mm long.
palpate::ScenePlan TouchPlanOf(const Subject& subject)
{
  constexpr double InHand_m = 0.1;
  palpate::TouchConditions conditions;
  conditions.scale_u_per_m = (subject.Bounds.High_W - subject.Bounds.Low_W).maxCoeff() / InHand_m;
  return palpate::planTouch(*subject.Surface().tree, conditions);
}

/// What a session would choose for this file.
struct Choice
{
  palpate::SurfaceChoice Surface;
  palpate::RadiusLimit Radius;
  std::string Sentence;
};

/// A scene of one surface, before simpler surfaces were looked for or after it. Coarser lines always are: that takes
/// no longer than to read them.
palpate::SurfaceChoice SurfaceChoiceOf(const Subject& subject, bool simplify)
{
  palpate::SimplifyRules rules;
  rules.touch = TouchPlanOf(subject).conditions;
  if (simplify)
  {
    rules.leastTriangles = rules.leastFine = 0;
  }
  const std::vector<palpate::SurfaceChoice> atFirst = palpate::chooseAtFirst(subject.Scene, subject.Traits, rules);
  const bool look = simplify || atFirst.front().curves;
  return look ? palpate::SceneSimplifier().simplify(subject.Scene, atFirst, rules, 2).choices.front() : atFirst.front();
}

Choice ChoiceOf(const Subject& subject, const vtkHapticCliCheckOptions& options)
{
  const palpate::Scene& scene = subject.Scene;
  Choice choice;
  palpate::TouchChoice touch;
  touch.plan.radius_u = options.Radius_u;
  choice.Surface = SurfaceChoiceOf(subject, options.Simplify);
  choice.Radius = palpate::radiusLimit(scene, palpate::planFor(scene, touch.plan));
  touch.asked_u = options.Radius_u;
  touch.largest_u = choice.Radius.largest_u;
  touch.plan.radius_u = palpate::chosenRadius_u(touch.asked_u, touch.largest_u, !options.ForceRadius);
  touch.plan.friction = { options.MuStatic, options.MuKinetic.value_or(options.MuStatic) };
  touch.plan = palpate::planFor(scene, touch.plan);
  touch.frictionFromData = palpate::hasOwnFriction(scene);
  choice.Sentence = palpate::planSentence({ choice.Surface }, touch);
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
    text << surface.felt << (surface.curves ? " segments" : " triangles") << " feel the same, everywhere within "
         << surface.bound_u << " scene units, proven both ways";
  }
  else
  {
    text << "no simpler surface: " << surface.reason;
  }
  return text.str();
}

nlohmann::ordered_json ToJson(const palpate::SurfaceReport& report, const std::string& material)
{
  nlohmann::ordered_json json;
  json["file"] = report.name;
  json["touchable"] = report.refusal.empty();
  json["refusal"] = report.refusal;
  json["triangles_in"] = report.clean.trianglesIn;
  json["triangles_out"] = report.clean.trianglesOut;
  json["vertices_out"] = report.clean.verticesOut;
  json["dropped"] = { { "non_finite", report.clean.nonFinite }, { "collinear", report.clean.collinear },
    { "duplicate", report.clean.duplicate } };
  json["boundary_edges"] = report.clean.boundaryEdges;
  json["non_manifold_edges"] = report.clean.nonManifoldEdges;
  json["material"] = material;
  return json;
}

void AddScene(nlohmann::ordered_json& json, const Subject& subject, const vtkHapticCliCheckOptions& options)
{
  const Choice choice = ChoiceOf(subject, options);
  const palpate::Surface& surface = subject.Surface();
  const Box& box = subject.Bounds;
  json["low_u"] = { box.Low_W.x(), box.Low_W.y(), box.Low_W.z() };
  json["high_u"] = { box.High_W.x(), box.High_W.y(), box.High_W.z() };
  json["tree_bytes"] = surface.tree->bytes();
  json["tree"] = PlanOf(surface);
  json["choice"] = choice.Sentence;
  json["plan"] = ToJson(TouchPlanOf(subject));
  json["radius"] = ToJson(choice.Radius);
  if (options.Simplify)
  {
    json["simplified"] = ToJson(choice.Surface);
  }
}

void Print(const nlohmann::ordered_json& json)
{
  // a file name may hold bytes that are not UTF-8
  std::cout << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

void Print(const palpate::SurfaceReport& report, const Subject& subject, const std::string& material,
  const vtkHapticCliCheckOptions& options)
{
  const Choice choice = ChoiceOf(subject, options);
  const Box& box = subject.Bounds;
  const palpate::Vec3 size_u = box.High_W - box.Low_W;
  std::cout << report.name << ": it can be touched\n"
            << "  repaired  " << report.clean.summary() << '\n'
            << "  size      " << size_u.x() << " x " << size_u.y() << " x " << size_u.z() << " scene units, from ("
            << box.Low_W.x() << ", " << box.Low_W.y() << ", " << box.Low_W.z() << ")\n"
            << "  plan      " << PlanOf(subject.Surface()) << '\n'
            << "  felt      " << choice.Sentence << '\n'
            << "  facets    100 mm long in the hand and " << TouchPlanOf(subject).sentence() << '\n'
            << (material.empty() ? "" : "  material  " + material + '\n') << "  radius    " << choice.Radius.sentence()
            << '\n';
  if (options.Simplify)
  {
    std::cout << "  simpler   " << SentenceOf(choice.Surface) << '\n';
  }
}

/// A machine that asked for JSON gets JSON for a refusal as well.
vtkHapticCliSurface ReadOrRefuse(const vtkHapticCliCheckOptions& options)
{
  const std::string& file = options.File;
  try
  {
    vtkHapticCliSurface surface = vtkHapticCliReadSurface(file, options.Iso, options.Materials, true);
    if (!surface.Input.mesh)
    {
      if (!options.Materials.Empty())
      {
        throw vtkHapticCliProblem(file + ": lines are felt as they are, without arrays of materials; leave those out");
      }
      surface.Input = vtkHapticCliWallsOf(file, surface, options.Radius_u);
      return surface;
    }
    surface.Lines.reset(); // a surface with lines beside it is one with polygons
    if (!surface.Material.Problem.empty())
    {
      throw vtkHapticCliProblem(file + ": " + surface.Material.Problem);
    }
    return surface;
  }
  catch (const vtkHapticCliProblem& problem)
  {
    if (options.Json)
    {
      Print(nlohmann::ordered_json{ { "file", file }, { "touchable", false }, { "refusal", problem.what() } });
    }
    throw;
  }
}

std::string SentenceOfPlane(const vtkHapticCliSurface& surface)
{
  return "a plane world: " + std::to_string(surface.Lines->triangles.size()) +
         " segments in the plane z = 0, felt in that plane (touch --two-d) as walls, of two triangles each, across it";
}
} // namespace

int vtkHapticCliCheck(const vtkHapticCliCheckOptions& options)
{
  const vtkHapticCliSurface surface = ReadOrRefuse(options);
  const palpate::SceneBuildResult built = palpate::SceneBuilder().build({ surface.Input });
  const palpate::SurfaceReport& report = built.reports.front();
  if (options.Json)
  {
    nlohmann::ordered_json described = ToJson(report, surface.Material.Note);
    described["plane_world"] = surface.Lines != nullptr;
    if (built.scene)
    {
      AddScene(described, { *built.scene, surface.Lines.get() }, options);
    }
    Print(described);
  }
  if (!built.scene)
  {
    throw vtkHapticCliProblem(options.File + ": it cannot be touched: " + report.refusal);
  }
  if (!options.Json)
  {
    Print(report, { *built.scene, surface.Lines.get() }, surface.Material.Note, options);
    if (surface.Lines)
    {
      std::cout << "  world     " << SentenceOfPlane(surface) << '\n';
    }
  }
  return 0;
}
