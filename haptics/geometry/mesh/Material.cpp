// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/mesh/Material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{
namespace
{

struct Range
{
  double least, most;

  [[nodiscard]] bool holds(double value) const { return value >= this->least && value <= this->most; }
};

constexpr double largest = std::numeric_limits<double>::max();
constexpr Range stiffnesses{ 0.0, largest }, frictions{ 0.0, Material::largestFriction },
  heights{ -1e100, 1e100 }; // their squares are finite

/// Picks the values of the cleaned vertices; an unusable value becomes `own`.
void fit(const std::vector<double>& raw, double own, const Range& range, const std::vector<std::uint32_t>& sourceVertex,
  std::vector<double>& fitted, std::size_t& replaced)
{
  if (raw.empty())
  {
    return;
  }
  fitted.reserve(sourceVertex.size());
  for (const std::uint32_t source : sourceVertex)
  {
    const bool usable = std::isfinite(raw[source]) && range.holds(raw[source]);
    replaced += usable ? 0 : 1;
    fitted.push_back(usable ? raw[source] : own);
  }
}

/// Of those of the cleaned vertices that can be used; 0 if there are none.
double largestHeight(const std::vector<double>& raw_u, const std::vector<std::uint32_t>& sourceVertex)
{
  double largest_u = -std::numeric_limits<double>::infinity();
  for (const std::uint32_t source : sourceVertex)
  {
    const double height_u = raw_u.empty() ? 0.0 : raw_u[source];
    largest_u = heights.holds(height_u) ? std::max(largest_u, height_u) : largest_u;
  }
  return std::isfinite(largest_u) ? largest_u : 0.0;
}

/// Moments of a linear height over one triangle.
struct HeightOnFace
{
  double area_u2 = 0.0, mean_u = 0.0, square_u2 = 0.0, slope2 = 0.0;
};

HeightOnFace heightOn(
  const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& corners, const std::vector<double>& h)
{
  const auto [i, j, k] = corners;
  const Vec3 e = mesh.vertices_W[j] - mesh.vertices_W[i], f = mesh.vertices_W[k] - mesh.vertices_W[i];
  const double rise_e = h[j] - h[i], rise_f = h[k] - h[i], sum = h[i] + h[j] + h[k];
  const double area2 = e.cross(f).norm();
  HeightOnFace face;
  face.area_u2 = 0.5 * area2;
  face.mean_u = sum / 3.0;
  face.square_u2 = (sum * sum + h[i] * h[i] + h[j] * h[j] + h[k] * h[k]) / 12.0;
  face.slope2 = (rise_e * f - rise_f * e).squaredNorm() / (area2 * area2);
  return face;
}

} // namespace

TextureScale measureTexture(const TriangleMesh& mesh, const std::vector<double>& height_u)
{
  HeightOnFace whole;
  for (const auto& corners : mesh.triangles)
  {
    const HeightOnFace face = heightOn(mesh, corners, height_u);
    whole.area_u2 += face.area_u2;
    whole.mean_u += face.area_u2 * face.mean_u;
    whole.square_u2 += face.area_u2 * face.square_u2;
    whole.slope2 += face.area_u2 * face.slope2;
  }
  TextureScale scale;
  scale.largest_u = *std::max_element(height_u.begin(), height_u.end());
  scale.mean_u = whole.mean_u / whole.area_u2;
  const double variance_u2 = std::max(0.0, whole.square_u2 / whole.area_u2 - scale.mean_u * scale.mean_u);
  if (whole.slope2 > 0.0)
  {
    scale.period_u = 2.0 * std::numbers::pi * std::sqrt(variance_u2 * whole.area_u2 / whole.slope2);
  }
  return scale;
}

std::string Material::validate() const
{
  if (!stiffnesses.holds(this->stiffness_N_per_m) && this->stiffness_N_per_m != rigid_N_per_m)
  {
    return "the stiffness of a surface [N/m] must be a number that is not negative";
  }
  const bool asPlan = this->frictionStatic < 0.0 && this->frictionKinetic < 0.0;
  if (!asPlan && !(frictions.holds(this->frictionStatic) && frictions.holds(this->frictionKinetic) &&
                   this->frictionKinetic <= this->frictionStatic))
  {
    return "the friction of a surface must be from 0 to 10, the kinetic no more than the static one";
  }
  return {};
}

FittedFields fitFields(const MaterialFields& raw, const Material& own, const std::vector<std::uint32_t>& sourceVertex,
  std::size_t rawVertices)
{
  FittedFields result;
  for (const std::vector<double>* const field :
    { &raw.stiffness_N_per_m, &raw.frictionStatic, &raw.frictionKinetic, &raw.height_u })
  {
    if (!field->empty() && field->size() != rawVertices)
    {
      result.refusal = "a material array has " + std::to_string(field->size()) + " values for " +
                       std::to_string(rawVertices) + " points";
      return result;
    }
  }
  MaterialFields& fields = result.fields;
  fit(
    raw.stiffness_N_per_m, own.stiffness_N_per_m, stiffnesses, sourceVertex, fields.stiffness_N_per_m, result.replaced);
  fit(raw.frictionStatic, own.frictionStatic, frictions, sourceVertex, fields.frictionStatic, result.replaced);
  fit(raw.frictionKinetic, own.frictionKinetic, frictions, sourceVertex, fields.frictionKinetic, result.replaced);
  fit(raw.height_u, largestHeight(raw.height_u, sourceVertex), heights, sourceVertex, fields.height_u, result.replaced);
  return result;
}

} // namespace palpate
