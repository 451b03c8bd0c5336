// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/ContactMaterial.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{

/// Up to three vertices with their weights at the foot, and the gradient of each weight.
struct Blend
{
  std::array<std::uint32_t, 3> vertex{};
  std::array<double, 3> weight{};
  std::array<Vec3, 3> slope{ Vec3::Zero(), Vec3::Zero(), Vec3::Zero() };
  int count = 0;

  [[nodiscard]] double value(const std::vector<double>& field, double own) const noexcept
  {
    if (field.empty())
    {
      return own;
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(this->count); ++k)
    {
      sum += this->weight[k] * field[this->vertex[k]];
    }
    return sum;
  }
  [[nodiscard]] Vec3 gradient(const std::vector<double>& field) const noexcept
  {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; !field.empty() && k < static_cast<std::size_t>(this->count); ++k)
    {
      sum += field[this->vertex[k]] * this->slope[k];
    }
    return sum;
  }
};

/// Barycentric coordinates: each weight rises from the opposite side to its corner.
template<class View>
Blend blendOnFace(const View& s, std::uint32_t triangle, const Vec3& foot_W) noexcept
{
  const FaceRecord& face = s.face(triangle);
  Blend blend;
  blend.count = 3;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3 &corner = face.corner_W[k], &from = face.corner_W[(k + 1) % 3];
    const Vec3 across = face.normal_W.cross(face.corner_W[(k + 2) % 3] - from); // perpendicular to the opposite side
    const double height = across.dot(corner - from);
    blend.vertex[k] = s.corners(triangle)[k];
    blend.slope[k] = across / height;
    blend.weight[k] = std::clamp(blend.slope[k].dot(foot_W - from), 0.0, 1.0);
  }
  return blend;
}

template<class View>
Blend blendOnEdge(const View& s, const ActiveFeature& f, const Vec3& foot_W) noexcept
{
  const EdgeLine line = edgeLine(s, f.a, f.b);
  const double along = std::clamp((foot_W - s.vertex(f.a)).dot(line.unit) / line.length, 0.0, 1.0);
  const Vec3 slope = line.unit / line.length;
  return { { f.a, f.b, 0 }, { 1.0 - along, along, 0.0 }, { -slope, slope, Vec3::Zero() }, 2 };
}

template<class View>
Blend blendAt(const View& s, const ActiveFeature& f, const Vec3& foot_W) noexcept
{
  if (f.kind == FeatureKind::Face)
  {
    return blendOnFace(s, f.a, foot_W);
  }
  if (f.kind == FeatureKind::Edge)
  {
    return blendOnEdge(s, f, foot_W);
  }
  return { { f.a, 0, 0 }, { 1.0, 0.0, 0.0 }, { Vec3::Zero(), Vec3::Zero(), Vec3::Zero() }, 1 };
}

template<class View>
double shortestSide(const View& s, const ActiveFeature& f) noexcept
{
  if (f.kind != FeatureKind::Face)
  {
    return f.kind == FeatureKind::Edge ? edgeLine(s, f.a, f.b).length : 0.0;
  }
  const FaceRecord& face = s.face(f.a);
  const auto& [a, b, c] = face.corner_W;
  return std::min({ (b - a).norm(), (c - b).norm(), (a - c).norm() });
}

} // namespace

template<class SceneView>
ContactMaterial materialAt(
  const SceneView& scene, const ContactPlan& plan, const ActiveFeature& f, const Vec3& foot_W) noexcept
{
  const Surface& surface = sceneOf(scene).surfaces()[f.surface];
  const Material& own = surface.material;
  ContactMaterial at;
  at.stiffnessFactor = own.stiffnessFactor;
  at.friction = own.frictionStatic < 0.0 ? plan.friction : FrictionPlan{ own.frictionStatic, own.frictionKinetic };
  if (surface.fields == nullptr)
  {
    return at;
  }
  const auto& view = surfaceOf(scene, f.surface);
  const Blend blend = blendAt(view, f, foot_W);
  const MaterialFields& fields = *surface.fields;
  at.stiffnessFactor = blend.value(fields.stiffnessFactor, at.stiffnessFactor);
  at.friction.statical = std::max(0.0, blend.value(fields.frictionStatic, at.friction.statical));
  at.friction.kinetic = std::clamp(blend.value(fields.frictionKinetic, at.friction.kinetic), 0.0, at.friction.statical);
  at.height_u = blend.value(fields.height_u, 0.0);
  at.slope_W = blend.gradient(fields.height_u);
  at.grain_u = shortestSide(view, f);
  return at;
}

template ContactMaterial materialAt(const Scene&, const ContactPlan&, const ActiveFeature&, const Vec3&) noexcept;
template ContactMaterial materialAt(const MovingScene&, const ContactPlan&, const ActiveFeature&, const Vec3&) noexcept;

} // namespace palpate
