// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/map/FrameMap.h"

namespace palpate
{

SurfaceMap followFrames(const std::vector<Vec3>& origins_W, const std::vector<Vec3>& points_W,
  const std::vector<std::vector<FrameWeight>>& weights)
{
  SurfaceMap map;
  for (std::size_t p = 0; p < points_W.size(); ++p)
  {
    NodeBlocks blocks;
    for (const auto& [frame, weight] : weights[p])
    {
      const Vec3 arm = points_W[p] - origins_W[frame];
      Mat3 turned;
      turned << 0.0, arm.z(), -arm.y(), -arm.z(), 0.0, arm.x(), arm.y(), -arm.x(), 0.0; // turn x arm
      blocks.nodes.insert(blocks.nodes.end(), { 2 * frame, 2 * frame + 1 });
      blocks.blocks.insert(blocks.blocks.end(), { weight * Mat3::Identity(), weight * turned });
    }
    map.add(blocks);
  }
  return map;
}

SurfaceMap followNodes(const std::vector<std::uint32_t>& nodes)
{
  SurfaceMap map;
  for (const std::uint32_t node : nodes)
  {
    map.add({ { node }, { Mat3::Identity() } });
  }
  return map;
}

} // namespace palpate
