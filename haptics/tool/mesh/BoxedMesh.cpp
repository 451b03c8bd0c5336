// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/mesh/BoxedMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <Eigen/Eigenvalues>

#include "haptics/geometry/tree/MedianSplit.h"
#include "haptics/tool/mesh/FlatFeatures.h"

namespace palpate
{
namespace
{

constexpr std::uint32_t largestLeaf = 4;
constexpr double leafAgreement = 0.9; // cosine: normals that differ more have no separating plane in common

/// Moments that determine the axes of a box: area, centroid and second moments of triangles.
struct Spread
{
  double area = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();

  void operator+=(const Spread& more)
  {
    this->area += more.area;
    this->first += more.first;
    this->second += more.second;
  }
  [[nodiscard]] Mat3 axes() const
  {
    const Vec3 mean = this->first / this->area;
    const Mat3 covariance = this->second / this->area - mean * mean.transpose();
    const double scale = covariance.cwiseAbs().maxCoeff();
    if (!(scale > 0.0))
    {
      return Mat3::Identity();
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(covariance / scale);
    Mat3 axes;
    axes << solver.eigenvectors().col(2), solver.eigenvectors().col(1), Vec3::Zero();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
  }
};

class Builder
{
public:
  Builder(const TriangleMesh& mesh, std::vector<BoxedMesh::Node>& nodes) : mesh_(mesh), nodes_(nodes)
  {
    this->about_ = mesh.vertices_W.front();
    this->order_.resize(mesh.triangles.size());
    this->middles_.resize(mesh.triangles.size());
    for (std::uint32_t t = 0; t < this->order_.size(); ++t)
    {
      const auto c = this->corners(t);
      this->order_[t] = t;
      this->middles_[t] = (c[0] + c[1] + c[2]) / 3.0;
    }
    this->build(0, static_cast<std::uint32_t>(this->order_.size()));
  }

  [[nodiscard]] const std::vector<std::uint32_t>& order() const noexcept { return this->order_; }

private:
  Spread build(std::uint32_t first, std::uint32_t count)
  {
    const std::uint32_t node = static_cast<std::uint32_t>(this->nodes_.size());
    this->nodes_.emplace_back();
    Spread spread;
    if (this->isLeaf(first, count))
    {
      for (std::uint32_t i = first; i < first + count; ++i)
      {
        spread += this->spreadOf(this->order_[i]);
      }
      this->nodes_[node].second = first;
      this->nodes_[node].count = count;
    }
    else
    {
      const auto half = static_cast<std::uint32_t>(splitAtMedian(std::span(this->order_).subspan(first, count),
        [this](std::uint32_t t) -> const Vec3& { return this->middles_[t]; }));
      spread = this->build(first, half);
      this->nodes_[node].second = static_cast<std::uint32_t>(this->nodes_.size());
      spread += this->build(first + half, count - half);
    }
    this->nodes_[node].box = this->boxOf(spread.axes(), first, count);
    return spread;
  }

  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t t) const
  {
    const auto [a, b, c] = this->mesh_.triangles[t];
    return { this->mesh_.vertices_W[a], this->mesh_.vertices_W[b], this->mesh_.vertices_W[c] };
  }

  [[nodiscard]] bool isLeaf(std::uint32_t first, std::uint32_t count) const
  {
    if (count > largestLeaf)
    {
      return false;
    }
    const Vec3 normal = unitNormal(this->corners(this->order_[first]));
    return std::all_of(this->order_.begin() + first, this->order_.begin() + first + count,
      [&](std::uint32_t t) { return std::abs(normal.dot(unitNormal(this->corners(t)))) >= leafAgreement; });
  }

  [[nodiscard]] Spread spreadOf(std::uint32_t t) const
  {
    auto c = this->corners(t);
    Spread spread;
    spread.area = std::max((c[1] - c[0]).cross(c[2] - c[0]).norm(), std::numeric_limits<double>::min());
    for (Vec3& p : c)
    {
      p -= this->about_;
    }
    const Vec3 sum = c[0] + c[1] + c[2];
    spread.first = spread.area / 3.0 * sum;
    spread.second = sum * sum.transpose();
    for (const Vec3& p : c)
    {
      spread.second += p * p.transpose();
    }
    spread.second *= spread.area / 12.0;
    return spread;
  }

  [[nodiscard]] StoredBox boxOf(const Mat3& axes, std::uint32_t first, std::uint32_t count)
  {
    this->points_.clear();
    for (std::uint32_t i = first; i < first + count; ++i)
    {
      const auto c = this->corners(this->order_[i]);
      this->points_.insert(this->points_.end(), c.begin(), c.end());
    }
    return { axes, this->points_ };
  }

  const TriangleMesh& mesh_;
  std::vector<BoxedMesh::Node>& nodes_;
  Vec3 about_; ///< moments are taken about a point of the mesh, so that far from the origin nothing cancels
  std::vector<std::uint32_t> order_;
  std::vector<Vec3> middles_;
  std::vector<Vec3> points_; ///< kept for its memory
};

} // namespace

StoredBox::StoredBox(const Mat3& axes, const std::vector<Vec3>& points)
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
    const Builder builder(this->mesh_, this->nodes_);
    std::vector<std::array<std::uint32_t, 3>> ordered;
    ordered.reserve(builder.order().size());
    for (const std::uint32_t t : builder.order())
    {
      ordered.push_back(this->mesh_.triangles[t]);
    }
    this->mesh_.triangles = std::move(ordered);
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
