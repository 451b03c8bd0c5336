// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/feel/ContactMaterial.h"

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

  /// Of a quantity given at the vertices.
  template<class At>
  [[nodiscard]] double value(At at) const noexcept
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(this->count); ++k)
    {
      sum += this->weight[k] * at(this->vertex[k]);
    }
    return sum;
  }
  template<class At>
  [[nodiscard]] Vec3 gradient(At at) const noexcept
  {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < static_cast<std::size_t>(this->count); ++k)
    {
      sum += at(this->vertex[k]) * this->slope[k];
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

double shareOf(double stiffness_N_per_m, const ContactPlan& plan) noexcept
{
  return stiffness_N_per_m < plan.coupling_N_per_m ? stiffness_N_per_m / plan.coupling_N_per_m : 1.0;
}

/// The stiffness that the data say between the vertices, but no more than the coupling's. A vertex that is rigid, for
/// want of a number, has the coupling's.
void addStiffness(
  const Blend& blend, const std::vector<double>& field, const ContactPlan& plan, ContactMaterial& at) noexcept
{
  if (field.empty())
  {
    return;
  }
  const auto stiffness = [&field, &plan](std::uint32_t v)
  {
    constexpr double stiffest_N_per_m = 1e100; // larger ones would have a slope that is not finite
    return field[v] < Material::rigid_N_per_m ? std::min(field[v], stiffest_N_per_m) : plan.coupling_N_per_m;
  };
  const double there_N_per_m = blend.value(stiffness);
  at.share = shareOf(there_N_per_m, plan);
  at.shareSlope_W = Vec3::Zero();
  if (there_N_per_m < plan.coupling_N_per_m)
  {
    at.shareSlope_W = blend.gradient(stiffness) / plan.coupling_N_per_m;
  }
}

/// A vertex without a coefficient of its own has the plan's.
double blendFriction(const Blend& blend, const std::vector<double>& field, double planned) noexcept
{
  return field.empty() ? planned : blend.value([&](std::uint32_t v) { return field[v] < 0.0 ? planned : field[v]; });
}

template<class View>
void addTexture(const View& view, const ActiveFeature& f, const Blend& blend, const MaterialFields& fields,
  ContactMaterial& at) noexcept
{
  if (fields.height_u.empty())
  {
    return;
  }
  const auto height = [&fields](std::uint32_t v) { return fields.height_u[v]; };
  at.height_u = blend.value(height);
  at.slope_W = blend.gradient(height);
  at.texture = fields.texture;
  at.texture.period_u = std::max(at.texture.period_u, 2.0 * shortestSide(view, f));
}

} // namespace

template<SceneView AnyScene>
ContactMaterial materialAt(
  const AnyScene& scene, const ContactPlan& plan, const ActiveFeature& f, const Vec3& foot_W) noexcept
{
  const Surface& surface = sceneOf(scene).surfaces()[f.surface];
  const Material& own = surface.material;
  ContactMaterial at;
  at.share = shareOf(own.stiffness_N_per_m, plan);
  at.friction = own.frictionStatic < 0.0 ? plan.friction : FrictionPlan{ own.frictionStatic, own.frictionKinetic };
  if (surface.fields == nullptr)
  {
    return at;
  }
  const auto& view = surfaceOf(scene, f.surface);
  const Blend blend = blendAt(view, f, foot_W);
  const MaterialFields& fields = *surface.fields;
  addStiffness(blend, fields.stiffness_N_per_m, plan, at);
  at.friction.statical = blendFriction(blend, fields.frictionStatic, at.friction.statical);
  at.friction.kinetic =
    std::min(blendFriction(blend, fields.frictionKinetic, at.friction.kinetic), at.friction.statical);
  addTexture(view, f, blend, fields, at);
  return at;
}

template ContactMaterial materialAt(const Scene&, const ContactPlan&, const ActiveFeature&, const Vec3&) noexcept;
template ContactMaterial materialAt(const MovingScene&, const ContactPlan&, const ActiveFeature&, const Vec3&) noexcept;

} // namespace palpate
