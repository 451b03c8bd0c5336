// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/view/BentSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/tree/SurfaceRecords.h"

namespace palpate
{
namespace
{

/// Between these nothing under- or overflows: a tick computes the same face several times, and this is the quick way.
constexpr double leastArea2 = 1e-250, mostArea2 = 1e250;
/// A record holds it in single precision, which ends at 3e38.
constexpr double mostSliver = 1e30;

} // namespace

FaceRecord BentSurface::face(std::uint32_t triangle) const noexcept
{
  if (!this->bends())
  {
    return this->data_.face(triangle);
  }
  const auto compute = [&]() noexcept { return this->faceOnItsWay(triangle); };
  return this->cache_ != nullptr ? this->cache_->at(this->number_, triangle, compute) : compute();
}

FaceRecord BentSurface::faceOnItsWay(std::uint32_t triangle) const noexcept
{
  const FacePlane& end = this->data_.plane(triangle);
  FaceRecord face;
  face.corner_W = this->cornersOnTheirWay(triangle);
  face.owned = end.owned;
  const Vec3 e = face.corner_W[1] - face.corner_W[0], f = face.corner_W[2] - face.corner_W[0], cross = e.cross(f);
  const double area2 = cross.squaredNorm(), sides2 = e.squaredNorm() * f.squaredNorm();
  if (area2 > leastArea2 && area2 < mostArea2)
  {
    const double inverse = 1.0 / std::sqrt(area2);
    face.normal_W = inverse * cross;
    face.sliver = static_cast<float>(std::min(inverse * std::sqrt(sides2), mostSliver));
    if (face.sliver <= needleSliver)
    {
      return face;
    }
  }
  face = makeFace(face.corner_W, isSegment(this->data_.corners(triangle)), end.owned);
  if (!face.normal_W.allFinite())
  {
    face.normal_W = end.normal_W;
  }
  return face;
}

std::array<double, 3> BentSurface::shares() const noexcept
{
  if (!this->bends())
  {
    return { 1.0, 0.0, 0.0 };
  }
  const auto& [first, second] = this->from_->ofPlaces;
  const double left = 1.0 - this->share_;
  return { this->share_ + left * (1.0 - first - second), left * first, left * second };
}

BentNodes::BentNodes(const BentSurface& shape) noexcept : data_(shape.data()), shares_(shape.shares())
{
  Box all{ this->data_.low_W, this->data_.high_W };
  for (const PlaceBounds& place : this->data_.places)
  {
    all.include(place.all.low_W);
    all.include(place.all.high_W);
  }
  constexpr double operations = 8.0; // of two means of three, at half an ulp of the largest place each
  this->rounding_u_ = shape.bends() ? operations * std::numeric_limits<double>::epsilon() *
                                        std::max(all.low_W.cwiseAbs().maxCoeff(), all.high_W.cwiseAbs().maxCoeff())
                                    : 0.0;
}

TreeNode BentNodes::operator[](std::uint32_t index) const noexcept
{
  TreeNode node = this->data_.nodes[index];
  using Bounds = Eigen::Map<Eigen::Array<double, 6, 1>>;
  using PlaceBox = Eigen::Map<const Eigen::Array<double, 6, 1>>;
  Bounds low(node.low_W[0].data()), high(node.high_W[0].data());
  low = this->shares_[0] * low - this->rounding_u_;
  high = this->shares_[0] * high + this->rounding_u_;
  for (std::size_t place = 0; place < this->data_.places.size(); ++place)
  {
    if (const double share = this->shares_[place + 1]; share > 0.0)
    {
      const NodeBoxes& there = this->data_.places[place].nodes[index];
      low += share * PlaceBox(there.low_W[0].data());
      high += share * PlaceBox(there.high_W[0].data());
    }
  }
  return node;
}

Box BentNodes::bounds() const noexcept
{
  Box box{ this->shares_[0] * this->data_.low_W, this->shares_[0] * this->data_.high_W };
  for (std::size_t place = 0; place < this->data_.places.size(); ++place)
  {
    box.low_W += this->shares_[place + 1] * this->data_.places[place].all.low_W;
    box.high_W += this->shares_[place + 1] * this->data_.places[place].all.high_W;
  }
  box.low_W.array() -= this->rounding_u_;
  box.high_W.array() += this->rounding_u_;
  return box;
}

DiscQuad discsOf(const BentSurface& s, std::size_t quad) noexcept
{
  const std::array<double, 3> shares = s.shares();
  const SurfaceData& data = s.data();
  DiscQuad balls = data.discs[quad];
  using Lanes = Eigen::Map<Eigen::Array4f>;
  using PlaceLanes = Eigen::Map<const Eigen::Array4f>;
  const auto mix = [&](std::array<float, 4> DiscQuad::*to, std::array<float, 4> BallQuad::*from)
  {
    Lanes lanes((balls.*to).data());
    lanes *= static_cast<float>(shares[0]);
    for (std::size_t place = 0; place < data.places.size(); ++place)
    {
      lanes += static_cast<float>(shares[place + 1]) * PlaceLanes((data.places[place].balls[quad].*from).data());
    }
  };
  mix(&DiscQuad::cx, &BallQuad::cx);
  mix(&DiscQuad::cy, &BallQuad::cy);
  mix(&DiscQuad::cz, &BallQuad::cz);
  mix(&DiscQuad::radius, &BallQuad::radius);
  balls.nx = balls.ny = balls.nz = {};
  return balls;
}

bool hasArea(const BentSurface& s, const FaceRecord& face) noexcept
{
  constexpr float certainly = 1e9F; // the normal's rounding leaves no doubt below
  const auto& [a, b, c] = face.corner_W;
  return !s.bends() || face.sliver < certainly || !exactlyCollinear(a, b, c);
}

} // namespace palpate
