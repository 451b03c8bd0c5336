// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "haptics/geometry/scene/Scene.h"
#include "haptics/mechanism/sided/SidedSurface.h"

namespace palpate
{

/// The surfaces that a tick keeps apart: that of the mesh in the hand first, in its frame, then those of the meshes
/// that stand, in W, in the plan's order, each with its outer side. Immutable.
class StandingMeshes
{
public:
  /// `surfaces`: at least two, plain ones at rest. `standing`: all but the first, with their sides.
  StandingMeshes(
    std::shared_ptr<const Scene> surfaces, std::vector<std::shared_ptr<const SidedSurface>> standing) noexcept
    : scene_(std::move(surfaces)), standing_(std::move(standing))
  {
  }

  /// As they are recorded.
  [[nodiscard]] const std::shared_ptr<const Scene>& scene() const noexcept { return this->scene_; }
  /// How many meshes stand.
  [[nodiscard]] int count() const noexcept { return static_cast<int>(this->standing_.size()); }
  [[nodiscard]] const SurfaceData& held() const noexcept { return this->scene_->surfaces().front().tree->data(); }
  /// One that stands, from 0 on.
  [[nodiscard]] const SidedSurface& standing(int mesh) const noexcept
  {
    return *this->standing_[static_cast<std::size_t>(mesh)];
  }
  /// Coulomb's coefficient of one that stands.
  [[nodiscard]] double friction(int mesh) const noexcept
  {
    return this->scene_->surfaces()[static_cast<std::size_t>(mesh) + 1].material.frictionKinetic;
  }

private:
  std::shared_ptr<const Scene> scene_;
  std::vector<std::shared_ptr<const SidedSurface>> standing_;
};

/// From the surfaces alone, as a recording has them. Not real-time safe.
[[nodiscard]] std::shared_ptr<const StandingMeshes> makeStandingMeshes(std::shared_ptr<const Scene> surfaces);

} // namespace palpate
