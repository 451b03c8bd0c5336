// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/map/Patches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "haptics/core/CrossMatrix.h"

namespace palpate
{
namespace
{

/// Parts of an edge of a face in a usual patch: 64 triangles of equal area integrate the kernel to a thousandth.
constexpr int mostCuts = 8;

using Weights = std::map<std::uint32_t, double>;

/// Adds the shares of a point at barycentric coordinates b of a face to its nodes. On a face of six nodes the
/// shape functions are quadratic: with linear ones between the nodes a third of the force for the mid-edge nodes would
/// act on the corners, which are more compliant.
void addShares(
  const BorderFaces& border, std::uint32_t face, const std::array<double, 3>& b, double weight, Weights& weights)
{
  const BorderFaces::Face& corners = border.faces()[face];
  const bool halved = !border.halves().empty();
  for (std::size_t a = 0; a < 3; ++a)
  {
    weights[corners[a]] += weight * b[a] * (halved ? 2.0 * b[a] - 1.0 : 1.0);
    if (halved)
    {
      weights[border.halves()[face][a]] += 4.0 * weight * b[a] * b[(a + 1) % 3];
    }
  }
}

/// Adds the integral of the kernel over a face to its nodes; false if the face has no point within the radius.
bool addFace(
  const BorderFaces& border, std::uint32_t face, const Vec3& center_W, double radius_u, int cuts, Weights& weights)
{
  const std::array<Vec3, 3> c = border.cornersOf(face);
  const double area = 0.5 * (c[1] - c[0]).cross(c[2] - c[0]).norm() / (cuts * cuts);
  bool within = false;
  // Centroids of the small triangles: the upright ones, and the inverted ones between them.
  for (int i = 0; i < cuts; ++i)
  {
    for (int j = 0; j < 2 * (cuts - i) - 1; ++j)
    {
      const double third = j % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0;
      const double b1 = (i + third) / cuts;
      const double b2 = (j / 2 + third) / cuts;
      const std::array<double, 3> b{ 1.0 - b1 - b2, b1, b2 };
      const double d2 = (b[0] * c[0] + b[1] * c[1] + b[2] * c[2] - center_W).squaredNorm();
      const double kernel = 1.0 - d2 / (radius_u * radius_u);
      if (kernel > 0.0)
      {
        addShares(border, face, b, kernel * area, weights);
        within = true;
      }
    }
  }
  return within;
}

Weights weightsAround(const BorderFaces& border, const Vec3& center_W, std::uint32_t first, double radius_u, int cuts)
{
  Weights weights;
  std::set<std::uint32_t> met{ first };
  std::vector<std::uint32_t> open{ first };
  while (!open.empty())
  {
    const std::uint32_t face = open.back();
    open.pop_back();
    if (!addFace(border, face, center_W, radius_u, cuts, weights) && face != first)
    {
      continue;
    }
    for (const std::uint32_t node : border.faces()[face])
    {
      for (const std::uint32_t next : border.facesAt(node))
      {
        if (met.insert(next).second)
        {
          open.push_back(next);
        }
      }
    }
  }
  double sum = 0.0;
  for (const auto& [node, weight] : weights)
  {
    sum += weight;
  }
  for (auto& [node, weight] : weights)
  {
    weight /= sum;
  }
  return weights;
}

} // namespace

BorderFaces::BorderFaces(const StrainPoints& body, const std::vector<Face>& border)
  : rest_W_(body.rest_W), faces_(border), facesAt_(body.rest_W.size())
{
  if (!body.halves.empty())
  {
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> middles;
    for (std::uint32_t h = 0; h < body.halves.size(); ++h)
    {
      middles[body.halves[h]] = static_cast<std::uint32_t>(body.rest_W.size() - body.halves.size()) + h;
    }
    const auto middle = [&middles](std::uint32_t a, std::uint32_t b) {
      return middles.at({ std::min(a, b), std::max(a, b) });
    };
    for (const auto& [a, b, c] : border)
    {
      this->halves_.push_back({ middle(a, b), middle(b, c), middle(c, a) });
    }
  }
  for (std::uint32_t f = 0; f < this->faces_.size(); ++f)
  {
    for (const std::uint32_t node : this->faces_[f])
    {
      this->facesAt_[node].push_back(f);
    }
  }
}

std::array<Vec3, 3> BorderFaces::cornersOf(std::uint32_t face) const
{
  const Face& f = this->faces_[face];
  return { this->rest_W_[f[0]], this->rest_W_[f[1]], this->rest_W_[f[2]] };
}

double BorderFaces::edgeLengthAt(std::uint32_t node) const
{
  double sum = 0.0;
  for (const std::uint32_t face : this->facesAt_[node])
  {
    for (const std::uint32_t other : this->faces_[face])
    {
      sum += 0.5 * (this->rest_W_[other] - this->rest_W_[node]).norm();
    }
  }
  return sum / static_cast<double>(this->facesAt_[node].size());
}

NodeBlocks patchAt(const BorderFaces& border, const Vec3& center_W, std::uint32_t face, double radius_u, double wider)
{
  const int cuts = std::clamp(static_cast<int>(std::ceil(mostCuts / wider)), 1, mostCuts);
  const Weights weights = weightsAround(border, center_W, face, radius_u, cuts);
  Vec3 mean = Vec3::Zero();
  for (const auto& [node, weight] : weights)
  {
    mean += weight * border.place(node);
  }
  Mat3 inertia = Mat3::Zero();
  for (const auto& [node, weight] : weights)
  {
    const Vec3 d = border.place(node) - mean;
    inertia += weight * (d.squaredNorm() * Mat3::Identity() - d * d.transpose());
  }
  const Mat3 lever = crossMatrix(center_W - mean) * inertia.inverse();
  NodeBlocks patch;
  for (const auto& [node, weight] : weights)
  {
    patch.nodes.push_back(node);
    patch.blocks.emplace_back(weight * (Mat3::Identity() - lever * crossMatrix(border.place(node) - mean)));
  }
  return patch;
}

} // namespace palpate
