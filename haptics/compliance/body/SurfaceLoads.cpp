// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/body/SurfaceLoads.h"

#include <algorithm>
#include <map>

#include <Eigen/SparseCholesky>

namespace palpate
{
namespace
{

using Triangle = std::array<std::uint32_t, 3>;
using Tractions = Eigen::Matrix<double, Eigen::Dynamic, 3>;

std::vector<Triangle> loadedTriangles(const TetraMesh& mesh, const Eigen::VectorXd& load_N)
{
  const auto isLoaded = [&load_N](std::uint32_t v)
  { return !load_N.segment<3>(3 * static_cast<Eigen::Index>(v)).isZero(0.0); };
  const auto areLoaded = [&isLoaded](const auto& corners) { return std::ranges::all_of(corners, isLoaded); };
  std::vector<Triangle> border;
  if (std::ranges::none_of(mesh.tetras, areLoaded))
  {
    border = borderOf(mesh);
    std::erase_if(border, [&areLoaded](const Triangle& t) { return !areLoaded(t); });
  }
  return border;
}

double areaOf(const TetraMesh& mesh, const Triangle& t)
{
  const Vec3& a = mesh.vertices_W[t[0]];
  return 0.5 * (mesh.vertices_W[t[1]] - a).cross(mesh.vertices_W[t[2]] - a).norm();
}

/// Tractions at the corners of the triangles, in the order of `places` [N/u^2].
Tractions tractionsOf(const TetraMesh& mesh, const std::vector<Triangle>& triangles,
  const std::map<std::uint32_t, Eigen::Index>& places, const Eigen::VectorXd& load_N)
{
  const auto count = static_cast<Eigen::Index>(places.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (const Triangle& t : triangles)
  {
    for (const std::uint32_t a : t)
    {
      for (const std::uint32_t b : t)
      {
        entries.emplace_back(places.at(a), places.at(b), areaOf(mesh, t) / (a == b ? 6.0 : 12.0));
      }
    }
  }
  Eigen::SparseMatrix<double> work(count, count);
  work.setFromTriplets(entries.begin(), entries.end());
  Tractions loads(count, 3);
  for (const auto& [v, place] : places)
  {
    loads.row(place) = load_N.segment<3>(3 * static_cast<Eigen::Index>(v)).transpose();
  }
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(work).solve(loads);
}

} // namespace

void spreadTractions(const StrainPoints& points, const TetraMesh& mesh, Eigen::VectorXd& load_N)
{
  const std::vector<Triangle> triangles =
    points.halves.empty() ? std::vector<Triangle>() : loadedTriangles(mesh, load_N);
  if (triangles.empty())
  {
    return;
  }
  std::map<std::uint32_t, Eigen::Index> places;
  for (const Triangle& t : triangles)
  {
    for (const std::uint32_t v : t)
    {
      places.try_emplace(v, static_cast<Eigen::Index>(places.size()));
    }
  }
  std::map<std::array<std::uint32_t, 2>, std::size_t> middles;
  for (std::size_t h = 0; h < points.halves.size(); ++h)
  {
    middles[points.halves[h]] = points.rest_W.size() - points.halves.size() + h;
  }
  const Tractions tractions = tractionsOf(mesh, triangles, places, load_N);
  const auto at = [&load_N](std::size_t node) { return load_N.segment<3>(3 * static_cast<Eigen::Index>(node)); };
  for (const auto& [v, place] : places)
  {
    at(v).setZero();
  }
  // Integrals over a triangle of the ten-node functions times the corners' own: for a corner's function A / 30 and
  // -A / 60, for a mid-edge function 2 A / 15 with the ends of its edge and A / 15 with the third corner.
  for (const Triangle& t : triangles)
  {
    const double area = areaOf(mesh, t);
    for (int i = 0; i < 3; ++i)
    {
      const Vec3 own = tractions.row(places.at(t[i])).transpose();
      const Vec3 next = tractions.row(places.at(t[(i + 1) % 3])).transpose();
      const Vec3 last = tractions.row(places.at(t[(i + 2) % 3])).transpose();
      const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
      at(t[i]) += area / 30.0 * own - area / 60.0 * (next + last);
      at(middles.at({ low, high })) += 2.0 * area / 15.0 * (own + next) + area / 15.0 * last;
    }
  }
}

} // namespace palpate
