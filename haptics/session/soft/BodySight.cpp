// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/soft/BodySight.h"

#include <algorithm>
#include <span>

#include <Eigen/Geometry>

#include "haptics/compliance/mesh/FilledTwice.h"
#include "haptics/compliance/snapshot/PointCompliance.h"

namespace palpate
{
namespace
{

/// A point under a force moves with its contact patch, and between vertices further (PointCompliance.h), not with the
/// nodes of its triangle. Returns how much further than its node each vertex of the surface is drawn, so that such
/// points are drawn where they are felt.
std::vector<Vec3> dents_u(const BodySight& sight, const Eigen::VectorXd& displacement_u)
{
  std::vector<Vec3> dents(sight.surface->vertices.size(), Vec3::Zero());
  if (!sight.snapshot || !sight.underPoints)
  {
    return dents;
  }
  const ComplianceSnapshot& last = *sight.snapshot;
  const std::size_t count = last.forceAt.size();
  std::vector<CompliantPoint> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points.push_back(compliantPoint(last, last.forceAt[i]));
  }
  const std::vector<Vec3> places_W = sight.surface->placesOf(displacement_u, displacement_u);
  for (const CompliantPoint& point : points)
  {
    Vec3 left = Vec3::Zero();
    for (std::size_t j = 0; j < count; ++j)
    {
      left += complianceBetween(last, point, points[j]) * last.force_N[j];
    }
    for (int c = 0; c < 3; ++c)
    {
      const std::uint32_t v = point.at.vertices[c];
      left += point.at.weights[c] * (last.free_W[v] - places_W[v] - dents[v]);
    }
    for (int c = 0; c < 3; ++c)
    {
      dents[point.at.vertices[c]] += point.at.weights[c] / point.at.weights.squaredNorm() * left;
    }
  }
  return dents;
}

void addStrain(const StrainPoints& points, const Eigen::VectorXd& u, BodyShape& shape)
{
  std::vector<Mat3> deformation;
  for (const StrainPoint& p : points.points)
  {
    deformation.push_back(points.deformationAt(p, { u.data(), static_cast<std::size_t>(u.size()) }));
    const double gradient = (deformation.back() - Mat3::Identity()).norm();
    if (gradient > shape.mostGradient)
    {
      shape.mostGradient = gradient;
      shape.worst_W = points.rest_W[points.nodesOf(p).front()];
    }
  }
  shape.deformation = points.deformationOfTetras(deformation);
}

} // namespace

/// Looks from the point of the largest contact force along that force. Self-contact is not modelled: below a fold that
/// is pressed shut the body passes through itself.
double throughItself_u(const BodySight& sight, const Eigen::VectorXd& displacement_u)
{
  if (!sight.snapshot)
  {
    return 0.0;
  }
  const ComplianceSnapshot& snapshot = *sight.snapshot;
  constexpr double rounding = 1e-9; // of the line
  const auto most = std::ranges::max_element(snapshot.force_N, {}, [](const Vec3& f) { return f.squaredNorm(); });
  if (most == snapshot.force_N.end() || most->squaredNorm() == 0.0)
  {
    return 0.0;
  }
  const TetraMesh& mesh = sight.checked->mesh;
  std::vector<Vec3> places_W;
  Eigen::AlignedBox3d box;
  for (std::size_t v = 0; v < mesh.vertices_W.size(); ++v)
  {
    places_W.emplace_back(mesh.vertices_W[v] + displacement_u.segment<3>(3 * static_cast<Eigen::Index>(v)));
    box.extend(places_W.back());
  }
  const SurfacePoint& at = snapshot.forceAt[static_cast<std::size_t>(most - snapshot.force_N.begin())];
  LinePiece below{ Vec3::Zero(), most->normalized(), box.diagonal().norm() };
  for (int c = 0; c < 3; ++c)
  {
    below.from_W += at.weights[c] * places_W[sight.surface->vertices[at.vertices[c]]];
  }
  const double twice_u = filledTwice(mesh, places_W, below);
  return twice_u > rounding * below.length_u ? twice_u : 0.0;
}

Eigen::VectorXd displacementOf(const BodySight& sight)
{
  return sight.displacement_u ? *sight.displacement_u : sight.body->restUnder(sight.load_N);
}

BodyShape shapeOf(const BodySight& sight)
{
  const Eigen::VectorXd u = displacementOf(sight);
  BodyShape shape;
  shape.struck = sight.snapshot && sight.snapshot->struck;
  shape.hand_W = sight.hand_W;
  shape.throughItself_u = throughItself_u(sight, u);
  for (std::size_t v = 0; v < sight.checked->mesh.vertices_W.size(); ++v)
  {
    shape.displacement_u.emplace_back(u.segment<3>(3 * static_cast<Eigen::Index>(v)));
  }
  shape.dent_u.assign(shape.displacement_u.size(), Vec3::Zero());
  const std::vector<Vec3> dents = dents_u(sight, u);
  for (std::size_t i = 0; i < sight.surface->vertices.size(); ++i)
  {
    if (const std::uint32_t node = sight.surface->vertices[i]; !sight.checked->fixed[node])
    {
      shape.dent_u[node] = dents[i]; // a fixed node is drawn at its fixed position
    }
  }
  addStrain(sight.body->points(), u, shape);
  return shape;
}

} // namespace palpate
