// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/SceneSimplifier.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{

double limitOf(const TouchConditions& touch)
{
  ScenePlan plan;
  plan.conditions = touch;
  return plan.unnoticed_u();
}

std::string reasonToKeep(const Surface& surface, bool deforms, const SimplifyRules& rules)
{
  if (surface.tree->coat_u() > 0.0)
  {
    return "curves are touched as they are";
  }
  if (deforms || surface.motion.moves())
  {
    return "what moves or deforms is touched as it is";
  }
  if (surface.fields && !surface.fields->empty())
  {
    return "its material comes from arrays";
  }
  if (surface.tree->mesh().triangles.size() < rules.leastTriangles)
  {
    return "simpler surfaces pay from " + std::to_string(rules.leastTriangles) + " triangles on";
  }
  return {};
}

} // namespace

std::vector<SurfaceChoice> chooseAtFirst(
  const Scene& full, const std::vector<bool>& deforms, const SimplifyRules& rules)
{
  std::vector<SurfaceChoice> choices;
  for (const Surface& surface : full.surfaces())
  {
    const std::size_t triangles = surface.tree->mesh().triangles.size();
    const bool moved = choices.size() < deforms.size() && deforms[choices.size()];
    choices.push_back({ surface.name, triangles, triangles, 0.0, reasonToKeep(surface, full.moves() || moved, rules) });
  }
  return choices;
}

const SceneSimplifier::Kept* SceneSimplifier::find(const SurfaceTree* tree, const SimplifyRules& rules) const
{
  const auto same = [&](const Kept& kept) { return kept.tree.get() == tree && kept.limit_u == limitOf(rules.touch); };
  const auto found = std::find_if(this->kept_.begin(), this->kept_.end(), same);
  return found != this->kept_.end() ? &*found : nullptr;
}

SceneSimplifier::Kept SceneSimplifier::look(
  const std::shared_ptr<const SurfaceTree>& tree, const SimplifyRules& rules) const
{
  const ScenePlan plan = planTouch(*tree, rules.touch);
  Kept found{ tree, plan.unnoticed_u(), {} };
  if (plan.trianglesNeeded > plan.triangles / 2)
  {
    found.fewer.refusal = "its facets are no finer than a hand feels";
    return found;
  }
  found.fewer = simplifyWithin(*tree, { plan.unnoticed_u(), rules.stop, {} });
  return found;
}

bool SceneSimplifier::knows(
  const Scene& full, const std::vector<SurfaceChoice>& choices, const SimplifyRules& rules) const
{
  for (std::size_t i = 0; i < choices.size(); ++i)
  {
    if (choices[i].reason.empty() && this->find(full.surfaces()[i].tree.get(), rules) == nullptr)
    {
      return false;
    }
  }
  return true;
}

SimplerScene SceneSimplifier::simplify(
  const Scene& full, std::vector<SurfaceChoice> choices, const SimplifyRules& rules, std::uint64_t revision)
{
  std::vector<Kept> kept;
  std::vector<Surface> surfaces = full.surfaces();
  bool simpler = false;
  for (std::size_t i = 0; i < surfaces.size() && !rules.stop.stop_requested(); ++i)
  {
    if (!choices[i].reason.empty())
    {
      continue;
    }
    const Kept* const known = this->find(surfaces[i].tree.get(), rules);
    kept.push_back(known != nullptr ? *known : this->look(surfaces[i].tree, rules));
    const Simplification& fewer = kept.back().fewer;
    choices[i].reason = fewer.refusal;
    if (fewer.tree)
    {
      choices[i].felt = fewer.tree->mesh().triangles.size();
      choices[i].bound_u = fewer.bound_u;
      surfaces[i].tree = fewer.tree;
      simpler = true;
    }
  }
  if (rules.stop.stop_requested()) // what was given up has no answer to keep
  {
    return {};
  }
  this->kept_ = std::move(kept);
  return { simpler ? std::make_shared<const Scene>(revision, std::move(surfaces)) : nullptr, std::move(choices) };
}

} // namespace palpate
