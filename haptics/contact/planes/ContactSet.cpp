// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/planes/ContactSet.h"

#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{

bool sameFeature(const ActiveFeature& f, const ActiveFeature& g) noexcept
{
  return f.surface == g.surface && f.kind == g.kind && f.a == g.a && f.b == g.b;
}

/// Coordinates are rounded on their way between a surface's frame and W as well.
Vec3 furthestShift(const SurfaceData&) noexcept
{
  return Vec3::Zero();
}

Vec3 furthestShift(const PosedSurface& posed) noexcept
{
  return posed.shift_W();
}

} // namespace

template<SceneView AnyScene>
ContactSet<AnyScene>::ContactSet(const AnyScene& scene, double radius_u, GodObjectState& state) noexcept
  : scene_(scene), radius_u_(radius_u), state_(state)
{
  this->resolution_.include(Vec3::Constant(radius_u + sceneOf(scene).mostCoat_u()));
  this->resolution_.include(state.x_W);
  for (const ActiveFeature& f : this->features())
  {
    this->include(f);
  }
}

template<SceneView AnyScene>
void ContactSet<AnyScene>::include(const ActiveFeature& f) noexcept
{
  const auto& data = this->surface(f);
  this->include(furthestShift(data));
  if (f.kind == FeatureKind::Face)
  {
    for (const Vec3& corner_W : data.face(f.a).corner_W)
    {
      this->include(corner_W);
    }
    return;
  }
  this->include(data.vertex(f.a));
  if (f.kind == FeatureKind::Edge)
  {
    this->include(data.vertex(f.b));
  }
}

template<SceneView AnyScene>
bool ContactSet<AnyScene>::supported(const ActiveFeature& f) const noexcept
{
  const auto& s = this->surface(f);
  const double tol = this->resolution_.tol();
  if (this->radius_u_ > 0.0 || f.kind != FeatureKind::Face)
  {
    return supports(s, f, this->state_.x_W, this->radius_u_, tol);
  }
  return this->plane(f).gap <= this->holdsWithin(f) && projectsInside(s, f.a, this->state_.x_W, tol);
}

/// Exact sweeps stop a point at the face itself, and the plane of the face is computed to be a little elsewhere.
template<SceneView AnyScene>
double ContactSet<AnyScene>::holdsWithin(const ActiveFeature& f) const noexcept
{
  const FaceRecord& face = this->surface(f).face(f.a);
  // A rounding of the normal, made larger by how thin the face is, times the distance over which it acts.
  const double error =
    4 * std::numeric_limits<double>::epsilon() * face.sliver * (this->state_.x_W - face.corner_W[0]).norm();
  return std::max({ this->resolution_.tol(), 2 * this->lift(), std::min(error, this->resolution_.mostError()) });
}

template<SceneView AnyScene>
int ContactSet<AnyScene>::add(const ActiveFeature& f) noexcept
{
  for (int i = 0; i < this->count(); ++i)
  {
    if (sameFeature(this->feature(i), f))
    {
      this->feature(i) = f;
      return i;
    }
  }
  if (this->count() == GodObjectState::maxFeatures)
  {
    int furthest = 0;
    for (int i = 1; i < this->count(); ++i)
    {
      if (this->plane(this->feature(i)).gap > this->plane(this->feature(furthest)).gap)
      {
        furthest = i;
      }
    }
    this->remove(furthest);
  }
  this->include(f);
  this->state_.features[this->state_.count] = f;
  return this->state_.count++;
}

template<SceneView AnyScene>
void ContactSet<AnyScene>::remove(int i) noexcept
{
  std::copy(this->state_.features.begin() + i + 1, this->state_.features.begin() + this->state_.count,
    this->state_.features.begin() + i);
  --this->state_.count;
}

template<SceneView AnyScene>
bool ContactSet<AnyScene>::raise() noexcept
{
  constexpr double most = 32.0; // five doublings, six tries in all: each try is a sweep
  const bool may = this->raised_ < most;
  this->raised_ *= may ? 2.0 : 1.0;
  return may;
}

template<SceneView AnyScene>
void ContactSet<AnyScene>::relinearise(const ActiveFeature* keep) noexcept
{
  int kept = 0;
  for (int i = 0; i < this->count(); ++i)
  {
    ActiveFeature f = this->feature(i);
    const bool isKeep = keep != nullptr && sameFeature(f, *keep);
    if (this->radius_u_ > 0.0 && f.kind != FeatureKind::Face)
    {
      const ActiveFeature holder = normalised(this->surface(f), f, this->state_.x_W);
      // A feature that was just hit although its face is touched already would only be hit again.
      f = isKeep && this->isAmong(holder, kept) ? f : holder;
      this->include(f);
    }
    const bool drop = (!isKeep && !this->supported(f)) || this->isAmong(f, kept);
    if (!drop)
    {
      this->feature(kept++) = f;
    }
  }
  this->state_.count = kept;
}

template<SceneView AnyScene>
bool ContactSet<AnyScene>::isAmong(const ActiveFeature& f, int first) const noexcept
{
  return std::any_of(this->state_.features.begin(), this->state_.features.begin() + first,
    [&f](const ActiveFeature& g) { return sameFeature(f, g); });
}

template<SceneView AnyScene>
void ContactSet<AnyScene>::advanceFaces(const Vec3& from_W, const Vec3& moved) noexcept
{
  for (int i = 0; i < this->count(); ++i)
  {
    ActiveFeature& f = this->feature(i);
    if (f.kind != FeatureKind::Face)
    {
      continue;
    }
    const auto& data = this->surface(f);
    const std::uint32_t reached = walkFace(data, f.a, from_W, moved, this->resolution_.del()).triangle;
    if (reached != f.a)
    {
      f = onSamePlane(data, f, reached);
    }
  }
}

template<SceneView AnyScene>
PlaneRow ContactSet<AnyScene>::row(int i, double lift) const noexcept
{
  const FeaturePlane plane = this->plane(this->state_.features[i]);
  return { plane.n, -plane.gap + lift };
}

template<SceneView AnyScene>
ProjectionResult ContactSet<AnyScene>::solve(const Vec3& q, double lift) const noexcept
{
  std::array<PlaneRow, GodObjectState::maxFeatures> rows;
  for (int i = 0; i < this->count(); ++i)
  {
    rows[i] = this->row(i, lift);
  }
  return projectOntoPlanes({ rows.data(), static_cast<std::size_t>(this->count()) }, q, this->resolution_.slack());
}

template class ContactSet<Scene>;
template class ContactSet<MovingScene>;

} // namespace palpate
