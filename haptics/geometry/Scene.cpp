// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/Scene.h"

#include <utility>

#include "haptics/core/WordHash.h"

namespace palpate
{
namespace
{

std::uint64_t hashSurfaces(const std::vector<Surface>& surfaces)
{
  WordHash hash;
  for (const Surface& surface : surfaces)
  {
    hash.add(surface.tree->contentHash());
    hash.add(surface.material.stiffnessFactor);
  }
  return hash.value();
}

} // namespace

Scene::Scene(std::uint64_t revision, std::vector<Surface> surfaces)
  : revision_(revision)
  , contentHash_(hashSurfaces(surfaces))
  , surfaces_(std::move(surfaces))
{
}

} // namespace palpate
