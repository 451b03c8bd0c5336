// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid tool by every method on every scene: how far it ends from the nearest free pose, how deep it was inside
// meanwhile, and the cost of an update.
#include <algorithm>
#include <cmath>

#include "testing/lab/Experiments.h"
#include "testing/lab/tools/ToolMethod.h"

namespace palpate::lab
{
namespace tool_methods_experiment
{

/// Error of the facets of a thread of 64 corners a turn and of 6 mm: r (1 - cos(pi / 64)).
constexpr double facets_mm = 0.0075;

/// No point of the tool is further from where it should be [mm].
double farthest_mm(const ToolScene& scene, const Pose& at_W)
{
  if (!scene.along_W.isZero())
  {
    return std::abs(scene.along_W.dot(at_W.p - scene.truth_W.p));
  }
  double most = 0.0;
  for (const Vec3& v_B : scene.tool_B.mesh.vertices_W)
  {
    most = std::max(most, (at_W.q * v_B + at_W.p - scene.truth_W.q * v_B - scene.truth_W.p).norm());
  }
  return most;
}

/// How deep a corner of one body is inside of the other [mm].
double deepest_mm(const ToolScene& scene, const Pose& at_W)
{
  double most = 0.0;
  for (const Vec3& v_B : scene.tool_B.mesh.vertices_W)
  {
    most = std::max(most, -scene.scene_W.distance_mm(at_W.q * v_B + at_W.p));
  }
  for (const Vec3& v_W : scene.scene_W.mesh.vertices_W)
  {
    most = std::max(most, -scene.tool_B.distance_mm(at_W.q.conjugate() * (v_W - at_W.p)));
  }
  return most;
}

void judge(const ToolScene& scene, const ToolMethodKind& kind, Table& table)
{
  test::CostSample cost(scene.hand_W.size());
  const auto method = kind.make(scene);
  double deep_mm = 0.0;
  for (const Pose& hand_W : scene.hand_W)
  {
    cost.time([&] { method->update(hand_W); });
    deep_mm = std::max(deep_mm, deepest_mm(scene, method->pose_W()));
  }
  const double error_mm = farthest_mm(scene, method->pose_W());
  const Subject error{ scene.name, kind.name, "pose error", "mm" }, inside{ scene.name, kind.name, "inside", "mm" };
  if (kind.name.starts_with("ours"))
  {
    table.atMost(error, error_mm, scene.near_mm).cost = Cost::of(cost);
    table.atMost(inside, deep_mm, facets_mm);
  }
  else
  {
    table.info(error, error_mm).cost = Cost::of(cost);
    table.info(inside, deep_mm);
  }
}

} // namespace tool_methods_experiment

void runToolMethods(const Conditions& conditions, Table& table)
{
  using namespace tool_methods_experiment;
  const std::vector<ToolScene> scenes = toolScenes();
  for (std::size_t i = 0; i < scenes.size(); ++i)
  {
    for (const ToolMethodKind& kind : toolMethods())
    {
      judge(scenes[i], kind, table);
    }
    conditions.progress((static_cast<double>(i) + 1) / static_cast<double>(scenes.size()));
  }
}

} // namespace palpate::lab
