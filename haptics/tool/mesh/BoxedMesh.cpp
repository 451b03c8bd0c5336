// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/mesh/BoxedMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
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
/// Nodes with more triangles are cut in two halves of their longest side: their boxes are as thick as the body,
/// wherever they are cut, and to weigh the cuts of a million triangles takes seconds.
constexpr std::uint32_t largestWeighed = 2000;
constexpr int binCount = 16;              // along an axis: a cut lies between two of them
constexpr double thinnest = 0.1;          // of the longest axis: a thinner one is not cut
constexpr std::uint32_t smallestPart = 8; // an eighth of the triangles, so that the tree is not deep

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
  [[nodiscard]] Mat3 covariance() const
  {
    const Vec3 mean = this->first / this->area;
    return this->second / this->area - mean * mean.transpose();
  }
  [[nodiscard]] Mat3 axes() const
  {
    const Mat3 covariance = this->covariance();
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
  /// How large its box is [u^2]: the box's faces, and its volume, so that two thin boxes count less than two thick ones
  /// of equal faces. `length_u`: of the box that is cut.
  [[nodiscard]] double boxCost(double length_u) const
  {
    constexpr double thickness = 3.0; // 1 to 10 make no difference
    const Mat3 c = this->covariance();
    const double faces4 = c(0, 0) * c(1, 1) + c(1, 1) * c(2, 2) + c(2, 2) * c(0, 0) - c(0, 1) * c(0, 1) -
                          c(1, 2) * c(1, 2) - c(2, 0) * c(2, 0);
    const double volume_u3 = std::sqrt(std::max(0.0, c.determinant()));
    return std::sqrt(std::max(0.0, faces4)) + thickness * std::sqrt(volume_u3 * length_u);
  }
};

/// Triangles of one of the equal parts of a node's extent along an axis.
struct Bin
{
  Spread spread;
  std::uint32_t count = 0;

  void operator+=(const Bin& more)
  {
    this->spread += more.spread;
    this->count += more.count;
  }
};

/// The parts of a node along one of its axes.
struct BinnedAxis
{
  Vec3 axis = Vec3::Zero();
  double low_u = std::numeric_limits<double>::infinity(), high_u = -low_u;
  std::array<Bin, binCount> bins;

  [[nodiscard]] double length_u() const { return this->high_u - this->low_u; }
  [[nodiscard]] int binOf(const Vec3& p) const
  {
    const double share = (this->axis.dot(p) - this->low_u) / this->length_u();
    return std::clamp(static_cast<int>(share * binCount), 0, binCount - 1);
  }
};

/// Where to cut a node.
struct Cut
{
  int axis = -1; ///< none found
  int bin = 0;   ///< the first of the second half
  Bin low, high;
  double cost = std::numeric_limits<double>::infinity();
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
    const auto count = static_cast<std::uint32_t>(this->order_.size());
    this->build(0, count, this->spreadOf(0, count));
  }

  [[nodiscard]] const std::vector<std::uint32_t>& order() const noexcept { return this->order_; }

private:
  using Things = std::span<std::uint32_t>;

  void build(std::uint32_t first, std::uint32_t count, const Spread& spread)
  {
    const std::uint32_t node = static_cast<std::uint32_t>(this->nodes_.size());
    this->nodes_.emplace_back();
    const Mat3 axes = spread.axes();
    this->nodes_[node].box = this->boxOf(axes, first, count);
    if (this->isLeaf(first, count))
    {
      this->nodes_[node].second = first;
      this->nodes_[node].count = count;
      return;
    }
    const auto [low, high] = this->cut(Things(this->order_).subspan(first, count), axes, spread);
    this->build(first, low.count, low.spread);
    this->nodes_[node].second = static_cast<std::uint32_t>(this->nodes_.size());
    this->build(first + low.count, high.count, high.spread);
  }

  /// Orders the triangles by halves: where the boxes of both are smallest, in small nodes.
  std::pair<Bin, Bin> cut(Things things, const Mat3& axes, const Spread& spread)
  {
    if (things.size() <= largestWeighed)
    {
      const std::array<BinnedAxis, 3> binned = this->binned(things, axes);
      const Cut best = bestCut(binned, static_cast<std::uint32_t>(things.size()), spread);
      if (best.axis >= 0)
      {
        std::stable_partition(things.begin(), things.end(),
          [&](std::uint32_t t) { return binned[best.axis].binOf(this->middles_[t]) < best.bin; });
        return { best.low, best.high };
      }
    }
    const auto half = static_cast<std::uint32_t>(
      splitAtMedian(things, [this](std::uint32_t t) -> const Vec3& { return this->middles_[t]; }));
    const auto first = static_cast<std::uint32_t>(things.data() - this->order_.data());
    const auto rest = static_cast<std::uint32_t>(things.size()) - half;
    return { { this->spreadOf(first, half), half }, { this->spreadOf(first + half, rest), rest } };
  }

  [[nodiscard]] std::array<BinnedAxis, 3> binned(Things things, const Mat3& axes) const
  {
    std::array<BinnedAxis, 3> binned;
    for (int k = 0; k < 3; ++k)
    {
      binned[k].axis = axes.col(k);
      for (const std::uint32_t t : things)
      {
        const double height = binned[k].axis.dot(this->middles_[t]);
        binned[k].low_u = std::min(binned[k].low_u, height);
        binned[k].high_u = std::max(binned[k].high_u, height);
      }
    }
    const auto longest = std::ranges::max_element(binned, {}, &BinnedAxis::length_u);
    const double least_u = thinnest * longest->length_u();
    for (const std::uint32_t t : things)
    {
      const Bin one{ this->spreadOf(t), 1 };
      for (BinnedAxis& axis : binned)
      {
        if (axis.length_u() > least_u)
        {
          axis.bins[axis.binOf(this->middles_[t])] += one;
        }
      }
    }
    return binned;
  }

  static Cut bestCut(const std::array<BinnedAxis, 3>& binned, std::uint32_t count, const Spread& spread)
  {
    const std::uint32_t least = std::max(1u, count / smallestPart);
    const double length_u = std::sqrt(spread.covariance().trace());
    Cut best;
    for (int k = 0; k < 3; ++k)
    {
      if (binned[k].bins[0].count == 0) // too thin to be cut
      {
        continue;
      }
      std::array<Bin, binCount> above; // all from this one on
      std::partial_sum(binned[k].bins.rbegin(), binned[k].bins.rend(), above.rbegin(),
        [](Bin sum, const Bin& more) { return sum += more, sum; });
      Bin low;
      for (int bin = 1; bin < binCount; ++bin)
      {
        low += binned[k].bins[bin - 1];
        const Bin& high = above[bin];
        if (binned[k].bins[bin - 1].count > 0 && std::min(low.count, high.count) >= least)
        {
          const double cost = low.count * low.spread.boxCost(length_u) + high.count * high.spread.boxCost(length_u);
          best = cost < best.cost ? Cut{ k, bin, low, high, cost } : best;
        }
      }
    }
    return best;
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

  [[nodiscard]] Spread spreadOf(std::uint32_t first, std::uint32_t count) const
  {
    Spread spread;
    for (std::uint32_t i = first; i < first + count; ++i)
    {
      spread += this->spreadOf(this->order_[i]);
    }
    return spread;
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
