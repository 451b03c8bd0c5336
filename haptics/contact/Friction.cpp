// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/Friction.h"

#include "haptics/contact/ContactSet.h"

namespace palpate
{
namespace
{

/// Sum of mu l over the planes that hold: the radius of the disc in which the god-object may rest [u].
double reach(const ProjectionResult& held, double mu) noexcept
{
  double sum = 0.0;
  for (int k = 0; k < held.count; ++k)
  {
    sum += mu * held.lambda[static_cast<std::size_t>(k)];
  }
  return sum;
}

} // namespace

template<class SceneView>
FrictionVerdict judgeFriction(
  const SceneView& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state) noexcept
{
  FrictionVerdict verdict;
  verdict.pulled_W = p_W;
  ContactSet<SceneView> contacts(scene, plan.radius_u, state);
  contacts.include(p_W);
  contacts.relinearise();
  const ProjectionResult held = contacts.solve(p_W - state.x_W, contacts.lift());
  if (held.count == 0 || !held.feasible)
  {
    state.slips = false;
    return verdict;
  }
  const double behind = held.y.norm(); // |x0 - xf|
  const double kinetic = reach(held, plan.friction.kinetic);
  state.slips = behind > (state.slips ? kinetic : reach(held, plan.friction.statical));
  if (!state.slips)
  {
    verdict.motion = FrictionMotion::Sticks;
    verdict.contacts = held.count;
    return verdict;
  }
  verdict.motion = FrictionMotion::Slips;
  verdict.pulled_W = p_W - (kinetic / behind) * held.y;
  return verdict;
}

template FrictionVerdict judgeFriction(const Scene&, const ContactPlan&, const Vec3&, GodObjectState&) noexcept;
template FrictionVerdict judgeFriction(const MovingScene&, const ContactPlan&, const Vec3&, GodObjectState&) noexcept;

} // namespace palpate
