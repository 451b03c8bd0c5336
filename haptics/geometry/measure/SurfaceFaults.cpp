// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/measure/SurfaceFaults.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "haptics/geometry/measure/RayWalk.h"
#include "haptics/geometry/measure/WallThickness.h"

namespace palpate
{
namespace
{

/// An edge of a triangle, with its ends in ascending order.
struct Side
{
  std::uint32_t low, high;
  std::uint32_t triangle;
  bool rising; ///< the triangle runs from the low end to the high one

  [[nodiscard]] bool sameEdge(const Side& other) const { return this->low == other.low && this->high == other.high; }
};

/// For each vertex the first of those at its place.
std::vector<std::uint32_t> weld(const std::vector<Vec3>& vertices_W)
{
  std::vector<std::uint32_t> order(vertices_W.size()), first(vertices_W.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto place = [&](std::uint32_t v)
  { return std::tuple(vertices_W[v].x(), vertices_W[v].y(), vertices_W[v].z()); };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return place(a) < place(b); });
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool again = i > 0 && place(order[i]) == place(order[i - 1]);
    first[order[i]] = again ? first[order[i - 1]] : order[i];
  }
  return first;
}

bool isUsable(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t)
{
  return std::all_of(
    t.begin(), t.end(), [&](std::uint32_t v) { return v < mesh.vertices_W.size() && mesh.vertices_W[v].allFinite(); });
}

/// Sides of all triangles, those of one edge next to each other.
std::vector<Side> sidesOf(const TriangleMesh& mesh, const std::vector<std::uint32_t>& welded)
{
  std::vector<Side> sides;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (!isUsable(mesh, mesh.triangles[t]))
    {
      continue;
    }
    const std::array<std::uint32_t, 3> v = { welded[mesh.triangles[t][0]], welded[mesh.triangles[t][1]],
      welded[mesh.triangles[t][2]] };
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
    {
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t from = v[k], to = v[(k + 1) % 3];
      sides.push_back({ std::min(from, to), std::max(from, to), t, from < to });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    { return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle); });
  return sides;
}

/// Calls visit(first, last) for the sides of each edge.
template<class Visit>
void forEachEdge(const std::vector<Side>& sides, Visit visit)
{
  for (std::size_t i = 0; i < sides.size();)
  {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].sameEdge(sides[i]))
    {
      ++end;
    }
    visit(sides.begin() + static_cast<std::ptrdiff_t>(i), sides.begin() + static_cast<std::ptrdiff_t>(end));
    i = end;
  }
}

/// Which things hang together.
class Groups
{
public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(this->parent_.begin(), this->parent_.end(), 0u); }

  std::uint32_t of(std::uint32_t i)
  {
    while (this->parent_[i] != i)
    {
      i = this->parent_[i] = this->parent_[this->parent_[i]];
    }
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { this->parent_[this->of(a)] = this->of(b); }

private:
  std::vector<std::uint32_t> parent_;
};

std::vector<SurfaceHole> holesOf(const TriangleMesh& mesh, const std::vector<Side>& sides)
{
  std::vector<Side> rim;
  Groups groups(mesh.vertices_W.size());
  forEachEdge(sides,
    [&](auto first, auto last)
    {
      if (last - first == 1)
      {
        rim.push_back(*first);
        groups.join(first->low, first->high);
      }
    });
  std::map<std::uint32_t, SurfaceHole> byGroup;
  for (const Side& side : rim)
  {
    SurfaceHole& hole = byGroup[groups.of(side.low)];
    const double length_u = (mesh.vertices_W[side.high] - mesh.vertices_W[side.low]).norm();
    hole.centre_W += 0.5 * length_u * (mesh.vertices_W[side.low] + mesh.vertices_W[side.high]);
    hole.length_u += length_u;
    hole.vertices.insert(hole.vertices.end(), { side.low, side.high });
    hole.edges.push_back({ side.low, side.high });
  }
  std::vector<SurfaceHole> holes;
  for (auto& [group, hole] : byGroup)
  {
    hole.centre_W /= hole.length_u;
    std::sort(hole.vertices.begin(), hole.vertices.end());
    hole.vertices.erase(std::unique(hole.vertices.begin(), hole.vertices.end()), hole.vertices.end());
    holes.push_back(std::move(hole));
  }
  std::sort(holes.begin(), holes.end(), [](const auto& a, const auto& b) { return a.length_u > b.length_u; });
  return holes;
}

/// Which way triangles are turned: those of a part, which hang together by edges of two, and whether each is turned as
/// the first of them.
class Turns
{
public:
  Turns(const TriangleMesh& mesh, const std::vector<Side>& sides) : part(mesh.triangles.size(), none)
  {
    std::vector<std::vector<std::pair<std::uint32_t, bool>>> beside(mesh.triangles.size());
    this->asFirst.resize(mesh.triangles.size());
    forEachEdge(sides,
      [&](auto first, auto last)
      {
        if (last - first == 2)
        {
          const bool agree = first->rising != (first + 1)->rising;
          beside[first->triangle].emplace_back((first + 1)->triangle, agree);
          beside[(first + 1)->triangle].emplace_back(first->triangle, agree);
        }
      });
    for (const Side& side : sides)
    {
      if (this->part[side.triangle] == none)
      {
        this->spread(side.triangle, beside);
      }
    }
  }

  static constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> part; ///< of each triangle; none: it is passed over
  std::vector<bool> asFirst;
  std::vector<std::vector<std::uint32_t>> members; ///< of each part

private:
  void spread(std::uint32_t from, const std::vector<std::vector<std::pair<std::uint32_t, bool>>>& beside)
  {
    const auto number = static_cast<std::uint32_t>(this->members.size());
    std::vector<std::uint32_t>& found = this->members.emplace_back();
    this->part[from] = number;
    this->asFirst[from] = true;
    found.push_back(from);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      for (const auto& [next, agree] : beside[found[i]])
      {
        if (this->part[next] == none)
        {
          this->part[next] = number;
          this->asFirst[next] = this->asFirst[found[i]] == agree;
          found.push_back(next);
        }
      }
    }
  }
};

/// The volume of a part when all of it is turned as its first triangle, six times; 0 for one with a rim.
double sixVolumesOf(const TriangleMesh& mesh, const Turns& turns, std::uint32_t part)
{
  const Vec3 origin_W = mesh.vertices_W[mesh.triangles[turns.members[part].front()][0]];
  double sum = 0.0;
  for (const std::uint32_t t : turns.members[part])
  {
    const auto& [a, b, c] = mesh.triangles[t];
    const double volume =
      (mesh.vertices_W[a] - origin_W).cross(mesh.vertices_W[b] - origin_W).dot(mesh.vertices_W[c] - origin_W);
    sum += turns.asFirst[t] ? volume : -volume;
  }
  return sum;
}

/// All but one part, to see what encloses that.
std::optional<SurfaceTree> othersThan(const TriangleMesh& mesh, const Turns& turns, std::uint32_t part)
{
  TriangleMesh others{ mesh.vertices_W, {} };
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (turns.part[t] != part && turns.part[t] != Turns::none)
    {
      others.triangles.push_back(mesh.triangles[t]);
    }
  }
  CleanResult clean = cleanMesh(others);
  return clean.ok() ? std::optional<SurfaceTree>(std::in_place, std::move(clean.mesh)) : std::nullopt;
}

/// Whether the first triangle of a part is turned as it should be: outwards, or inwards in a hollow, or as most of a
/// part with a rim.
bool isFirstRight(const TriangleMesh& mesh, const Turns& turns, std::uint32_t part, bool closed)
{
  const auto& members = turns.members[part];
  const auto alike = static_cast<std::size_t>(
    std::count_if(members.begin(), members.end(), [&](std::uint32_t t) { return turns.asFirst[t]; }));
  if (!closed)
  {
    return 2 * alike >= members.size();
  }
  const bool outwards = sixVolumesOf(mesh, turns, part) > 0.0;
  if (turns.members.size() == 1)
  {
    return outwards;
  }
  const std::optional<SurfaceTree> others = othersThan(mesh, turns, part);
  const Vec3& place_W = mesh.vertices_W[mesh.triangles[members.front()][0]];
  const bool hollow = others && sideOf(*others, place_W) == PointSide::Inside;
  return outwards != hollow;
}

std::vector<bool> closedParts(const Turns& turns, const std::vector<Side>& sides)
{
  std::vector<bool> closed(turns.members.size(), true);
  forEachEdge(sides,
    [&](auto first, auto last)
    {
      if (last - first != 2)
      {
        std::for_each(first, last, [&](const Side& side) { closed[turns.part[side.triangle]] = false; });
      }
    });
  return closed;
}

/// Whether each triangle is turned as it should be.
std::vector<bool> rightTurns(const TriangleMesh& mesh, const Turns& turns, const std::vector<Side>& sides)
{
  const std::vector<bool> closed = closedParts(turns, sides);
  std::vector<bool> right(mesh.triangles.size(), true);
  for (std::uint32_t part = 0; part < turns.members.size(); ++part)
  {
    const bool first = isFirstRight(mesh, turns, part, closed[part]);
    for (const std::uint32_t t : turns.members[part])
    {
      right[t] = turns.asFirst[t] == first;
    }
  }
  return right;
}

/// Flipped triangles that share an edge are one part.
std::vector<FlippedPart> flippedOf(
  const TriangleMesh& mesh, const std::vector<Side>& sides, const std::vector<bool>& right)
{
  Groups groups(mesh.triangles.size());
  forEachEdge(sides,
    [&](auto first, auto last)
    {
      if (last - first == 2 && !right[first->triangle] && !right[(first + 1)->triangle])
      {
        groups.join(first->triangle, (first + 1)->triangle);
      }
    });
  std::map<std::uint32_t, FlippedPart> byGroup;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (!right[t])
    {
      byGroup[groups.of(t)].triangles.push_back(t);
    }
  }
  std::vector<FlippedPart> parts;
  for (auto& [group, part] : byGroup)
  {
    parts.push_back(std::move(part));
  }
  std::stable_sort(
    parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.triangles.size() > b.triangles.size(); });
  return parts;
}

std::vector<ThinPlace> thinOf(
  const TriangleMesh& mesh, const Turns& turns, const std::vector<bool>& right, double thin_u)
{
  CleanResult clean = cleanMesh(mesh);
  if (!clean.ok())
  {
    return {};
  }
  const SurfaceTree tree(std::move(clean.mesh));
  std::vector<ThinPlace> thin;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (turns.part[t] == Turns::none)
    {
      continue;
    }
    const auto& [i, j, k] = mesh.triangles[t];
    const Vec3 &a = mesh.vertices_W[i], &b = mesh.vertices_W[j], &c = mesh.vertices_W[k];
    const Vec3 inward_W = (right[t] ? -1.0 : 1.0) * (b - a).cross(c - a).normalized();
    const auto thickness_u = wallThickness_u(tree, (a + b + c) / 3.0, inward_W);
    if (thickness_u && *thickness_u < thin_u)
    {
      thin.push_back({ t, *thickness_u });
    }
  }
  std::stable_sort(
    thin.begin(), thin.end(), [](const auto& a, const auto& b) { return a.thickness_u < b.thickness_u; });
  return thin;
}

} // namespace

SurfaceFaults findFaults(const TriangleMesh& mesh, double thin_u)
{
  const std::vector<Side> sides = sidesOf(mesh, weld(mesh.vertices_W));
  const Turns turns(mesh, sides);
  const std::vector<bool> right = rightTurns(mesh, turns, sides);
  SurfaceFaults faults;
  faults.holes = holesOf(mesh, sides);
  faults.flipped = flippedOf(mesh, sides, right);
  if (thin_u > 0.0 && faults.holes.empty())
  {
    faults.thin = thinOf(mesh, turns, right, thin_u);
  }
  return faults;
}

} // namespace palpate
