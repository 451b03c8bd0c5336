// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/scene/Scene.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "haptics/core/PoseMath.h"
#include "haptics/core/WordHash.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

/// `began`: of the surfaces that these come from.
std::uint64_t hashGeometry(const std::vector<Surface>& surfaces, bool began)
{
  WordHash hash;
  for (const Surface& surface : surfaces)
  {
    hash.add(began && surface.from ? surface.from->continues : surface.tree->contentHash());
    hash.add(surface.material.stiffness_N_per_m);
    hash.add(surface.material.frictionStatic);
    hash.add(surface.material.frictionKinetic);
    if (surface.standsFor.full != 0)
    {
      hash.add(surface.standsFor.full);
      hash.add(surface.standsFor.bound_u);
    }
    if (surface.fields)
    {
      const MaterialFields& f = *surface.fields;
      for (const std::vector<double>* const field :
        { &f.stiffness_N_per_m, &f.frictionStatic, &f.frictionKinetic, &f.height_u })
      {
        hash.add(static_cast<std::uint64_t>(field->size()));
        std::for_each(field->begin(), field->end(), [&hash](double value) { hash.add(value); });
      }
    }
  }
  return hash.value();
}

std::uint64_t hashMotions(std::uint64_t geometry, const std::vector<Surface>& surfaces, double motion_s)
{
  WordHash hash;
  hash.add(geometry);
  hash.add(motion_s);
  for (const Surface& surface : surfaces)
  {
    for (const Pose& pose : { surface.motion.begin_WS, surface.motion.end_WS })
    {
      for (const double number : { pose.p.x(), pose.p.y(), pose.p.z(), pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z() })
      {
        hash.add(number);
      }
    }
    hash.add(surface.from ? surface.from->hash : std::uint64_t{ 0 });
  }
  return hash.value();
}

bool anyPosed(const std::vector<Surface>& surfaces)
{
  return std::any_of(surfaces.begin(), surfaces.end(), [](const Surface& s) { return !s.motion.isStill(); });
}

/// Around all places of the vertices, in the surface's own frame.
Box boxAroundShape(const Surface& surface)
{
  const SurfaceData& data = surface.tree->data();
  Box box{ data.low_W, data.high_W };
  for (const PlaceBounds& place : data.places)
  {
    if (surface.from)
    {
      box.include(place.all.low_W);
      box.include(place.all.high_W);
    }
  }
  return box;
}

void include(Box& box, const Pose& pose, const Box& shape)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vec3 at_S((corner & 1) != 0 ? shape.high_W.x() : shape.low_W.x(),
      (corner & 2) != 0 ? shape.high_W.y() : shape.low_W.y(), (corner & 4) != 0 ? shape.high_W.z() : shape.low_W.z());
    box.include(pose * at_S);
  }
}

/// Around the surface in all of its motion. Between two poses a point leaves the chord of its arc by at most R (1 -
/// cos(angle / 2)), which is R |q1 - q0|^2 / 2.
Box boxAroundSkeleton(const Surface& surface)
{
  const Box shape = boxAroundShape(surface);
  if (surface.motion.isStill())
  {
    return shape;
  }
  constexpr double most = std::numeric_limits<double>::max();
  Box box{ Vec3::Constant(most), Vec3::Constant(-most) };
  const RigidMotion& motion = surface.motion;
  include(box, motion.begin_WS, shape);
  include(box, motion.end_WS, shape);
  const double radius = shape.low_W.cwiseAbs().cwiseMax(shape.high_W.cwiseAbs()).norm();
  const double sign = motion.begin_WS.q.dot(motion.end_WS.q) < 0.0 ? -1.0 : 1.0;
  const double turn2 = (motion.end_WS.q.coeffs() - sign * motion.begin_WS.q.coeffs()).squaredNorm();
  constexpr double rounding = 1e-12;
  const double grow = 0.5 * turn2 * radius + rounding * (radius + motion.begin_WS.p.norm() + motion.end_WS.p.norm());
  box.low_W.array() -= grow;
  box.high_W.array() += grow;
  return box;
}

/// With the coat, and a little more than it takes to round.
Box boxAroundWay(const Surface& surface)
{
  Box box = boxAroundSkeleton(surface);
  const double grow = (1.0 + 1e-9) * surface.tree->coat_u();
  box.low_W.array() -= grow;
  box.high_W.array() += grow;
  return box;
}

BoxTree treeOver(const std::vector<Surface>& surfaces)
{
  std::vector<Box> boxes;
  for (const Surface& surface : surfaces)
  {
    boxes.push_back(boxAroundWay(surface));
  }
  return makeBoxTree(boxes);
}

} // namespace

bool inOneFrame(const Surface& was, std::uint64_t frame, const RigidMotion& motion) noexcept
{
  return was.frame == frame || (was.motion.isStill() && motion.isStill());
}

std::uint64_t wayNameOf(const Surface& surface) noexcept
{
  WordHash hash;
  hash.add(surface.tree->contentHash());
  hash.add(surface.from ? surface.from->hash : std::uint64_t{ 0 });
  return hash.value();
}

Scene::Scene(std::uint64_t revision, std::vector<Surface> surfaces, double motion_s)
  : revision_(revision), motion_s_(motion_s), geometryHash_(hashGeometry(surfaces, false)),
    continuesGeometry_(hashGeometry(surfaces, true)), surfaces_(std::move(surfaces)), surfaceTree_(treeOver(surfaces_)),
    bends_(std::any_of(surfaces_.begin(), surfaces_.end(), [](const Surface& s) { return s.from != nullptr; }))
{
  this->moves_ = this->bends_ || anyPosed(this->surfaces_);
  this->changesPoses_ =
    std::any_of(this->surfaces_.begin(), this->surfaces_.end(), [](const Surface& s) { return s.motion.moves(); });
  this->hasMaterials_ = std::any_of(this->surfaces_.begin(), this->surfaces_.end(),
    [](const Surface& s) { return s.fields != nullptr || !s.material.isPlain(); });
  for (const Surface& surface : this->surfaces_)
  {
    const double coat_u = surface.tree->coat_u();
    const bool first = this->leastCoat_u_ == 0.0;
    this->mostCoat_u_ = std::max(this->mostCoat_u_, coat_u);
    this->leastCoat_u_ = coat_u > 0.0 && (first || coat_u < this->leastCoat_u_) ? coat_u : this->leastCoat_u_;
  }
  this->contentHash_ = this->moves_ ? hashMotions(this->geometryHash_, this->surfaces_, motion_s) : this->geometryHash_;
}

} // namespace palpate
