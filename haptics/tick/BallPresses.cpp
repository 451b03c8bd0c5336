// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/BallPresses.h"

#include <algorithm>

#include "haptics/contact/planes/FeatureGeometry.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{
namespace
{

static_assert(std::tuple_size_v<decltype(ContactResult::held)> <= ToolPress::most);

/// Planes that hold a ball at x, where the ball is felt at the proxy.
template<SceneView AnyScene>
void tellIn(
  const AnyScene& scene, const ContactResult& result, const Vec3& x_W, double radius_u, ToolState& tool) noexcept
{
  tool.active = result.heldCount;
  for (int i = 0; i < result.heldCount; ++i)
  {
    const ActivePlane& held = result.held[i];
    const FeaturePlane plane = planeOf(surfaceOf(scene, held.feature.surface), held.feature, x_W, radius_u);
    tool.presses[i] = { plane.foot_W + result.proxy_W - x_W, plane.n, held.depth_u, i };
  }
}

/// A scene with a soft body has its free surface, and the ball among that: each contact has gone on by as much as it
/// yielded. Those that push hardest.
void tellYielding(const SoftState& soft, double coupling_N_per_u, ToolState& tool) noexcept
{
  std::array<ToolPress, GodObjectState::maxFeatures> all{};
  const auto harder = [](const ToolPress& one, const ToolPress& other) { return one.push_u > other.push_u; };
  int count = 0;
  for (int c = 0; c < soft.count; ++c)
  {
    const SoftContact& contact = soft.contacts[c];
    const double push_u = contact.n.dot(contact.force_N) / coupling_N_per_u;
    if (push_u > 0.0)
    {
      all[count++] = { contact.foot_W + contact.yielded_W + soft.offset_W, contact.n, push_u, c };
    }
  }
  tool.active = std::min(count, ToolPress::most);
  std::partial_sort(all.begin(), all.begin() + tool.active, all.begin() + count, harder);
  std::copy_n(all.begin(), tool.active, tool.presses.begin());
}

bool yields(const ProxyTick& tick, const SoftState& soft) noexcept
{
  return tick.input.body != nullptr && std::any_of(soft.contacts.begin(), soft.contacts.begin() + soft.count,
                                         [](const SoftContact& contact) { return contact.gives; });
}

} // namespace

void tellPresses(
  const ProxyTick& tick, const ContactResult& result, const RendererState& state, ToolState& tool) noexcept
{
  if (!tick.touches)
  {
    return;
  }
  if (yields(tick, state.soft))
  {
    tellYielding(state.soft, tick.plan.coupling_N_per_m / state.map.scale_u_per_m, tool);
    return;
  }
  const Scene& scene = *tick.input.scene;
  const Vec3& x_W = tick.input.body != nullptr ? state.contact.x_W : result.proxy_W;
  if (scene.moves())
  {
    tellIn(MovingScene(scene, scene.shareAt(tick.step.age_s)), result, x_W, state.radius_u, tool);
  }
  else
  {
    tellIn(scene, result, x_W, state.radius_u, tool);
  }
}

} // namespace palpate
