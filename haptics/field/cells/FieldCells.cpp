// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/cells/FieldCells.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "haptics/core/WordHash.h"
#include "haptics/geometry/tree/MedianSplit.h"

namespace palpate
{
namespace
{

constexpr std::size_t inLeaf = 8; ///< cells: fewer boxes than cells, and few cells to look into

constexpr double onRim = 1e-9; ///< of a cell's length: a place that is so near to a cell is in it

/// The corners of a face, its two other axes in their order.
constexpr std::array<std::array<std::size_t, 4>, 6> cornersOfFace{ { { 0, 2, 4, 6 }, { 1, 3, 5, 7 }, { 0, 1, 4, 5 },
  { 2, 3, 6, 7 }, { 0, 1, 2, 3 }, { 4, 5, 6, 7 } } };

using FaceIds = std::array<std::uint32_t, 4>;

FaceIds idsOf(const CellCorners& corners, int face) noexcept
{
  FaceIds ids{};
  std::ranges::transform(cornersOfFace[face], ids.begin(), [&](std::size_t i) { return corners[i]; });
  return ids;
}

/// Which points a face has, each once, rising; no face where they are less than three.
FaceIds nameOf(FaceIds ids) noexcept
{
  std::ranges::sort(ids);
  std::fill(std::unique(ids.begin(), ids.end()), ids.end(), FieldCells::none);
  return ids;
}

struct NamedFace
{
  FaceIds name{};
  std::uint32_t at = 0; ///< six times its cell and its number

  friend auto operator<=>(const NamedFace&, const NamedFace&) = default;
};

/// Where on a face a place is whose shares of the corners are known by their points.
std::array<double, 2> onFace(const FaceIds& ids, const FaceIds& from, const std::array<double, 2>& at) noexcept
{
  const double u = at[0], v = at[1];
  const std::array<double, 4> weights{ (1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v };
  const auto share = [&](std::uint32_t id)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      sum += from[i] == id ? weights[i] : 0.0;
    }
    return sum;
  };
  // Of a triangle the two corners that are one are an edge of the square.
  constexpr double atCorner = 1e-300;
  for (const std::size_t k : { 0U, 1U })
  {
    const std::size_t along = std::size_t{ 1 } << k, other = std::size_t{ 2 } >> k;
    for (const std::size_t side : { std::size_t{ 0 }, other })
    {
      if (ids[side] == ids[side + along])
      {
        const double tip = share(ids[side]), low = share(ids[other - side]), high = share(ids[other - side + along]);
        std::array<double, 2> found{};
        found[1 - k] = side == 0 ? 1.0 - tip : tip;
        found[k] = low + high > atCorner ? high / (low + high) : 0.5;
        return found;
      }
    }
  }
  // A square is turned or mirrored: where its first corner is, and the direction of its first axis.
  const auto position = [&ids](std::uint32_t id)
  { return static_cast<std::size_t>(std::ranges::find(ids, id) - ids.begin()); };
  const std::size_t first = position(from[0]), second = position(from[1]);
  const bool swapped = (first ^ second) == 2;
  const double x = swapped ? v : u, y = swapped ? u : v;
  return { (first & 1) != 0 ? 1.0 - x : x, (first & 2) != 0 ? 1.0 - y : y };
}

/// Puts cells in an order in which both halves of any part of a tree lie together.
void orderByTree(std::span<std::uint32_t> cells, const std::vector<Vec3>& middles_W)
{
  if (cells.size() <= inLeaf)
  {
    return;
  }
  const std::size_t half = splitAtMedian(cells, [&](std::uint32_t cell) -> const Vec3& { return middles_W[cell]; });
  orderByTree(cells.first(half), middles_W);
  orderByTree(cells.subspan(half), middles_W);
}

/// Points that a cell has, in the order in which cells name them first.
void keepUsedPoints(CellParts& parts)
{
  std::vector<std::uint32_t> now(parts.points_W.size(), FieldCells::none);
  std::vector<Vec3> points_W;
  std::vector<float> values;
  for (CellCorners& corners : parts.corners)
  {
    for (std::uint32_t& corner : corners)
    {
      if (now[corner] == FieldCells::none)
      {
        now[corner] = static_cast<std::uint32_t>(points_W.size());
        points_W.push_back(parts.points_W[corner]);
        values.push_back(parts.values[corner]);
      }
      corner = now[corner];
    }
  }
  points_W.shrink_to_fit();
  values.shrink_to_fit();
  parts.points_W = std::move(points_W);
  parts.values = std::move(values);
}

bool isWhole(const CellParts& parts, const CellCorners& corners)
{
  return std::ranges::all_of(
    corners, [&](std::uint32_t i) { return std::isfinite(parts.values[i]) && parts.points_W[i].allFinite(); });
}

std::uint64_t hashOf(const CellParts& parts) noexcept
{
  WordHash hash;
  const auto addPlace = [&hash](const Vec3& p_W) { std::ranges::for_each(p_W, [&](double v) { hash.add(v); }); };
  std::ranges::for_each(parts.points_W, addPlace);
  for (const float value : parts.values)
  {
    hash.add(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(value)));
  }
  for (const CellCorners& corners : parts.corners)
  {
    std::ranges::for_each(corners, [&](std::uint32_t i) { hash.add(static_cast<std::uint64_t>(i)); });
  }
  hash.add(parts.offset);
  addPlace(parts.centre_W);
  hash.add(parts.reach_u);
  return hash.value();
}

/// Nodes of a tree over that many cells, numbered as a heap is.
std::size_t nodesOf(std::size_t cells) noexcept
{
  std::size_t nodes = 1;
  for (; cells > inLeaf; cells -= cells / 2)
  {
    nodes = 2 * nodes + 1;
  }
  return nodes;
}

/// A part of the tree.
struct TreePart
{
  std::size_t node = 0, first = 0, count = 0;

  [[nodiscard]] bool isLeaf() const noexcept { return this->count <= inLeaf; }
  [[nodiscard]] TreePart low() const noexcept { return { 2 * this->node + 1, this->first, this->count / 2 }; }
  [[nodiscard]] TreePart high() const noexcept
  {
    return { 2 * this->node + 2, this->first + this->count / 2, this->count - this->count / 2 };
  }
};

} // namespace

std::shared_ptr<const FieldCells> FieldCells::make(CellParts parts)
{
  std::erase_if(parts.corners, [&](const CellCorners& corners) { return !isWhole(parts, corners); });
  std::vector<Vec3> middles_W(parts.corners.size(), Vec3::Zero());
  for (std::size_t i = 0; i < middles_W.size(); ++i)
  {
    std::ranges::for_each(parts.corners[i], [&](std::uint32_t corner) { middles_W[i] += parts.points_W[corner]; });
  }
  std::vector<std::uint32_t> order(parts.corners.size());
  std::iota(order.begin(), order.end(), 0U);
  orderByTree(order, middles_W);
  std::vector<CellCorners> ordered(order.size());
  std::ranges::transform(order, ordered.begin(), [&](std::uint32_t i) { return parts.corners[i]; });
  parts.corners = std::move(ordered);
  keepUsedPoints(parts);
  return parts.corners.empty() ? nullptr : std::make_shared<const FieldCells>(std::move(parts));
}

FieldCells::FieldCells(CellParts ordered) : parts_(std::move(ordered)), contentHash_(hashOf(this->parts_))
{
  this->joinFaces();
  this->boundTree();
}

void FieldCells::joinFaces()
{
  const std::vector<CellCorners>& corners = this->parts_.corners;
  std::vector<NamedFace> faces;
  faces.reserve(6 * corners.size());
  for (std::size_t i = 0; i < 6 * corners.size(); ++i)
  {
    const FaceIds name = nameOf(idsOf(corners[i / 6], static_cast<int>(i % 6)));
    if (name[2] != none)
    {
      faces.push_back({ name, static_cast<std::uint32_t>(i) });
    }
  }
  std::ranges::sort(faces);
  Faces alone;
  alone.fill(none);
  this->beyond_.assign(corners.size(), alone);
  for (std::size_t i = 0; i + 1 < faces.size(); ++i)
  {
    if (faces[i].name == faces[i + 1].name)
    {
      const std::uint32_t one = faces[i].at, other = faces[i + 1].at;
      this->beyond_[one / 6][one % 6] = other;
      this->beyond_[other / 6][other % 6] = one;
      ++i;
    }
  }
}

void FieldCells::boundTree()
{
  const std::vector<CellCorners>& corners = this->parts_.corners;
  this->boxes_.resize(nodesOf(corners.size()));
  const auto bound = [&](const auto& self, const TreePart& part) -> const Eigen::AlignedBox3d&
  {
    Eigen::AlignedBox3d& box = this->boxes_[part.node];
    if (!part.isLeaf())
    {
      box = self(self, part.low()).merged(self(self, part.high()));
      return box;
    }
    for (std::size_t i = part.first; i < part.first + part.count; ++i)
    {
      std::ranges::for_each(corners[i], [&](std::uint32_t corner) { box.extend(this->parts_.points_W[corner]); });
    }
    const Vec3 more = Vec3::Constant(onRim * box.diagonal().norm());
    box = { box.min() - more, box.max() + more };
    return box;
  };
  bound(bound, { 0, 0, corners.size() });
}

std::size_t FieldCells::bytes() const noexcept
{
  return sizeof(FieldCells) + this->parts_.points_W.size() * (sizeof(Vec3) + sizeof(float)) +
         this->parts_.corners.size() * (sizeof(CellCorners) + sizeof(Faces)) +
         this->boxes_.size() * sizeof(Eigen::AlignedBox3d);
}

CellMap FieldCells::map(const GridIndex& cell) const noexcept
{
  std::array<Vec3, 8> corners_W;
  const CellCorners& corners = this->parts_.corners[static_cast<std::size_t>(cell[0])];
  std::ranges::transform(corners, corners_W.begin(), [this](std::uint32_t i) { return this->parts_.points_W[i]; });
  return CellMap(corners_W);
}

TrilinearCell FieldCells::cell(const GridIndex& at, double level, double sign) const noexcept
{
  TrilinearCell cell;
  const CellCorners& corners = this->parts_.corners[static_cast<std::size_t>(at[0])];
  const double less = level - this->parts_.offset;
  std::ranges::transform(
    corners, cell.corner.begin(), [&](std::uint32_t i) { return sign * (this->parts_.values[i] - less); });
  return cell;
}

std::optional<GridPlace> FieldCells::locate(const Vec3& p_W, int other) const noexcept
{
  constexpr std::size_t mostParts = 64, mostLooks = 512; // a tree of 2^32 cells; cells that overlap a place by far
  std::array<TreePart, mostParts> left;
  std::size_t count = 0;
  left[count++] = { 0, 0, this->parts_.corners.size() };
  for (std::size_t look = 0; count > 0 && look < mostLooks; ++look)
  {
    const TreePart part = left[--count];
    if (!this->boxes_[part.node].contains(p_W))
    {
      continue;
    }
    if (!part.isLeaf())
    {
      left[count++] = part.high();
      left[count++] = part.low();
      continue;
    }
    for (int i = static_cast<int>(part.first); i < static_cast<int>(part.first + part.count); ++i)
    {
      const CellMap map = this->map({ i, 0, 0 });
      Eigen::AlignedBox3d box;
      std::ranges::for_each(map.corners_W(), [&box](const Vec3& corner_W) { box.extend(corner_W); });
      const bool may = i != other && box.exteriorDistance(p_W) <= onRim * map.size_u();
      const std::optional<Vec3> t = may ? map.find(p_W, Vec3::Constant(0.5)) : std::nullopt;
      if (t && isInCell(*t, onRim))
      {
        return GridPlace{ { i, 0, 0 }, t->cwiseMax(0.0).cwiseMin(1.0) };
      }
    }
  }
  return {};
}

std::optional<GridPlace> FieldCells::across(const GridPlace& place, int face) const noexcept
{
  const auto cell = static_cast<std::size_t>(place.cell[0]);
  const std::uint32_t beyond = this->beyond_[cell][static_cast<std::size_t>(face)];
  if (beyond == none)
  {
    return {};
  }
  const auto others = [](int axis) { return std::array<int, 2>{ axis == 0 ? 1 : 0, axis == 2 ? 1 : 2 }; };
  const int there = static_cast<int>(beyond % 6);
  const std::array<int, 2> from = others(face / 2), to = others(there / 2);
  const std::array<double, 2> at = onFace(idsOf(this->parts_.corners[beyond / 6], there),
    idsOf(this->parts_.corners[cell], face), { place.t[from[0]], place.t[from[1]] });
  GridPlace next{ { static_cast<int>(beyond / 6), 0, 0 } };
  next.t[there / 2] = there % 2;
  next.t[to[0]] = at[0];
  next.t[to[1]] = at[1];
  return next;
}

} // namespace palpate
