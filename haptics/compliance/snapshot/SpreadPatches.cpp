// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/snapshot/SpreadPatches.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

NodeBlocks widePatch(const SoftSurface& surface, std::uint32_t vertex, double radius_u)
{
  const std::uint32_t node = surface.vertices[vertex];
  const BorderFaces& border = *surface.border;
  return patchAt(
    border, border.place(node), border.facesAt(node).front(), radius_u, radius_u / surface.patch_u[vertex]);
}

} // namespace

double SpreadPatches::radiusOf(std::uint32_t vertex) const
{
  return std::max(this->surface_.patch_u[vertex], this->spread_u_);
}

std::vector<double> SpreadPatches::radiiWithin(std::uint32_t vertex) const
{
  std::vector<double> radii;
  for (double a = this->surface_.patch_u[vertex]; a < this->radiusOf(vertex) / std::sqrt(2.0); a *= 2.0)
  {
    radii.push_back(a);
  }
  return radii;
}

std::uint32_t SpreadPatches::place(std::uint32_t vertex)
{
  const auto [found, isNew] = this->placeOf_.emplace(vertex, static_cast<std::uint32_t>(this->map_.size()));
  if (isNew)
  {
    this->map_.add(widePatch(this->surface_, vertex, this->radiusOf(vertex)));
  }
  return found->second;
}

SparseColumns SpreadPatches::columnsOf(std::span<const std::uint32_t> vertices)
{
  if (this->spread_u_ <= 0.0)
  {
    return this->surface_.map.columnsOf(vertices);
  }
  std::vector<std::uint32_t> places;
  std::ranges::transform(vertices, std::back_inserter(places), [this](std::uint32_t v) { return this->place(v); });
  return this->map_.columnsOf(places);
}

Eigen::VectorXd timesColumns(const SparseColumns& patches, const Eigen::VectorXd& ofNodes)
{
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(patches.count()));
  for (std::size_t c = 0; c < patches.count(); ++c)
  {
    for (std::size_t i = patches.start[c]; i < patches.start[c + 1]; ++i)
    {
      moved[static_cast<Eigen::Index>(c)] += patches.values[i] * ofNodes[patches.rows[i]];
    }
  }
  return moved;
}

void SpreadPatches::addForce(std::uint32_t vertex, const Vec3& force_N, Eigen::VectorXd& ofNodes)
{
  if (this->spread_u_ <= 0.0)
  {
    this->surface_.map.addForce(vertex, force_N, ofNodes);
    return;
  }
  this->map_.addForce(this->place(vertex), force_N, ofNodes);
}

SparseColumns SpreadPatches::columnsWithin(std::span<const std::uint32_t> vertices, std::span<const Vec3> normals)
{
  SparseColumns columns;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    for (const double radius_u : this->radiiWithin(vertices[i]))
    {
      const NodeBlocks patch = widePatch(this->surface_, vertices[i], radius_u);
      for (std::size_t n = 0; n < patch.nodes.size(); ++n)
      {
        const Vec3 weights = patch.blocks[n].transpose() * normals[i];
        for (int c = 0; c < 3; ++c)
        {
          columns.rows.push_back(static_cast<std::int32_t>(3 * patch.nodes[n]) + c);
          columns.values.push_back(weights[c]);
        }
      }
      columns.start.push_back(columns.rows.size());
    }
  }
  return columns;
}

} // namespace palpate
