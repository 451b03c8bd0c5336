// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid tool by every method on every scene: how far it ends from the nearest free pose, how deep it was inside
// meanwhile, and the cost of an update.
#include <algorithm>
#include <cmath>

#include "testing/lab/Experiments.h"
#include "testing/lab/Felt.h"
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

/// Error of the force of a virtual coupling, in steps that a hand can feel. Force is the coupling's stiffness times the
/// displacement from the hand to the tool, so stiffness cancels. A hand that is drawn by less than 1 mm is counted as
/// drawn by that: where nothing is to be felt the error is the force itself.
double errorOf_JND(const ToolScene& scene, const Pose& hand_W, double error_mm)
{
  constexpr double least_mm = 1.0;
  return error_mm / (forceJnd * std::max(least_mm, farthest_mm(scene, hand_W)));
}

/// Results of a tool that no hand takes for the right one.
Outcome outcomeOf(double error_JND, double inside_mm)
{
  constexpr double through_mm = 0.5;
  return inside_mm > through_mm ? Outcome::Through : error_JND > 1.0 ? Outcome::Wrong : Outcome::Held;
}

void judge(const ToolScene& scene, const ToolMethodKind& kind, Table& table)
{
  double deep_mm = 0.0;
  Pose end_W;
  const test::LeastCosts cost(costRuns,
    [&](auto call)
    {
      const auto method = kind.make(scene);
      for (const Pose& hand_W : scene.hand_W)
      {
        call([&] { method->update(hand_W); });
        deep_mm = std::max(deep_mm, deepest_mm(scene, method->pose_W()));
      }
      end_W = method->pose_W();
    });
  const double error_mm = farthest_mm(scene, end_W), error_JND = errorOf_JND(scene, scene.hand_W.back(), error_mm);
  const Subject pose{ scene.name, kind.name, "pose error", "mm" }, inside{ scene.name, kind.name, "inside", "mm" },
    error{ scene.name, kind.name, "error", "JND" }, outcome{ scene.name, kind.name, "outcome", outcomeUnit };
  const auto ended = static_cast<double>(outcomeOf(error_JND, deep_mm));
  if (kind.name.starts_with("ours"))
  {
    table.atMost(pose, error_mm, scene.near_mm);
    table.atMost(inside, deep_mm, facets_mm);
    table.atMost(error, error_JND, 1.0).cost = Cost::of(cost);
    table.atMost(outcome, ended, 0.0);
  }
  else
  {
    table.info(pose, error_mm);
    table.info(inside, deep_mm);
    table.info(error, error_JND).cost = Cost::of(cost);
    table.info(outcome, ended);
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
