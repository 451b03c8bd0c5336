// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/FeatureHand.h"

#include <algorithm>
#include <cmath>

namespace palpate::test
{
namespace
{

constexpr int longestStroke = 100;
constexpr double stays = 0.8; ///< share of strokes that go on where the last one was

/// The power of two next below: sums of few such numbers are exact.
double exactlyHalvable(double length)
{
  return std::exp2(std::floor(std::log2(length)));
}

} // namespace

FeatureHand::FeatureHand(const TriangleMesh& mesh, std::uint64_t seed) : mesh_(mesh), random_(seed)
{
  Vec3 low_W = mesh.vertices_W.at(mesh.triangles.at(0)[0]), high_W = low_W;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const Vec3 &va = mesh.vertices_W[a], &vb = mesh.vertices_W[b], &vc = mesh.vertices_W[c];
    low_W = low_W.cwiseMin(va).cwiseMin(vb).cwiseMin(vc);
    high_W = high_W.cwiseMax(va).cwiseMax(vb).cwiseMax(vc);
    this->triangle_u_ += ((vb - va).norm() + (vc - vb).norm() + (va - vc).norm()) / 3;
  }
  this->triangle_u_ /= static_cast<double>(mesh.triangles.size());
  this->size_u_ = (high_W - low_W).maxCoeff();
  this->middle_W_ = (low_W + high_W) / 2;
}

Vec3 FeatureHand::next()
{
  if (this->tick_ > this->ticks_)
  {
    this->beginStroke();
  }
  const Vec3 p_W = this->from_W_ + this->tick_ * this->step_W_ + this->random_.inCube(this->shake_u_);
  ++this->tick_;
  return p_W;
}

void FeatureHand::beginStroke()
{
  if (this->random_.uniform() > stays)
  {
    this->triangle_ = this->random_.below(static_cast<std::uint32_t>(this->mesh_.triangles.size()));
  }
  this->tick_ = 0;
  this->shake_u_ = 0.0;
  switch (this->random_.below(6))
  {
    case 0:
      return this->passExactly();
    case 1:
      return this->followEdge();
    case 2:
      return this->tremble();
    case 3:
      return this->shoot();
    default:
      return this->glide();
  }
}

/// From beside a feature to beside one nearby, in equal steps.
void FeatureHand::glide()
{
  const double depth_u = this->stepWithin(-2, 1);
  this->from_W_ = this->somePlace() + depth_u * this->random_.direction();
  const Vec3 way = this->somePlace() + depth_u * this->random_.direction() - this->from_W_;
  const double ticks = std::ceil(way.norm() / this->stepWithin(-2, 3));
  this->ticks_ = static_cast<int>(std::clamp(ticks, 1.0, static_cast<double>(longestStroke)));
  this->step_W_ = way / this->ticks_;
}

/// Along a direction of whole numbers through a vertex or the middle of an edge, which one tick meets or two ticks have
/// between them.
void FeatureHand::passExactly()
{
  const Edge edge = this->someEdge();
  const Vec3 at_W = this->random_.below(2) == 0 ? edge.from_W : Vec3((edge.from_W + edge.to_W) / 2);
  this->step_W_ = exactlyHalvable(this->stepWithin(-2, 1)) * this->latticeDirection();
  const int before = static_cast<int>(1 + this->random_.below(8));
  this->from_W_ = at_W - (before - 0.5 * this->random_.below(2)) * this->step_W_;
  this->ticks_ = 2 * before;
}

/// Along an edge and beyond both of its ends: on it, or beside it by a whole number of equal steps.
void FeatureHand::followEdge()
{
  const Edge edge = this->someEdge();
  const double beside_u = this->random_.below(3) * exactlyHalvable(this->stepWithin(-3, 0));
  this->step_W_ = (edge.to_W - edge.from_W) / 8;
  this->from_W_ = edge.from_W - 4 * this->step_W_ + beside_u * this->latticeDirection();
  this->ticks_ = 16;
}

/// About one place, by anything from roundings to the size of a triangle.
void FeatureHand::tremble()
{
  const double depth_u = this->stepWithin(-3, 0);
  this->from_W_ = this->somePlace() + depth_u * this->random_.direction();
  this->step_W_.setZero();
  this->shake_u_ = depth_u * std::pow(10.0, this->random_.uniform(-13, 1));
  this->ticks_ = 20;
}

/// Straight through the whole, in one tick or two, from up to a thousand triangles or thirty sizes away.
void FeatureHand::shoot()
{
  const double length_u = std::min(this->stepWithin(0, 3), 30 * this->size_u_);
  const Vec3 aim_W = this->somePlace();
  const Vec3 way = length_u * this->random_.direction();
  this->from_W_ = aim_W - this->random_.uniform() * way;
  this->step_W_ = this->random_.uniform(0.5, 1.0) * way;
  this->ticks_ = static_cast<int>(this->random_.below(3));
}

FeatureHand::Edge FeatureHand::someEdge()
{
  const auto& corners = this->mesh_.triangles[this->triangle_];
  const std::uint32_t k = this->random_.below(3);
  return { this->mesh_.vertices_W[corners[k]], this->mesh_.vertices_W[corners[(k + 1) % 3]] };
}

/// A vertex, a point of an edge or one of the face that it is at, each in a third of the cases.
Vec3 FeatureHand::somePlace()
{
  const Edge edge = this->someEdge();
  switch (this->random_.below(3))
  {
    case 0:
      return edge.from_W;
    case 1:
      return edge.from_W + this->random_.uniform() * (edge.to_W - edge.from_W);
    default:
    {
      const Edge other = this->someEdge();
      const Vec3 a = edge.from_W + this->random_.uniform() * (edge.to_W - edge.from_W);
      return a + this->random_.uniform() * (other.to_W - a);
    }
  }
}

Vec3 FeatureHand::latticeDirection()
{
  for (;;)
  {
    const Vec3 direction(this->random_.below(5) - 2.0, this->random_.below(5) - 2.0, this->random_.below(5) - 2.0);
    if (direction != Vec3::Zero())
    {
      return this->random_.below(2) == 0 ? direction : Vec3(0, 0, this->random_.below(2) == 0 ? 1.0 : -1.0);
    }
  }
}

/// A length in triangles, its logarithm spread evenly.
double FeatureHand::stepWithin(double low10, double high10)
{
  return this->triangle_u_ * std::pow(10.0, this->random_.uniform(low10, high10));
}

} // namespace palpate::test
