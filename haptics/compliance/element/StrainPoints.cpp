// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/element/StrainPoints.h"

#include <algorithm>
#include <map>

#include "haptics/compliance/element/TetraShape.h"

namespace palpate
{
namespace
{

using Edge = std::array<std::uint32_t, 2>;

void addPoint(StrainPoints& all, double volume_u3, const ElasticModuli& moduli, std::span<const std::uint32_t> nodes,
  std::span<const Vec3> gradients)
{
  all.points.push_back({ all.nodes.size(), nodes.size(), volume_u3, moduli });
  all.nodes.insert(all.nodes.end(), nodes.begin(), nodes.end());
  all.gradients.insert(all.gradients.end(), gradients.begin(), gradients.end());
}

/// What the tetrahedra around an edge add up to.
struct EdgeSum
{
  double volume_u3 = 0.0;
  double mu = 0.0;
  double lambda = 0.0;
  std::map<std::uint32_t, Vec3> gradient; ///< of each node, times volume
};

void addTetraToEdges(std::map<Edge, EdgeSum>& edges, const Tetra& t, const TetraShape& shape, const ElasticModuli& m)
{
  const double share = shape.volume_u3 / 6.0;
  for (const auto& [i, j] : tetraEdges)
  {
    const auto [low, high] = std::minmax(t[i], t[j]);
    EdgeSum& sum = edges[{ low, high }];
    sum.volume_u3 += share;
    sum.mu += share * m.mu;
    sum.lambda += share * m.lambda;
    for (int a = 0; a < 4; ++a)
    {
      sum.gradient.try_emplace(t[a], Vec3::Zero()).first->second += share * shape.gradients[a];
    }
  }
}

void addEdgePoints(StrainPoints& all, const TetraMesh& mesh, const std::vector<ElasticModuli>& moduli)
{
  std::map<Edge, EdgeSum> edges;
  for (std::size_t i = 0; i < mesh.tetras.size(); ++i)
  {
    addTetraToEdges(edges, mesh.tetras[i], tetraShape(mesh, mesh.tetras[i]), moduli[i]);
  }
  for (const auto& [edge, sum] : edges)
  {
    std::vector<std::uint32_t> nodes;
    std::vector<Vec3> gradients;
    for (const auto& [node, gradient] : sum.gradient)
    {
      nodes.push_back(node);
      gradients.push_back(gradient / sum.volume_u3);
    }
    addPoint(all, sum.volume_u3, { sum.mu / sum.volume_u3, sum.lambda / sum.volume_u3 }, nodes, gradients);
  }
}

/// The nodes halfway, numbered after the vertices.
std::map<Edge, std::uint32_t> halve(StrainPoints& all, const TetraMesh& mesh)
{
  std::map<Edge, std::uint32_t> middles;
  for (const Tetra& t : mesh.tetras)
  {
    for (const auto& [i, j] : tetraEdges)
    {
      const auto [low, high] = std::minmax(t[i], t[j]);
      if (middles.try_emplace({ low, high }, static_cast<std::uint32_t>(all.rest_W.size())).second)
      {
        all.rest_W.push_back(0.5 * (mesh.vertices_W[low] + mesh.vertices_W[high]));
        all.halves.push_back({ low, high });
      }
    }
  }
  return middles;
}

void addQuadraticPoints(StrainPoints& all, const TetraMesh& mesh, const std::vector<ElasticModuli>& moduli)
{
  const std::map<Edge, std::uint32_t> middles = halve(all, mesh);
  for (std::size_t i = 0; i < mesh.tetras.size(); ++i)
  {
    const Tetra& t = mesh.tetras[i];
    std::array<std::uint32_t, 10> nodes{ t[0], t[1], t[2], t[3] };
    for (int e = 0; e < 6; ++e)
    {
      const auto [low, high] = std::minmax(t[tetraEdges[e][0]], t[tetraEdges[e][1]]);
      nodes[4 + e] = middles.at({ low, high });
    }
    const TetraShape shape = tetraShape(mesh, t);
    for (int g = 0; g < 4; ++g)
    {
      addPoint(all, shape.volume_u3 / 4.0, moduli[i], nodes, quadraticGradients(shape, gaussPoint(g)));
    }
  }
}

} // namespace

Mat3 StrainPoints::deformationAt(const StrainPoint& p, std::span<const double> displacement) const
{
  Mat3 f = Mat3::Identity();
  for (std::size_t a = p.first; a < p.first + p.count; ++a)
  {
    f += Eigen::Map<const Vec3>(displacement.data() + 3 * this->nodes[a]) * this->gradients[a].transpose();
  }
  return f;
}

std::size_t StrainPoints::mostStiffnessBytes() const
{
  std::size_t pairs = 0;
  for (const StrainPoint& p : this->points)
  {
    pairs += p.count * (p.count + 1) / 2;
  }
  return 9 * sizeof(double) * pairs;
}

StrainPoints makeStrainPoints(const TetraMesh& mesh, ElementKind kind, const std::vector<ElasticModuli>& moduli)
{
  StrainPoints all;
  all.rest_W = mesh.vertices_W;
  if (kind == ElementKind::EdgeSmoothed)
  {
    addEdgePoints(all, mesh, moduli);
  }
  else if (kind == ElementKind::Quadratic)
  {
    addQuadraticPoints(all, mesh, moduli);
  }
  else
  {
    for (std::size_t i = 0; i < mesh.tetras.size(); ++i)
    {
      const TetraShape shape = tetraShape(mesh, mesh.tetras[i]);
      addPoint(all, shape.volume_u3, moduli[i], mesh.tetras[i], shape.gradients);
    }
  }
  return all;
}

} // namespace palpate
