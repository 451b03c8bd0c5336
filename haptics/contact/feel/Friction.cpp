// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/feel/Friction.h"

#include "haptics/contact/feel/ContactMaterial.h"
#include "haptics/contact/planes/ContactSet.h"

namespace palpate
{
template<SceneView AnyScene>
FrictionReach reachOf(
  const AnyScene& scene, const ContactPlan& plan, ContactSet<AnyScene>& contacts, const ProjectionResult& held) noexcept
{
  FrictionReach reach;
  for (int k = 0; k < held.count; ++k)
  {
    const double depth = held.lambda[static_cast<std::size_t>(k)];
    const ActiveFeature& f = contacts.feature(held.active[static_cast<std::size_t>(k)]);
    const FrictionPlan friction =
      sceneOf(scene).hasMaterials() ? materialAt(scene, plan, f, contacts.plane(f).foot_W).friction : plan.friction;
    reach.statical += friction.statical * depth;
    reach.kinetic += friction.kinetic * depth;
  }
  return reach;
}

template<SceneView AnyScene>
FrictionVerdict judgeFriction(
  const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state) noexcept
{
  FrictionVerdict verdict;
  verdict.pulled_W = p_W;
  ContactSet<AnyScene> contacts(scene, plan.radius_u, state);
  contacts.include(p_W);
  contacts.relinearise();
  const ProjectionResult held = contacts.solve(p_W - state.x_W, contacts.lift());
  if (held.count == 0 || !held.feasible)
  {
    return verdict;
  }
  const double behind = held.y.norm(); // |x0 - xf|
  const FrictionReach reach = reachOf(scene, plan, contacts, held);
  constexpr double rounding = 1e-9; // of a slide: a hand that keeps still is not to slide for ever
  state.slips = behind > (state.slips ? (1.0 + rounding) * reach.kinetic : reach.statical);
  if (!state.slips)
  {
    verdict.motion = FrictionState::Sticks;
    verdict.contacts = listHeld(contacts, held, verdict.held);
    return verdict;
  }
  verdict.motion = FrictionState::Slips;
  verdict.pulled_W = p_W - (reach.kinetic / behind) * held.y;
  return verdict;
}

template FrictionReach reachOf(const Scene&, const ContactPlan&, ContactSet<Scene>&, const ProjectionResult&) noexcept;
template FrictionReach reachOf(
  const MovingScene&, const ContactPlan&, ContactSet<MovingScene>&, const ProjectionResult&) noexcept;
template FrictionVerdict judgeFriction(const Scene&, const ContactPlan&, const Vec3&, GodObjectState&) noexcept;
template FrictionVerdict judgeFriction(const MovingScene&, const ContactPlan&, const Vec3&, GodObjectState&) noexcept;

} // namespace palpate
