// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/Scene.h"

#include <utility>

#include "haptics/core/WordHash.h"
#include "haptics/geometry/SurfaceData.h"

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

BoxTree treeOver(const std::vector<Surface>& surfaces)
{
  std::vector<Box> boxes;
  for (const Surface& surface : surfaces)
  {
    boxes.push_back({ surface.tree->data().low_W, surface.tree->data().high_W });
  }
  return makeBoxTree(boxes);
}

} // namespace

Scene::Scene(std::uint64_t revision, std::vector<Surface> surfaces)
  : revision_(revision)
  , contentHash_(hashSurfaces(surfaces))
  , surfaces_(std::move(surfaces))
  , surfaceTree_(treeOver(surfaces_))
{
}

} // namespace palpate
