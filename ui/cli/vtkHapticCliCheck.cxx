// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliCommands.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "haptics/contact/PlanFor.h"
#include "haptics/contact/RadiusLimit.h"
#include "haptics/geometry/ScenePlan.h"
#include "haptics/geometry/Simplification.h"
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

Box BoundsOf(const palpate::TriangleMesh& mesh)
{
  Box box{ mesh.vertices_W.front(), mesh.vertices_W.front() };
  for (const palpate::Vec3& vertex : mesh.vertices_W)
  {
    box.Low_W = box.Low_W.cwiseMin(vertex);
    box.High_W = box.High_W.cwiseMax(vertex);
  }
  return box;
}

std::string PlanOf(const palpate::Surface& surface)
{
  const palpate::ContactPlan plan;
  return "every kept triangle is touched as it is, through a tree of " +
         std::to_string((surface.tree->bytes() + 1023) / 1024) + " KiB beside the mesh; a tick visits at most " +
         std::to_string(plan.nodeBudget) + " nodes";
}

/// A file says nothing of a device, so the surface is taken to lie in the hand with its longest side 100 mm long.
palpate::ScenePlan TouchPlanOf(const palpate::Surface& surface)
{
  constexpr double InHand_m = 0.1;
  const Box box = BoundsOf(surface.tree->mesh());
  palpate::TouchConditions conditions;
  conditions.scale_u_per_m = (box.High_W - box.Low_W).maxCoeff() / InHand_m;
  return palpate::planTouch(*surface.tree, conditions);
}

/// What a session says of this file before it has looked for simpler surfaces.
std::string ChoiceOf(const palpate::Scene& scene)
{
  return palpate::planSentence(palpate::chooseAtFirst(scene, {}, {}), palpate::planFor(scene, {}));
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

palpate::RadiusLimit RadiusLimitOf(const palpate::Scene& scene, double radius_u)
{
  palpate::ContactPlan plan;
  plan.radius_u = radius_u;
  return palpate::radiusLimit(scene, palpate::planFor(scene, plan));
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

palpate::Simplification SimplifiedOf(const palpate::Surface& surface)
{
  return palpate::simplifyWithin(*surface.tree, { TouchPlanOf(surface).unnoticed_u() });
}

nlohmann::ordered_json ToJson(const palpate::Simplification& fewer)
{
  nlohmann::ordered_json json;
  json["triangles"] = fewer.tree ? fewer.tree->mesh().triangles.size() : 0;
  json["bound_u"] = fewer.bound_u;
  json["refusal"] = fewer.refusal;
  return json;
}

std::string SentenceOf(const palpate::Simplification& fewer)
{
  std::ostringstream text;
  text << "for a comparison only: ";
  if (fewer.tree)
  {
    text << fewer.tree->mesh().triangles.size() << " triangles feel the same, everywhere within " << fewer.bound_u
         << " scene units, proven both ways";
  }
  else
  {
    text << "no simpler surface: " << fewer.refusal;
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

void AddScene(nlohmann::ordered_json& json, const palpate::Scene& scene)
{
  const palpate::Surface& surface = scene.surfaces().front();
  const Box box = BoundsOf(surface.tree->mesh());
  json["low_u"] = { box.Low_W.x(), box.Low_W.y(), box.Low_W.z() };
  json["high_u"] = { box.High_W.x(), box.High_W.y(), box.High_W.z() };
  json["tree_bytes"] = surface.tree->bytes();
  json["tree"] = PlanOf(surface);
  json["choice"] = ChoiceOf(scene);
  json["plan"] = ToJson(TouchPlanOf(surface));
}

void Print(const nlohmann::ordered_json& json)
{
  // a file name may hold bytes that are not UTF-8
  std::cout << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

void Print(const palpate::SurfaceReport& report, const palpate::Scene& scene, const std::string& material)
{
  const palpate::Surface& surface = scene.surfaces().front();
  const Box box = BoundsOf(surface.tree->mesh());
  const palpate::Vec3 size_u = box.High_W - box.Low_W;
  std::cout << report.name << ": it can be touched\n"
            << "  repaired  " << report.clean.summary() << '\n'
            << "  size      " << size_u.x() << " x " << size_u.y() << " x " << size_u.z() << " scene units, from ("
            << box.Low_W.x() << ", " << box.Low_W.y() << ", " << box.Low_W.z() << ")\n"
            << "  plan      " << PlanOf(surface) << '\n'
            << "  felt      " << ChoiceOf(scene) << '\n'
            << "  facets    100 mm long in the hand and " << TouchPlanOf(surface).sentence() << '\n'
            << (material.empty() ? "" : "  material  " + material + '\n');
}

/// A machine that asked for JSON gets JSON for a refusal as well.
vtkHapticCliSurface ReadOrRefuse(
  const std::string& file, std::optional<double> iso, const vtkHapticMaterialSettings& materials, bool json)
{
  try
  {
    vtkHapticCliSurface surface = vtkHapticCliReadSurface(file, iso, materials, true);
    if (!surface.Input.mesh)
    {
      surface.Input = vtkHapticCliWallsOf(file, surface, 0.0);
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
    if (json)
    {
      Print(nlohmann::ordered_json{ { "file", file }, { "touchable", false }, { "refusal", problem.what() } });
    }
    throw;
  }
}
} // namespace

namespace
{
std::string SentenceOfPlane(const vtkHapticCliSurface& surface)
{
  return "a plane world: " + std::to_string(surface.Lines->triangles.size()) +
         " segments in the plane z = 0, felt in that plane (touch --two-d) as walls, of two triangles each, across it";
}
} // namespace

int vtkHapticCliCheck(const std::string& file, std::optional<double> iso, const vtkHapticMaterialSettings& materials,
  bool simplify, double radius_u, bool json)
{
  const vtkHapticCliSurface surface = ReadOrRefuse(file, iso, materials, json);
  const palpate::SceneBuildResult built = palpate::SceneBuilder().build({ surface.Input });
  const palpate::SurfaceReport& report = built.reports.front();
  if (json)
  {
    nlohmann::ordered_json described = ToJson(report, surface.Material.Note);
    described["plane_world"] = surface.Lines != nullptr;
    if (built.scene)
    {
      AddScene(described, *built.scene);
      described["radius"] = ToJson(RadiusLimitOf(*built.scene, radius_u));
      if (simplify)
      {
        described["simplified"] = ToJson(SimplifiedOf(built.scene->surfaces().front()));
      }
    }
    Print(described);
  }
  if (!built.scene)
  {
    throw vtkHapticCliProblem(file + ": it cannot be touched: " + report.refusal);
  }
  if (!json)
  {
    Print(report, *built.scene, surface.Material.Note);
    if (surface.Lines)
    {
      std::cout << "  world     " << SentenceOfPlane(surface) << '\n';
    }
    std::cout << "  radius    " << RadiusLimitOf(*built.scene, radius_u).sentence() << '\n';
    if (simplify)
    {
      std::cout << "  simpler   " << SentenceOf(SimplifiedOf(built.scene->surfaces().front())) << '\n';
    }
  }
  return 0;
}
