// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/plan/FittedMap.h"

#include "haptics/core/PoseMath.h"

namespace palpate
{
namespace
{

/// Empty where no surface has the name.
Eigen::AlignedBox3d boxOf(const Scene* scene, const std::string& name)
{
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; scene != nullptr && i < scene->surfaces().size(); ++i)
  {
    const Surface& surface = scene->surfaces()[i];
    for (std::size_t v = 0; surface.name == name && v < surface.tree->mesh().vertices_W.size(); ++v)
    {
      box.extend(surface.motion.end_WS * surface.tree->mesh().vertices_W[v]);
    }
  }
  return box;
}

} // namespace

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

std::string boundsOf(const Scene* scene, const std::vector<std::string>& names, std::array<double, 6>& bounds)
{
  Eigen::AlignedBox3d box;
  for (const std::string& name : names)
  {
    const Eigen::AlignedBox3d of = boxOf(scene, name);
    if (of.isEmpty())
    {
      return name;
    }
    box.extend(of);
  }
  const Vec3 &low_W = box.min(), &high_W = box.max();
  bounds = { low_W.x(), high_W.x(), low_W.y(), high_W.y(), low_W.z(), high_W.z() };
  return {};
}

bool isOfTouch(double committed_s, double begun_s)
{
  constexpr double moment_s = 1.0;
  return committed_s >= begun_s && committed_s - begun_s < moment_s;
}

} // namespace palpate
