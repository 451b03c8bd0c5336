// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/SceneMotion.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{

bool sameSurface(const Surface& a, const Surface& b)
{
  return a.name == b.name && a.tree->contentHash() == b.tree->contentHash();
}

/// The surface in `now` that `surface` is, at the same place in the list if it can be; null if there is none.
const Surface* find(const std::vector<Surface>& now, const Surface& surface, std::size_t index)
{
  if (index < now.size() && sameSurface(now[index], surface))
  {
    return &now[index];
  }
  const auto found =
    std::find_if(now.begin(), now.end(), [&surface](const Surface& s) { return sameSurface(s, surface); });
  return found != now.end() ? &*found : nullptr;
}

} // namespace

std::shared_ptr<const Scene> movingFrom(
  const Scene& now, double share, const std::shared_ptr<const Scene>& next, double motion_s)
{
  if (!next || !(motion_s > 0.0) || !(now.moves() || next->moves()))
  {
    return next;
  }
  std::vector<Surface> surfaces = next->surfaces();
  bool moves = false;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    if (const Surface* const was = find(now.surfaces(), surfaces[i], i))
    {
      surfaces[i].motion.begin_WS = was->motion.at(share);
      moves = moves || surfaces[i].motion.moves();
    }
  }
  return moves ? std::make_shared<const Scene>(next->revision(), std::move(surfaces), motion_s) : next;
}

} // namespace palpate
