// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/mesh/ThinTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "haptics/geometry/tree/MedianSplit.h"
#include "haptics/tool/mesh/Spread.h"

namespace palpate
{
namespace
{

constexpr std::uint32_t largestLeaf = 4;
constexpr double leafAgreement = 0.9; // cosine: normals that differ more have no separating plane in common
/// Nodes with more triangles are cut in two halves of their longest side: their boxes are as thick as the body,
/// wherever they are cut.
constexpr std::uint32_t largestWeighed = 2000;
constexpr int binCount = 16;              // along an axis: a cut lies between two of them
constexpr double thinnest = 0.1;          // of the longest axis: a thinner one is not cut
constexpr std::uint32_t smallestPart = 8; // an eighth of the triangles, so that the tree is not deep

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
  double low_u, high_u;
  bool isCut = false; ///< else too thin for it
  std::array<Bin, binCount> bins;

  [[nodiscard]] double length_u() const { return this->high_u - this->low_u; }
  [[nodiscard]] int binOf(double height_u) const
  {
    const double share = (height_u - this->low_u) / this->length_u();
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

std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, std::uint32_t t)
{
  const auto [a, b, c] = mesh.triangles[t];
  return { mesh.vertices_W[a], mesh.vertices_W[b], mesh.vertices_W[c] };
}

Vec3 middleOf(const std::array<Vec3, 3>& corners)
{
  return (corners[0] + corners[1] + corners[2]) / 3.0;
}

/// The tree of few triangles. Copies of them stand side by side here, as each level looks at all of them.
class SmallTree
{
public:
  explicit SmallTree(std::vector<BoxedMesh::Node>& nodes) : nodes_(nodes) {}

  /// Adds the nodes of these triangles, of which the first one in order becomes number `first`, and puts them in order.
  Spread add(const TriangleMesh& mesh, std::span<std::uint32_t> triangles, std::uint32_t first)
  {
    const auto count = static_cast<std::uint32_t>(triangles.size());
    this->first_ = first;
    this->order_.resize(count);
    std::iota(this->order_.begin(), this->order_.end(), 0u);
    this->corners_.resize(count);
    this->middles_.resize(count);
    this->spreads_.resize(count);
    this->heights_.resize(count);
    this->bins_.resize(count);
    this->moved_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i)
    {
      this->corners_[i] = cornersOf(mesh, triangles[i]);
      this->middles_[i] = middleOf(this->corners_[i]);
      this->spreads_[i] = Spread(this->corners_[i], mesh.vertices_W.front());
    }
    const Spread spread = this->spreadOf(this->order_);
    this->build(0, count, spread);
    std::ranges::transform(this->order_, this->moved_.begin(), [&](std::uint32_t i) { return triangles[i]; });
    std::ranges::copy(this->moved_, triangles.begin());
    return spread;
  }

private:
  using Things = std::span<std::uint32_t>;

  void build(std::uint32_t first, std::uint32_t count, const Spread& spread)
  {
    const auto node = static_cast<std::uint32_t>(this->nodes_.size());
    const Things things = Things(this->order_).subspan(first, count);
    const Mat3 axes = spread.axes();
    this->nodes_.emplace_back();
    this->nodes_[node].box = this->boxOf(axes, things);
    if (this->isLeaf(things))
    {
      this->nodes_[node].second = this->first_ + first;
      this->nodes_[node].count = count;
      return;
    }
    const auto [low, high] = this->cut(things, axes, spread);
    this->build(first, low.count, low.spread);
    this->nodes_[node].second = static_cast<std::uint32_t>(this->nodes_.size());
    this->build(first + low.count, high.count, high.spread);
  }

  /// Orders the triangles by parts: where the boxes of both are smallest, or by halves.
  std::pair<Bin, Bin> cut(Things things, const Mat3& axes, const Spread& spread)
  {
    this->fillBins(things, axes);
    const Cut best = this->bestCut(static_cast<std::uint32_t>(things.size()), spread.length_u());
    if (best.axis >= 0)
    {
      this->part(things, best);
      return { best.low, best.high };
    }
    const std::size_t half =
      splitAtMedian(things, [this](std::uint32_t i) -> const Vec3& { return this->middles_[i]; });
    const auto binOf = [this](Things part) {
      return Bin{ this->spreadOf(part), static_cast<std::uint32_t>(part.size()) };
    };
    return { binOf(things.first(half)), binOf(things.subspan(half)) };
  }

  void fillBins(Things things, const Mat3& axes)
  {
    Vec3 low_u = Vec3::Constant(std::numeric_limits<double>::infinity()), high_u = -low_u;
    for (std::size_t i = 0; i < things.size(); ++i)
    {
      const Vec3& p = this->middles_[things[i]];
      this->heights_[i] = { axes.col(0).dot(p), axes.col(1).dot(p), axes.col(2).dot(p) };
      low_u = low_u.cwiseMin(this->heights_[i]);
      high_u = high_u.cwiseMax(this->heights_[i]);
    }
    const double least_u = thinnest * (high_u - low_u).maxCoeff();
    for (int k = 0; k < 3; ++k)
    {
      BinnedAxis& axis = this->binned_[static_cast<std::size_t>(k)];
      axis.low_u = low_u[k];
      axis.high_u = high_u[k];
      axis.isCut = axis.length_u() > least_u;
      if (axis.isCut)
      {
        this->fillBins(things, axis, k);
      }
    }
  }

  void fillBins(Things things, BinnedAxis& axis, int k)
  {
    axis.bins.fill({});
    for (std::size_t i = 0; i < things.size(); ++i)
    {
      const int bin = axis.binOf(this->heights_[i][k]);
      this->bins_[i][static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(bin);
      axis.bins[static_cast<std::size_t>(bin)] += { this->spreads_[things[i]], 1 };
    }
  }

  [[nodiscard]] Cut bestCut(std::uint32_t count, double length_u) const
  {
    const std::uint32_t least = std::max(1u, count / smallestPart);
    Cut best;
    for (int k = 0; k < 3; ++k)
    {
      const BinnedAxis& axis = this->binned_[static_cast<std::size_t>(k)];
      if (axis.isCut)
      {
        improve(best, axis.bins, k, least, length_u);
      }
    }
    return best;
  }

  static void improve(Cut& best, const std::array<Bin, binCount>& bins, int axis, std::uint32_t least, double length_u)
  {
    std::array<Bin, binCount> above; // all beyond this one
    Bin beyond;
    for (std::size_t bin = binCount; bin-- > 0;)
    {
      if (bins[bin].count > 0) // most are empty in most nodes
      {
        above[bin] = beyond;
        beyond += bins[bin];
      }
    }
    Bin low;
    for (std::size_t bin = 0; bin < binCount; ++bin)
    {
      if (bins[bin].count == 0)
      {
        continue;
      }
      low += bins[bin];
      const Bin& high = above[bin];
      if (std::min(low.count, high.count) >= least)
      {
        const Eigen::Array2d costs = boxCosts(low.spread, high.spread, length_u);
        const double cost = low.count * costs[0] + high.count * costs[1];
        if (cost < best.cost)
        {
          best = { axis, static_cast<int>(bin) + 1, low, high, cost };
        }
      }
    }
  }

  /// Those below the cut first, each part in its order.
  void part(Things things, const Cut& cut)
  {
    std::size_t below = 0, above = 0;
    for (std::size_t i = 0; i < things.size(); ++i)
    {
      const bool isBelow = this->bins_[i][static_cast<std::size_t>(cut.axis)] < cut.bin;
      (isBelow ? things[below++] : this->moved_[above++]) = things[i];
    }
    std::copy_n(this->moved_.begin(), above, things.begin() + static_cast<std::ptrdiff_t>(below));
  }

  [[nodiscard]] bool isLeaf(Things things) const
  {
    if (things.size() > largestLeaf)
    {
      return false;
    }
    const Vec3 normal = unitNormal(this->corners_[things.front()]);
    return std::ranges::all_of(
      things, [&](std::uint32_t i) { return std::abs(normal.dot(unitNormal(this->corners_[i]))) >= leafAgreement; });
  }

  [[nodiscard]] Spread spreadOf(std::span<const std::uint32_t> things) const
  {
    Spread spread;
    for (const std::uint32_t i : things)
    {
      spread += this->spreads_[i];
    }
    return spread;
  }

  [[nodiscard]] StoredBox boxOf(const Mat3& axes, Things things)
  {
    this->points_.clear();
    for (const std::uint32_t i : things)
    {
      this->points_.insert(this->points_.end(), this->corners_[i].begin(), this->corners_[i].end());
    }
    return { axes, this->points_ };
  }

  std::vector<BoxedMesh::Node>& nodes_;
  std::uint32_t first_ = 0;
  std::vector<std::uint32_t> order_; ///< of the copies
  std::vector<std::array<Vec3, 3>> corners_;
  std::vector<Vec3> middles_;
  std::vector<Spread> spreads_;
  // Of the node that is cut:
  std::array<BinnedAxis, 3> binned_;
  std::vector<Vec3> heights_; ///< of the middles along its axes, in its order
  std::vector<std::array<std::uint8_t, 3>> bins_;
  std::vector<std::uint32_t> moved_;
  std::vector<Vec3> points_;
};

/// The tree of any number of triangles.
class LargeTree
{
public:
  explicit LargeTree(const TriangleMesh& mesh)
    : mesh_(mesh), small_(tree_.nodes), pointOf_(mesh.vertices_W.size(), none)
  {
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    this->tree_.order.resize(count);
    std::iota(this->tree_.order.begin(), this->tree_.order.end(), 0u);
    if (count > largestWeighed)
    {
      this->middles_.reserve(count);
      for (std::uint32_t t = 0; t < count; ++t)
      {
        this->middles_.push_back(middleOf(cornersOf(mesh, t)));
      }
    }
    static_cast<void>(this->build(0, count));
  }

  [[nodiscard]] ThinTree take() { return std::move(this->tree_); }

private:
  Spread build(std::uint32_t first, std::uint32_t count)
  {
    const std::span<std::uint32_t> triangles = std::span(this->tree_.order).subspan(first, count);
    if (count <= largestWeighed)
    {
      this->addPoints(triangles);
      return this->small_.add(this->mesh_, triangles, first);
    }
    const auto node = static_cast<std::uint32_t>(this->tree_.nodes.size());
    const std::size_t firstPoint = this->points_.size();
    this->tree_.nodes.emplace_back();
    const auto half = static_cast<std::uint32_t>(
      splitAtMedian(triangles, [this](std::uint32_t t) -> const Vec3& { return this->middles_[t]; }));
    Spread spread = this->build(first, half);
    this->tree_.nodes[node].second = static_cast<std::uint32_t>(this->tree_.nodes.size());
    spread += this->build(first + half, count - half);
    this->tree_.nodes[node].box = { spread.axes(), std::span<const Vec3>(this->points_).subspan(firstPoint) };
    return spread;
  }

  /// Vertices of a small tree, each of them once: the points of the large nodes above are those of their small trees.
  void addPoints(std::span<const std::uint32_t> triangles)
  {
    const std::size_t first = this->points_.size();
    for (const std::uint32_t t : triangles)
    {
      for (const std::uint32_t v : this->mesh_.triangles[t])
      {
        if (this->pointOf_[v] == none || this->pointOf_[v] < first)
        {
          this->pointOf_[v] = static_cast<std::uint32_t>(this->points_.size());
          this->points_.push_back(this->mesh_.vertices_W[v]);
        }
      }
    }
  }

  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  const TriangleMesh& mesh_;
  ThinTree tree_;
  SmallTree small_;
  std::vector<Vec3> middles_; ///< of triangles
  std::vector<Vec3> points_;
  std::vector<std::uint32_t> pointOf_; ///< the last one of each vertex
};

} // namespace

ThinTree buildThinTree(const TriangleMesh& mesh)
{
  return LargeTree(mesh).take();
}

} // namespace palpate
