// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/element/StrainPoints.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "haptics/compliance/element/Materials.h"
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

/// An edge and one of the materials around it.
struct EdgeKey
{
  Edge edge{};
  std::uint32_t material = 0;
  auto operator<=>(const EdgeKey&) const = default;
};

/// Sums over the tetrahedra of one material around an edge.
struct EdgeSum
{
  double volume_u3 = 0.0;
  double mu = 0.0;
  double lambda = 0.0;
  std::map<std::uint32_t, Vec3> gradient; ///< of each node, times volume
  std::uint32_t point = 0;                ///< its number
};

EdgeKey keyOf(const Tetra& t, const std::array<int, 2>& edge, std::uint32_t material)
{
  const auto [low, high] = std::minmax(t[edge[0]], t[edge[1]]);
  return { { low, high }, material };
}

void addTetraToEdges(std::map<EdgeKey, EdgeSum>& edges, const Tetra& t, const TetraShape& shape, const ElasticModuli& m,
  std::uint32_t material)
{
  const double share = shape.volume_u3 / 6.0;
  for (const auto& edge : tetraEdges)
  {
    EdgeSum& sum = edges[keyOf(t, edge, material)];
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
  const std::vector<std::uint32_t> materials = materialsOf(mesh, moduli);
  std::map<EdgeKey, EdgeSum> edges;
  for (std::size_t i = 0; i < mesh.tetras.size(); ++i)
  {
    addTetraToEdges(edges, mesh.tetras[i], tetraShape(mesh, mesh.tetras[i]), moduli[i], materials[i]);
  }
  for (auto& [edge, sum] : edges)
  {
    std::vector<std::uint32_t> nodes;
    std::vector<Vec3> gradients;
    for (const auto& [node, gradient] : sum.gradient)
    {
      nodes.push_back(node);
      gradients.push_back(gradient / sum.volume_u3);
    }
    sum.point = static_cast<std::uint32_t>(all.points.size());
    addPoint(all, sum.volume_u3, { sum.mu / sum.volume_u3, sum.lambda / sum.volume_u3 }, nodes, gradients);
  }
  for (std::size_t i = 0; i < mesh.tetras.size(); ++i)
  {
    for (const auto& edge : tetraEdges)
    {
      all.ofTetras.push_back(edges.at(keyOf(mesh.tetras[i], edge, materials[i])).point);
    }
  }
}

/// The mid-edge nodes, numbered after the vertices.
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

void addLinearPoints(StrainPoints& all, const TetraMesh& mesh, const std::vector<ElasticModuli>& moduli)
{
  for (std::size_t i = 0; i < mesh.tetras.size(); ++i)
  {
    const TetraShape shape = tetraShape(mesh, mesh.tetras[i]);
    addPoint(all, shape.volume_u3, moduli[i], mesh.tetras[i], shape.gradients);
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

std::vector<Mat3> StrainPoints::deformationOfTetras(const std::vector<Mat3>& ofPoints) const
{
  std::vector<Mat3> means;
  for (std::size_t i = 0; i < this->ofTetras.size(); i += this->perTetra)
  {
    Mat3 sum = Mat3::Zero();
    for (std::size_t k = i; k < i + this->perTetra; ++k)
    {
      sum += ofPoints[this->ofTetras[k]];
    }
    means.emplace_back(sum / static_cast<double>(this->perTetra));
  }
  return means;
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
    all.perTetra = tetraEdges.size();
    addEdgePoints(all, mesh, moduli);
    return all;
  }
  if (kind == ElementKind::Quadratic)
  {
    all.perTetra = 4;
    addQuadraticPoints(all, mesh, moduli);
  }
  else
  {
    all.perTetra = 1;
    addLinearPoints(all, mesh, moduli);
  }
  all.ofTetras.resize(all.points.size()); // points are in the order of the tetrahedra
  std::iota(all.ofTetras.begin(), all.ofTetras.end(), 0u);
  return all;
}

} // namespace palpate
