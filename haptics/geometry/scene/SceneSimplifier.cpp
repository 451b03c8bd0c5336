// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/scene/SceneSimplifier.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "haptics/geometry/simplify/CoarserSurface.h"

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

/// Triangles, or segments of curves.
std::size_t countOf(const SurfaceTree& tree, const SurfaceChoice& choice)
{
  return tree.mesh().triangles.size() / (choice.wall_WP ? 2 : 1);
}

std::string reasonToKeepCurves(
  const SurfaceTree& curves, const std::optional<Pose>& wall_WP, const SimplifyRules& rules)
{
  if (hasFineLines(curves, wall_WP, { rules.fineBelow_u(), rules.leastFine }))
  {
    return {};
  }
  std::ostringstream reason;
  reason.precision(3);
  reason << "coarser lines are worthwhile from " << rules.leastFine << " segments shorter than " << rules.fineBelow_u()
         << " u on";
  return reason.str();
}

std::string reasonToKeep(const Surface& surface, const SurfaceChoice& choice, bool deforms, const SimplifyRules& rules)
{
  if (deforms || surface.motion.moves())
  {
    return "moving and deforming surfaces are not simplified";
  }
  if (surface.fields && !surface.fields->empty())
  {
    return "its material comes from arrays";
  }
  if (choice.curves)
  {
    return reasonToKeepCurves(*surface.tree, choice.wall_WP, rules);
  }
  if (surface.tree->mesh().triangles.size() < rules.leastTriangles)
  {
    return "simpler surfaces are worthwhile from " + std::to_string(rules.leastTriangles) + " triangles on";
  }
  return {};
}

} // namespace

std::vector<SurfaceChoice> chooseAtFirst(const Scene& full, const SurfaceTraits& traits, const SimplifyRules& rules)
{
  std::vector<SurfaceChoice> choices;
  for (const Surface& surface : full.surfaces())
  {
    const std::size_t i = choices.size();
    SurfaceChoice choice;
    choice.name = surface.name;
    choice.wall_WP = i < traits.walls_WP.size() ? traits.walls_WP[i] : std::nullopt;
    choice.curves = choice.wall_WP || surface.tree->coat_u() > 0.0;
    choice.triangles = choice.felt = countOf(*surface.tree, choice);
    const bool moved = i < traits.deforms.size() && traits.deforms[i];
    choice.reason = reasonToKeep(surface, choice, full.moves() || moved, rules);
    choices.push_back(std::move(choice));
  }
  return choices;
}

const SceneSimplifier::Kept* SceneSimplifier::find(const SurfaceTree* tree, const SimplifyRules& rules) const
{
  const auto same = [&](const Kept& kept)
  { return kept.tree.get() == tree && kept.limit_u == limitOf(rules.touch) && kept.leastFine == rules.leastFine; };
  const auto found = std::find_if(this->kept_.begin(), this->kept_.end(), same);
  return found != this->kept_.end() ? &*found : nullptr;
}

SceneSimplifier::Kept SceneSimplifier::look(
  const std::shared_ptr<const SurfaceTree>& tree, const SurfaceChoice& choice, const SimplifyRules& rules)
{
  Kept found{ tree, limitOf(rules.touch), rules.leastFine, {} };
  if (choice.curves)
  {
    const std::size_t leastGone = std::max<std::size_t>(1, rules.leastFine);
    found.fewer = coarserSurface(*tree, choice.wall_WP, leastGone, { found.limit_u, rules.stop, {} });
    return found;
  }
  const ScenePlan plan = planTouch(*tree, rules.touch);
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
    kept.push_back(known != nullptr ? *known : look(surfaces[i].tree, choices[i], rules));
    const Simplification& fewer = kept.back().fewer;
    choices[i].reason = fewer.refusal;
    if (fewer.tree)
    {
      choices[i].felt = countOf(*fewer.tree, choices[i]);
      choices[i].bound_u = fewer.bound_u;
      surfaces[i].standsFor = { surfaces[i].tree->contentHash(), fewer.bound_u };
      surfaces[i].tree = fewer.tree;
      simpler = true;
    }
  }
  if (rules.stop.stop_requested()) // an interrupted simplification has no result to keep
  {
    return {};
  }
  this->kept_ = std::move(kept);
  return { simpler ? std::make_shared<const Scene>(revision, std::move(surfaces)) : nullptr, std::move(choices) };
}

} // namespace palpate
