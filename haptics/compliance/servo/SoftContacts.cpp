// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/servo/SoftContacts.h"

#include <algorithm>
#include <cmath>

#include "haptics/contact/planes/FeatureGeometry.h"
#include "haptics/geometry/mesh/TriangleWeights.h"

namespace palpate
{
namespace
{

/// Largest distance of a plane on which the ball rests, in patch radii: far more than rounding, too little to be felt.
constexpr double restsWithin = 1e-5;
/// Largest distance of an edge or vertex that carried force.
constexpr double rememberedWithin = 0.02;
/// A deeper overlap, again in patch radii, is more than rounding.
constexpr double sunkWithin = 1e-11;
/// Cosine above which two planes of one body are the same: planes of one flat face do not share a load.
constexpr double samePlane = 1.0 - 1e-12;
/// Cosine of ten degrees: within that angle a remembered contact would only be a duplicate.
constexpr double nearlySame = 0.984807753012208;

/// The touched point in the surface's own vertices.
template<class View>
SurfacePoint pointOf(const View& s, const ActiveFeature& f, const Vec3& foot_W) noexcept
{
  SurfacePoint p;
  p.x_W = foot_W;
  if (f.kind == FeatureKind::Face)
  {
    p.vertices = s.corners(f.a);
    const auto& [a, b, c] = s.cornersOf(f.a);
    p.weights = weightsOnTriangle(a, b, c, foot_W);
    return p;
  }
  p.vertices = { f.a, f.a, f.a };
  p.weights = Vec3::UnitX();
  if (f.kind == FeatureKind::Edge)
  {
    const Vec3 along = s.vertex(f.b) - s.vertex(f.a);
    const double share = std::clamp((foot_W - s.vertex(f.a)).dot(along) / along.squaredNorm(), 0.0, 1.0);
    p.vertices[1] = f.b;
    p.weights = Vec3(1.0 - share, share, 0.0);
  }
  return p;
}

const SoftSurfaceRef* softOf(std::span<const SoftSurfaceRef> soft, std::uint32_t surface) noexcept
{
  const auto found =
    std::find_if(soft.begin(), soft.end(), [surface](const SoftSurfaceRef& s) { return s.surface == surface; });
  return found != soft.end() ? &*found : nullptr;
}

bool differs(std::span<const SoftContact> contacts, const SoftContact& other, double cosine) noexcept
{
  return std::none_of(contacts.begin(), contacts.end(),
    [&other, cosine](const SoftContact& c)
    { return c.feature.surface == other.feature.surface && c.n.dot(other.n) > cosine; });
}

template<SceneView AnyScene>
SoftContact contactAt(const AnyScene& scene, std::span<const SoftSurfaceRef> soft, double radius_u,
  const ActiveFeature& f, const Vec3& x_W) noexcept
{
  decltype(auto) surface = surfaceOf(scene, f.surface);
  const FeaturePlane plane = planeOf(surface, f, x_W, radius_u);
  SoftContact contact;
  contact.feature = f;
  contact.n = plane.n;
  contact.foot_W = plane.foot_W;
  contact.overlap_u = radius_u - plane.n.dot(x_W - plane.foot_W);
  contact.soft = softOf(soft, f.surface);
  if (contact.soft)
  {
    const SurfacePoint at = pointOf(surface, f, plane.foot_W);
    contact.point = compliantPoint(*contact.soft->snapshot, at);
    contact.spring = springAt(*contact.soft->snapshot, at);
    contact.gives = contact.spring.hertz > 0.0 ||
                    complianceBetween(*contact.soft->snapshot, contact.point, contact.point).trace() > 0.0;
  }
  return contact;
}

/// The largest patch of the soft surfaces, the unit of distances.
double patchOf(std::span<const SoftSurfaceRef> soft) noexcept
{
  double patch_u = 0.0;
  for (const SoftSurfaceRef& s : soft)
  {
    patch_u = std::max(patch_u, s.snapshot->patchRadius_u.front());
  }
  return patch_u;
}

/// The contacts of one iteration, one after the other.
template<SceneView AnyScene>
class Gathering
{
public:
  Gathering(const AnyScene& scene, std::span<const SoftSurfaceRef> soft, double radius_u, SoftState& state) noexcept
    : scene_(scene), soft_(soft), radius_u_(radius_u), patch_u_(patchOf(soft)), state_(state), before_(state.contacts),
      beforeCount_(static_cast<std::size_t>(state.count))
  {
    state.count = 0;
  }

  /// Adds the features on which the core rests, unless a contact with nearly the same normal is there (`alike`).
  void addFound(double alike) noexcept
  {
    for (int i = 0; i < this->state_.core.count; ++i)
    {
      const SoftContact contact = this->at(this->state_.core.features[i]);
      if (contact.overlap_u > -restsWithin * this->patch_u_)
      {
        this->add(contact, alike);
      }
    }
  }

  /// Adds the contacts that carried force and are near.
  void addCarrying() noexcept
  {
    for (const SoftContact& old : this->before())
    {
      const bool face = old.feature.kind == FeatureKind::Face;
      if (old.force_N.squaredNorm() == 0.0)
      {
        continue;
      }
      const SoftContact contact = this->at(old.feature);
      // The core never penetrates a contact that is there: below a face's plane it is beside the face.
      const bool there = contact.overlap_u < sunkWithin * this->patch_u_;
      if (there && (face || contact.overlap_u > -rememberedWithin * this->patch_u_))
      {
        this->add(contact, face ? samePlane : nearlySame);
      }
    }
  }

  /// Keeps the forces with which the solver begins.
  void keepForces() noexcept
  {
    for (int i = 0; i < this->state_.count; ++i)
    {
      SoftContact& now = this->state_.contacts[i];
      for (const SoftContact& old : this->before())
      {
        if (old.feature.surface == now.feature.surface && old.n.dot(now.n) > nearlySame)
        {
          now.force_N = old.force_N;
        }
      }
    }
  }

private:
  [[nodiscard]] std::span<const SoftContact> before() const noexcept
  {
    return { this->before_.data(), this->beforeCount_ };
  }

  [[nodiscard]] SoftContact at(const ActiveFeature& feature) const noexcept
  {
    return contactAt(this->scene_, this->soft_, this->radius_u_, feature, this->state_.core.x_W);
  }

  void add(const SoftContact& contact, double alike) noexcept
  {
    const std::span<const SoftContact> found(
      this->state_.contacts.data(), static_cast<std::size_t>(this->state_.count));
    if (this->state_.count < GodObjectState::maxFeatures && differs(found, contact, alike))
    {
      this->state_.contacts[this->state_.count++] = contact;
    }
  }

  const AnyScene& scene_;
  std::span<const SoftSurfaceRef> soft_;
  double radius_u_;
  double patch_u_;
  SoftState& state_;
  std::array<SoftContact, GodObjectState::maxFeatures> before_;
  std::size_t beforeCount_;
};

} // namespace

template<SceneView AnyScene>
void gatherContacts(
  const AnyScene& scene, std::span<const SoftSurfaceRef> soft, double radius_u, SoftState& state) noexcept
{
  Gathering<AnyScene> gathering(scene, soft, radius_u, state);
  gathering.addFound(samePlane);
  gathering.addCarrying();
  gathering.keepForces();
}

template void gatherContacts(const Scene&, std::span<const SoftSurfaceRef>, double, SoftState&) noexcept;
template void gatherContacts(const MovingScene&, std::span<const SoftSurfaceRef>, double, SoftState&) noexcept;

} // namespace palpate
