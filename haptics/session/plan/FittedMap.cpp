// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/plan/FittedMap.h"

namespace palpate
{

WorkspaceMap fittedMap(WorkspaceMap map, const BuiltScene& scene, const DeviceInfo& device)
{
  const Vec3 low_W(scene.bounds[0], scene.bounds[2], scene.bounds[4]);
  const Vec3 high_W(scene.bounds[1], scene.bounds[3], scene.bounds[5]);
  const double half_u = 0.5 * (high_W - low_W).norm();
  map.scale_u_per_m = half_u / device.workspaceRadius_m.value;
  map.offset_W = 0.5 * (low_W + high_W);
  if (scene.plane_WP && device.abilities.sensedAxes == 2)
  {
    map.q_WD = scene.plane_WP->q;
  }
  return map;
}

bool isOfTouch(double committed_s, double begun_s)
{
  constexpr double moment_s = 1.0;
  return committed_s >= begun_s && committed_s - begun_s < moment_s;
}

} // namespace palpate
