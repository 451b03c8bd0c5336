// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/scene/BuiltScene.h"

#include <cmath>
#include <sstream>

#include "haptics/contact/view/PlanFor.h"
#include "haptics/core/PoseMath.h"

namespace palpate
{
namespace
{

std::string describeTubes(const SurfaceTree& tree, const Scene& scene)
{
  std::ostringstream text;
  text << "segment is touched as a tube of " << tree.coat_u() << " u, by a point as by a ball of "
       << planFor(scene, {}).radius_u << " u";
  return text.str();
}

std::string describe(const SurfaceReport& surface, const SurfaceTree& tree, const Scene& scene, const std::string& note)
{
  constexpr std::size_t kibibyte = 1024;
  return surface.name + ": " + surface.summary() + "; every kept " +
         (surface.clean.segments ? describeTubes(tree, scene) : "triangle is touched") + ", through a tree of " +
         std::to_string(tree.bytes() / kibibyte) + " KiB" + (surface.refitted ? ", refitted" : "") +
         (note.empty() ? "" : "; material: " + note) + "\n";
}

std::optional<Pose> onePlane(const Pose& a_WP, const Pose& b_WP, double size_u)
{
  constexpr double rounding = 1e-6; // of data in single precision
  const Vec3 a = a_WP.q * Vec3::UnitZ(), b = b_WP.q * Vec3::UnitZ();
  const bool same = a.cross(b).norm() <= rounding && std::fabs(a.dot(b_WP.p - a_WP.p)) <= rounding * size_u;
  return same ? std::optional(a_WP) : std::nullopt;
}

} // namespace

std::vector<SurfaceInput> inputsOf(const std::vector<SceneSurface>& surfaces)
{
  std::vector<SurfaceInput> inputs;
  for (const SceneSurface& surface : surfaces)
  {
    inputs.push_back(surface.input);
  }
  return inputs;
}

namespace
{
/// The message about a damaged surface that is felt without a part of it.
std::string damageOf(const SurfaceReport& report)
{
  const CleanReport& clean = report.clean;
  return clean.nonFinite == 0 ? ""
                              : report.name + ": " + std::to_string(clean.nonFinite) + " of " +
                                  std::to_string(clean.trianglesIn) + (clean.segments ? " segments" : " triangles") +
                                  " are left out, as they have coordinates that are not numbers (NaN or infinite)";
}

void takeFirst(std::string& kept, const std::string& next)
{
  kept = kept.empty() ? next : kept;
}
} // namespace

BuiltScene buildScene(
  SceneBuilder& builder, const std::vector<SceneSurface>& surfaces, const Scene* felt, BuildWatch* watch)
{
  const SceneBuildResult built = builder.build(inputsOf(surfaces), felt, watch);
  BuiltScene result;
  result.scene = built.scene;
  for (std::size_t i = 0; i < built.reports.size(); ++i)
  {
    const SurfaceReport& report = built.reports[i];
    if (!report.refusal.empty())
    {
      result.report += report.name + ": refused: " + report.refusal + "\n";
      takeFirst(result.refused, result.scene ? "" : report.name + ": " + report.refusal);
      continue;
    }
    takeFirst(result.damaged, damageOf(report));
    const std::size_t place = result.traits.deforms.size(); // refused surfaces are not in the scene
    result.report += describe(report, *built.scene->surfaces()[place].tree, *built.scene, surfaces[i].materialNote);
    result.traits.deforms.push_back(report.refitted);
    result.traits.walls_WP.push_back(surfaces[i].plane_WP);
  }
  if (built.scene)
  {
    const Box& box = built.scene->surfaceTree().bounds;
    const Vec3 &low_W = box.low_W, &high_W = box.high_W;
    result.bounds = { low_W.x(), high_W.x(), low_W.y(), high_W.y(), low_W.z(), high_W.z() };
  }
  return result;
}

std::optional<Pose> commonPlane(const std::vector<SceneSurface>& surfaces)
{
  std::optional<Pose> all_WP;
  for (const SceneSurface& surface : surfaces)
  {
    if (!surface.plane_WP)
    {
      return std::nullopt;
    }
    const Pose one = surface.input.pose_WS * *surface.plane_WP;
    const double size_u = surface.input.mesh->vertices_W.front().cwiseAbs().maxCoeff();
    all_WP = all_WP ? onePlane(*all_WP, one, size_u) : one;
    if (!all_WP)
    {
      return std::nullopt;
    }
  }
  return all_WP;
}

} // namespace palpate
