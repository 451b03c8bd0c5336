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
RefitResult placed(const std::shared_ptr<const SurfaceTree>& tree, const Pose& pose_WS)
{
  if (pose_WS.p == Vec3::Zero() && pose_WS.q.coeffs() == Quat::Identity().coeffs())
  {
    return { tree, "" };
  }
  std::vector<Vec3> at_W = tree->mesh().vertices_W;
  std::ranges::transform(at_W, at_W.begin(), [&pose_WS](const Vec3& p) { return pose_WS * p; });
  return tree->refitted(std::move(at_W));
}

} // namespace

SurfacesBeside::Source SurfacesBeside::Source::of(const Surface& surface, const LooseSources& loose)
{
  const double* const density = loose.densityOf(surface.name);
  return { surface.name, surface.tree, surface.motion.end_WS,
    std::min(surface.material.frictionKinetic, largestToolFriction), surface.from != nullptr,
    density ? std::optional(LooseAs{ *density, loose.unit_m, loose.gravity_m_per_s2 }) : std::nullopt };
}

bool SurfacesBeside::Source::isSame(const Source& other) const noexcept
{
  return this->name == other.name && this->tree == other.tree && this->pose_WS.p == other.pose_WS.p &&
         this->pose_WS.q.coeffs() == other.pose_WS.q.coeffs() && this->friction == other.friction &&
         this->bends == other.bends && this->loose == other.loose;
}

bool SurfacesBeside::follow(const Scene* scene, const std::string& own, const LooseSources& loose)
{
  std::vector<Source> sources;
  for (const Surface& surface : scene ? std::span(scene->surfaces()) : std::span<const Surface>())
  {
    if (surface.name != own)
    {
      sources.push_back(Source::of(surface, loose));
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
  this->refusedLoose_ = false;
  for (const Source& source : this->sources_)
  {
    // A body that was made is taken again where it was to be as it is.
    const auto was = std::ranges::find_if(sources, [&](const Source& s) { return s.isSame(source); });
    const auto place = static_cast<std::size_t>(was - sources.begin());
    this->take(source, place < before.size() ? &before[place] : nullptr);
    if (!this->reason_.empty())
    {
      this->refused_ = source.name;
      this->refusedLoose_ = source.loose.has_value();
      break;
    }
  }
  return true;
}

SurfacesBeside::Made SurfacesBeside::standing(const Source& source)
{
  RefitResult stands = placed(source.tree, source.pose_WS);
  auto mesh = stands.tree ? makeStandingMesh(std::move(stands.tree))
                          : Outcome<std::shared_ptr<const SidedSurface>>{ nullptr, std::move(stands.refusal) };
  Made made;
  made.value.mesh = std::move(mesh.value);
  made.problem = std::move(mesh.problem);
  return made;
}

/// In its own frame, which then goes to its centre of mass.
SurfacesBeside::Made SurfacesBeside::loose(const Source& source)
{
  auto mesh = makeStandingMesh(source.tree); // which knows lines
  if (mesh.ok())
  {
    mesh = makeRigidMesh(source.tree->mesh());
  }
  Made made;
  made.problem = std::move(mesh.problem);
  if (made.ok())
  {
    MechanismBody& body = made.value;
    body.kind = MechanismBodyKind::Rigid;
    body.mesh = std::move(mesh.value);
    body.pose_W = source.pose_WS;
    const MassGiven given = giveMass(body, source.loose->density_kg_per_m3, source.loose->unit_m);
    made.problem = given.refusal.empty() ? "" : "its density " + given.refusal;
    body.load_W = body.mass.mass_Ns2_per_u / source.loose->unit_m * source.loose->gravity_m_per_s2;
  }
  return made;
}

void SurfacesBeside::take(const Source& source, const MechanismBody* known)
{
  if (source.bends || this->bodies_.size() == most)
  {
    this->reason_ = source.bends
                      ? "it deforms"
                      : "the hand then touches at most " + std::to_string(most) +
                          " surfaces, loose ones included, and " + std::to_string(this->sources_.size()) + " are there";
    return;
  }
  Made made = known ? Made{ *known, "" } : source.loose ? loose(source) : standing(source);
  this->reason_ = made.problem;
  if (made.ok())
  {
    made.value.name = source.name;
    made.value.friction = source.friction < 0.0 ? std::nullopt : std::optional(source.friction);
    this->bodies_.push_back(std::move(made.value));
  }
}

} // namespace palpate
