// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/found/SoftAsMesh.h"

#include <algorithm>

#include "haptics/geometry/mesh/TriangleWeights.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

BentBy::BentBy(const PressedBody* soft, int soft_i, int without, std::span<const MechanismPress> presses) : soft_(soft)
{
  for (const MechanismPress& press : presses)
  {
    if (soft && press.soft == soft_i && press.force_N != Vec3::Zero())
    {
      this->forces_.push_back(
        { compliantPoint(*soft->snapshot, press.at), press.force_N, without < 0 || press.from == without });
    }
  }
  for (const Force& force : this->forces_)
  {
    this->most_u_ = std::max(this->most_u_, (this->by(force.at, true) + this->by(force.at, false)).norm());
  }
  this->most_u_ *= 1.5; // a vertex beside the forces may go a little further
}

Vec3 BentBy::by(const SurfacePoint& at, bool own) const
{
  return this->by(compliantPoint(*this->soft_->snapshot, at), own);
}

Vec3 BentBy::by(const CompliantPoint& at, bool own) const
{
  Vec3 sum = Vec3::Zero();
  for (const Force& force : this->forces_)
  {
    sum += force.isOwn == own ? Vec3(complianceBetween(*this->soft_->snapshot, at, force.at) * force.force_N)
                              : Vec3(Vec3::Zero());
  }
  return sum;
}

void SoftAsMesh::bend(const BentBy& bending, const Box& reached)
{
  std::vector<char> is(this->bent_W.size(), 0);
  forEachMeeting(
    this->surface.tree->data(), [&](const Box& box) { return overlap(box, reached); },
    [&](std::uint32_t t)
    {
      for (const std::uint32_t v : this->surface.tree->data().corners(t))
      {
        is[v] = 1;
      }
    });
  this->bent_u = bending.most_u();
  for (std::uint32_t v = 0; v < is.size(); ++v)
  {
    if (is[v])
    {
      this->near.push_back(v);
      if (bending.bends())
      {
        const SurfacePoint at = placeAt(v, this->free_W);
        this->without_W[v] += bending.by(at, false);
        this->bent_W[v] = this->without_W[v] + bending.by(at, true);
      }
      this->bent_u = std::max(this->bent_u, (this->bent_W[v] - this->free_W[v]).norm());
      this->around.include(this->bent_W[v]);
    }
  }
}

SurfacePoint SoftAsMesh::placeOn(std::uint32_t triangle, const Vec3& at_W) const
{
  const auto& corners = this->surface.tree->data().corners(triangle);
  const std::vector<Vec3>& free = this->free_W;
  const Vec3 weights =
    weightsOnTriangle(this->bent_W[corners[0]], this->bent_W[corners[1]], this->bent_W[corners[2]], at_W);
  return { corners, weights,
    weights[0] * free[corners[0]] + weights[1] * free[corners[1]] + weights[2] * free[corners[2]] };
}

SurfacePoint SoftAsMesh::placeAlong(std::uint32_t a, std::uint32_t b, double share) const
{
  return { { a, b, b }, Vec3(1.0 - share, share, 0.0), (1.0 - share) * this->free_W[a] + share * this->free_W[b] };
}

Vec3 SoftAsMesh::withoutAt(const SurfacePoint& place) const
{
  Vec3 at_W = Vec3::Zero();
  for (std::size_t c = 0; c < 3; ++c)
  {
    at_W += place.weights[static_cast<Eigen::Index>(c)] * this->without_W[place.vertices[c]];
  }
  return at_W;
}

double SoftAsMesh::areaAround(std::uint32_t v, const Vec3& out_W) const
{
  double twice_u2 = 0.0;
  this->surface.tree->data().forEachAround(
    v, [&](std::uint32_t t) { twice_u2 += std::max(0.0, this->surface.areaOf(t, this->bent_W).dot(out_W)); });
  return twice_u2 / 6.0;
}

} // namespace palpate
