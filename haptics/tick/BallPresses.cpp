// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/BallPresses.h"

#include "haptics/contact/planes/FeatureGeometry.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{
namespace
{

static_assert(std::tuple_size_v<decltype(ContactResult::held)> <= ToolPress::most);

template<SceneView AnyScene>
void tellIn(const AnyScene& scene, const ContactResult& result, double radius_u, ToolState& tool) noexcept
{
  tool.active = result.heldCount;
  for (int i = 0; i < result.heldCount; ++i)
  {
    const HeldPlane& held = result.held[i];
    const FeaturePlane plane = planeOf(surfaceOf(scene, held.feature.surface), held.feature, result.proxy_W, radius_u);
    tool.presses[i] = { plane.foot_W, plane.n, held.depth_u, i };
  }
}

} // namespace

void tellPresses(const ProxyTick& tick, const ContactResult& result, double radius_u, ToolState& tool) noexcept
{
  if (!tick.touches)
  {
    return;
  }
  const Scene& scene = *tick.input.scene;
  if (scene.moves())
  {
    tellIn(MovingScene(scene, scene.shareAt(tick.step.age_s)), result, radius_u, tool);
  }
  else
  {
    tellIn(scene, result, radius_u, tool);
  }
}

} // namespace palpate
