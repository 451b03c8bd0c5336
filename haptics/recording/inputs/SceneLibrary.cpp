// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/inputs/SceneLibrary.h"

#include <algorithm>
#include <utility>

#include "haptics/geometry/scene/SceneBuilder.h"

namespace palpate
{
namespace
{

/// Gives the tree of a surface the bounds of where its vertices come from. False if it cannot come from there.
bool letCome(Surface& surface, const std::shared_ptr<const VertexStart>& from)
{
  const VertexWay way{ from->hash, { &from->vertices_W } };
  surface.tree = surface.tree->refitted(surface.tree->mesh().vertices_W, nullptr, &way).tree;
  surface.from = from;
  return surface.tree != nullptr;
}

} // namespace

SceneLibrary::SceneLibrary(
  const input::Scenes::Recorded& recorded, const std::vector<std::shared_ptr<const Scene>>& given, unsigned workers)
{
  SceneBuilder builder(workers);
  for (const auto& scene : given)
  {
    this->scenes_[scene->geometryHash()] = scene;
  }
  for (const RecordedScene& one : recorded.scenes)
  {
    const auto scene = builder.build(one.surfaces).scene;
    if (scene && scene->geometryHash() == one.geometryHash)
    {
      this->scenes_[one.geometryHash] = scene;
    }
  }
  for (const RecordedMotion& motion : recorded.motions)
  {
    this->addMoving(motion);
  }
}

/// The meshes are there already: only where they are is new.
void SceneLibrary::addMoving(const RecordedMotion& recorded)
{
  const auto still = this->scenes_.find(recorded.geometryHash);
  if (still == this->scenes_.end() || still->second->surfaces().size() != recorded.motions.size() ||
      !std::all_of(recorded.motions.begin(), recorded.motions.end(), [](const RigidMotion& m) { return m.isRigid(); }))
  {
    return;
  }
  std::vector<Surface> surfaces = still->second->surfaces();
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    surfaces[i].motion = recorded.motions[i];
    if (recorded.starts[i] && !letCome(surfaces[i], recorded.starts[i]))
    {
      return;
    }
  }
  auto scene = std::make_shared<const Scene>(0, std::move(surfaces), recorded.motion_s);
  if (scene->contentHash() == recorded.contentHash)
  {
    this->scenes_[recorded.contentHash] = std::move(scene);
  }
}

std::shared_ptr<const Scene> SceneLibrary::find(std::uint64_t contentHash, std::uint64_t revision) const
{
  const auto found = this->scenes_.find(contentHash);
  return found == this->scenes_.end()
           ? nullptr
           : std::make_shared<const Scene>(revision, found->second->surfaces(), found->second->motion_s());
}

std::string input::Scenes::Replay::take(
  const RecordedName& name, const Recorded& /*recorded*/, const ReplayPlace& place)
{
  this->previous_ = std::move(this->scene_);
  this->taken_ = true;
  this->scene_ = name.sceneHash != 0 ? place.scenes.find(name.sceneHash, name.sceneRevision) : nullptr;
  return name.sceneHash == 0 || this->scene_ ? "" : SceneLibrary::missing;
}

} // namespace palpate
