// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/SpherePlay.h"

#include <algorithm>

#include "haptics/contact/RadiusLimit.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"
#include "testing/support/RandomHand.h"

namespace palpate::test
{

SpherePlay playOn(const NoisySphere& sphere, const SphereGame& game)
{
  const double unit = sphere.unitsPerMillimetre(), radius_u = game.plan.radius_u;
  const Vec3 start_W = game.inside ? Vec3(Vec3::Zero()) : Vec3(radius_u + 60.0 * unit, 0.0, 0.0);
  Probe probe(sceneOf(sphere.mesh()), radius_u, start_W);
  probe.plan() = game.plan;
  RandomHand hand(sphere.mesh(), 2.0 * unit + 0.1 * radius_u, game.seed);
  hand.moveTo(start_W);
  SpherePlay play{ .cost = CostSample(game.ticks) };
  for (std::size_t i = 0; i < game.ticks; ++i)
  {
    const Vec3 p_W = hand.next();
    ContactResult result;
    play.cost.time([&] { result = probe.to(p_W); });
    play.overBudget += result.overBudget ? 1 : 0;
    play.touching += result.contacts > 0 ? 1 : 0;
    play.mostNodes = std::max(play.mostNodes, result.work);
  }
  return play;
}

ContactPlan fewPasses()
{
  constexpr std::uint32_t fewer = 16;
  ContactPlan plan;
  plan.passCap /= fewer;
  plan.workBudget /= fewer;
  return plan;
}

double radiusOfOneSweep_u(const Scene& scene, ContactPlan plan)
{
  plan.workBudget *= RadiusLimit::sweepsPerPass * plan.passCap;
  return radiusLimit(scene, plan).largest_u;
}

} // namespace palpate::test
