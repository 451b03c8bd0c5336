// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/SurfacesBeside.h"

#include <algorithm>
#include <span>
#include <utility>

#include "haptics/core/PoseMath.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/mechanism/sided/SidedSurface.h"
#include "haptics/tool/servo/FrictionTarget.h"

namespace palpate
{
namespace
{

/// Where it stands; no tree with the reason.
RefitResult standing(const std::shared_ptr<const SurfaceTree>& tree, const Pose& pose_WS)
{
  if (pose_WS.p == Vec3::Zero() && pose_WS.q.coeffs() == Quat::Identity().coeffs())
  {
    return { tree, "" };
  }
  std::vector<Vec3> at_W = tree->mesh().vertices_W;
  std::ranges::transform(at_W, at_W.begin(), [&pose_WS](const Vec3& p) { return pose_WS * p; });
  return tree->refitted(std::move(at_W));
}

Outcome<std::shared_ptr<const SidedSurface>> bodyOf(const std::shared_ptr<const SurfaceTree>& tree, const Pose& pose_WS)
{
  RefitResult stands = standing(tree, pose_WS);
  return stands.tree ? makeStandingMesh(std::move(stands.tree))
                     : Outcome<std::shared_ptr<const SidedSurface>>{ nullptr, std::move(stands.refusal) };
}

} // namespace

SurfacesBeside::Source SurfacesBeside::Source::of(const Surface& surface)
{
  return { surface.name, surface.tree, surface.motion.end_WS,
    std::min(surface.material.frictionKinetic, largestToolFriction), surface.from != nullptr };
}

bool SurfacesBeside::Source::isSame(const Source& other) const noexcept
{
  return this->name == other.name && this->tree == other.tree && this->pose_WS.p == other.pose_WS.p &&
         this->pose_WS.q.coeffs() == other.pose_WS.q.coeffs() && this->friction == other.friction &&
         this->bends == other.bends;
}

bool SurfacesBeside::follow(const Scene* scene, const std::string& own)
{
  std::vector<Source> sources;
  for (const Surface& surface : scene ? std::span(scene->surfaces()) : std::span<const Surface>())
  {
    if (surface.name != own)
    {
      sources.push_back(Source::of(surface));
    }
  }
  const auto isSame = [](const Source& a, const Source& b) { return a.isSame(b); };
  if (std::ranges::equal(sources, this->sources_, isSame))
  {
    return false;
  }
  std::swap(sources, this->sources_);
  const std::vector<MechanismBody> before = std::exchange(this->bodies_, {});
  this->refused_ = this->reason_ = "";
  for (const Source& source : this->sources_)
  {
    // A mesh that was made is taken again where it stands as it stood.
    const auto was = std::ranges::find_if(sources, [&](const Source& s) { return s.isSame(source); });
    const auto place = static_cast<std::size_t>(was - sources.begin());
    this->take(source, place < before.size() ? before[place].mesh : nullptr);
    if (!this->reason_.empty())
    {
      this->refused_ = source.name;
      break;
    }
  }
  return true;
}

void SurfacesBeside::take(const Source& source, std::shared_ptr<const SidedSurface> known)
{
  if (source.bends || this->bodies_.size() == most)
  {
    this->reason_ = source.bends ? "it deforms"
                                 : "such a tool touches at most " + std::to_string(most) + " other surfaces, and " +
                                     std::to_string(this->sources_.size()) + " are there";
    return;
  }
  auto made =
    known ? Outcome<std::shared_ptr<const SidedSurface>>{ std::move(known), "" } : bodyOf(source.tree, source.pose_WS);
  this->reason_ = made.problem;
  if (made.ok())
  {
    MechanismBody body;
    body.name = source.name;
    body.mesh = std::move(made.value);
    body.friction = source.friction < 0.0 ? std::nullopt : std::optional(source.friction);
    this->bodies_.push_back(std::move(body));
  }
}

} // namespace palpate
