// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/mesh/BoxedMesh.h"

#include <cmath>
#include <limits>
#include <utility>

#include "haptics/tool/mesh/FlatFeatures.h"
#include "haptics/tool/mesh/ThinTree.h"

namespace palpate
{

StoredBox::StoredBox(const Mat3& axes, std::span<const Vec3> points)
{
  const Quat turn(axes);
  for (int k = 0; k < 4; ++k)
  {
    this->turn_[k] = static_cast<float>(turn.coeffs()[k]);
  }
  const Mat3 stored = this->box().axes; // as it will be read: the half sides allow for the rounding of the axes
  const Mat3 back = stored.inverse();
  Eigen::AlignedBox3d bounds;
  for (const Vec3& p : points)
  {
    bounds.extend(Vec3(back * (p - points.front())));
  }
  const Vec3 centre = points.front() + stored * bounds.center();
  for (int k = 0; k < 3; ++k)
  {
    this->centre_[k] = static_cast<float>(centre[k]);
  }
  const Vec3 off = back * (this->box().centre - centre);
  const double rounding = 1e-14 * (points.front().cwiseAbs().maxCoeff() + bounds.diagonal().norm());
  for (int k = 0; k < 3; ++k)
  {
    const double half = 0.5 * bounds.sizes()[k] + std::abs(off[k]) + rounding;
    this->half_[k] = std::nextafter(static_cast<float>(half), std::numeric_limits<float>::infinity());
  }
}

/// Not inlined: in the constructor GCC 12 computed with numbers that were not rounded to floats yet, so that boxes
/// did not contain their triangles.
[[gnu::noinline]] OrientedBox StoredBox::box() const noexcept
{
  return { this->centre(), this->turn().toRotationMatrix(), this->half() };
}

BoxedMesh::BoxedMesh(TriangleMesh clean, double flat_u) : mesh_(std::move(clean))
{
  {
    ThinTree tree = buildThinTree(this->mesh_);
    std::vector<std::array<std::uint32_t, 3>> ordered;
    ordered.reserve(tree.order.size());
    for (const std::uint32_t t : tree.order)
    {
      ordered.push_back(this->mesh_.triangles[t]);
    }
    this->mesh_.triangles = std::move(ordered);
    this->nodes_ = std::move(tree.nodes);
  }
  this->nodes_.shrink_to_fit();
  this->flat_ = flatFlags(this->mesh_, flat_u);
}

Vec3 unitNormal(const std::array<Vec3, 3>& corners) noexcept
{
  Vec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
  const double bLong = ab.cwiseAbs().maxCoeff(), cLong = ac.cwiseAbs().maxCoeff();
  ab /= bLong > 0.0 ? bLong : 1.0;
  ac /= cLong > 0.0 ? cLong : 1.0;
  const Vec3 normal = ab.cross(ac);
  const double length = normal.norm();
  return length > 0.0 ? Vec3(normal / length) : Vec3(Vec3::UnitZ());
}

} // namespace palpate
