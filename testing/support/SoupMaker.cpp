// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/SoupMaker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"

namespace palpate::test
{
namespace
{

/// Of an edge: thin enough to be a sliver, thick enough that its normal still means something.
constexpr double sliverWidth = 1e-5;
/// Of all triangles, for each kind of defect.
constexpr double shareOfEach = 0.06;

TriangleMesh randomShape(Random& random)
{
  switch (random.below(4))
  {
    case 0:
      return makeIcosphere(2 + static_cast<int>(random.below(2)), 1.0);
    case 1:
      return scaled(NoisySphere(500 + random.below(2500), 1.0).mesh(), 1.0 / 50.0);
    case 2:
      return makeTorus(
        1.0, random.uniform(0.2, 0.6), 20 + static_cast<int>(random.below(30)), 8 + static_cast<int>(random.below(12)));
    default:
      return makeCellBox(3 + static_cast<int>(random.below(8)));
  }
}

/// Stretched along the axes, turned, scaled: no face is parallel to an axis and no length is near 1.
TriangleMesh placed(TriangleMesh mesh, Random& random)
{
  const Vec3 stretch(random.uniform(0.4, 1.0), random.uniform(0.4, 1.0), 1.0);
  for (Vec3& v : mesh.vertices_W)
  {
    v = v.cwiseProduct(stretch);
  }
  const double angle = random.uniform(0.0, 2 * std::numbers::pi);
  const Vec3 axis = random.direction();
  const Quat turn(Eigen::AngleAxisd(angle, axis));
  const double size = std::pow(10.0, random.uniform(-3.0, 3.0));
  return shifted(scaled(rotated(mesh, turn), size), random.inCube(2 * size));
}

double meanEdge(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
  {
    sum += (mesh.vertices_W[t[1]] - mesh.vertices_W[t[0]]).norm();
  }
  return sum / static_cast<double>(mesh.triangles.size());
}

double extentOf(const TriangleMesh& mesh)
{
  Vec3 low = mesh.vertices_W[0], high = low;
  for (const Vec3& v : mesh.vertices_W)
  {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return (high - low).maxCoeff();
}

/// Gives a triangle corners of its own, each moved towards the middle, at most half of the distance: cracks all round
/// it.
void pullIn(TriangleMesh& mesh, std::size_t triangle, const std::array<double, 3>& by_u)
{
  const auto [a, b, c] = mesh.triangles[triangle];
  const Vec3 middle = (mesh.vertices_W[a] + mesh.vertices_W[b] + mesh.vertices_W[c]) / 3;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3 corner = mesh.vertices_W[mesh.triangles[triangle][k]];
    const double length_u = (middle - corner).norm();
    mesh.triangles[triangle][k] = static_cast<std::uint32_t>(mesh.vertices_W.size());
    mesh.vertices_W.push_back(corner + std::min(by_u[k] / length_u, 0.5) * (middle - corner));
  }
}

BadMesh cleanStart(Random& random)
{
  BadMesh made;
  made.clean = placed(randomShape(random), random);
  made.bad = made.clean;
  made.size_u = extentOf(made.clean);
  made.edge_u = meanEdge(made.clean);
  return made;
}

/// Adds defects to a mesh, each kind to triangles of its own, and keeps account of how far the surface has moved.
class Spoiler
{
public:
  Spoiler(BadMesh& made, Random& random)
    : made_(made), random_(random), order_(made.clean.triangles.size()), removed_(made.clean.vertices_W.size(), false),
      shift_u_(made.edge_u * std::pow(10.0, random.uniform(-6.0, -0.8)))
  {
    std::iota(this->order_.begin(), this->order_.end(), 0u);
    random.shuffle(this->order_);
  }

  void spoil()
  {
    this->maybe(&Spoiler::cutSliver);
    this->maybe(&Spoiler::makeTJunction);
    this->maybe(&Spoiler::shrink);
    this->maybe(&Spoiler::removeTriangle);
    this->maybe(&Spoiler::addFin);
    this->maybe(&Spoiler::addCrossing);
    this->dropHoles();
    if (this->random_.below(2) == 0)
    {
      this->made_.bad = withDefects(this->made_.bad, this->random_);
    }
    this->made_.gap_u = 2 * (this->moved_u_ + this->hole_u_);
  }

private:
  using Defect = void (Spoiler::*)(std::uint32_t triangle);

  void maybe(Defect defect)
  {
    if (this->random_.below(2) == 0)
    {
      return;
    }
    const auto count = static_cast<std::size_t>(std::ceil(shareOfEach * static_cast<double>(this->order_.size())));
    for (std::size_t i = 0; i < count; ++i)
    {
      (this->*defect)(this->order_[this->next_++]);
    }
  }

  [[nodiscard]] const Vec3& at(std::uint32_t vertex) const { return this->made_.bad.vertices_W[vertex]; }

  std::uint32_t addVertex(const Vec3& v_W)
  {
    this->made_.bad.vertices_W.push_back(v_W);
    return static_cast<std::uint32_t>(this->made_.bad.vertices_W.size() - 1);
  }

  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    this->made_.bad.triangles.push_back({ a, b, c });
  }

  void moved(double by_u) { this->moved_u_ = std::max(this->moved_u_, by_u); }

  /// A vertex close to an edge: three triangles instead of one, a sliver among them; no way through.
  void cutSliver(std::uint32_t triangle)
  {
    const auto [a, b, c] = this->made_.bad.triangles[triangle];
    const Vec3 onEdge = this->at(a) + this->random_.uniform(0.2, 0.8) * (this->at(b) - this->at(a));
    const std::uint32_t v = this->addVertex(onEdge + sliverWidth * (this->at(c) - onEdge));
    this->made_.bad.triangles[triangle] = { a, b, v };
    this->addTriangle(b, c, v);
    this->addTriangle(c, a, v);
    this->moved(8 * std::numeric_limits<double>::epsilon() * (this->made_.size_u + this->at(v).norm()));
  }

  /// The neighbour over the edge knows nothing of the vertex, which lies beside it.
  void makeTJunction(std::uint32_t triangle)
  {
    const auto [a, b, c] = this->made_.bad.triangles[triangle];
    const double by_u = this->shift_u_ * this->random_.uniform();
    const Vec3 onEdge = this->at(a) + this->random_.uniform(0.2, 0.8) * (this->at(b) - this->at(a));
    const std::uint32_t v = this->addVertex(onEdge + by_u * this->random_.direction());
    this->made_.bad.triangles[triangle] = { a, v, c };
    this->addTriangle(v, b, c);
    this->made_.watertight = false;
    this->moved(by_u);
  }

  void shrink(std::uint32_t triangle)
  {
    std::array<double, 3> by_u{};
    for (double& way_u : by_u)
    {
      way_u = this->shift_u_ * this->random_.uniform();
      this->moved(way_u);
    }
    pullIn(this->made_.bad, triangle, by_u);
    this->made_.watertight = false;
  }

  /// A hole of one triangle: none of its corners belongs to another hole.
  void removeTriangle(std::uint32_t triangle)
  {
    const auto [a, b, c] = this->made_.clean.triangles[triangle];
    if (this->removed_[a] || this->removed_[b] || this->removed_[c])
    {
      return;
    }
    this->removed_[a] = this->removed_[b] = this->removed_[c] = true;
    const Vec3 ab = this->at(b) - this->at(a), ac = this->at(c) - this->at(a);
    const double inner_u = ab.cross(ac).norm() / (ab.norm() + ac.norm() + (ac - ab).norm());
    this->hole_u_ = std::max(this->hole_u_, inner_u);
    this->made_.watertight = false;
    this->holes_.push_back(triangle);
  }

  void addFin(std::uint32_t triangle)
  {
    const auto [a, b, c] = this->made_.bad.triangles[triangle];
    const Vec3 middle = 0.5 * (this->at(a) + this->at(b));
    this->addTriangle(a, b, this->addVertex(middle + 0.1 * this->made_.size_u * this->random_.direction()));
  }

  void addCrossing(std::uint32_t triangle)
  {
    const Vec3 centre = this->at(this->made_.bad.triangles[triangle][0]);
    const double size_u = this->made_.size_u * this->random_.uniform(0.02, 0.3);
    const std::uint32_t a = this->addVertex(centre + size_u * this->random_.direction());
    const std::uint32_t b = this->addVertex(centre + size_u * this->random_.direction());
    this->addTriangle(a, b, this->addVertex(centre + size_u * this->random_.direction()));
  }

  /// Last, because the numbers of the triangles change.
  void dropHoles()
  {
    std::sort(this->holes_.rbegin(), this->holes_.rend());
    for (const std::uint32_t hole : this->holes_)
    {
      this->made_.bad.triangles.erase(this->made_.bad.triangles.begin() + hole);
    }
  }

  BadMesh& made_;
  Random& random_;
  std::vector<std::uint32_t> order_; ///< triangles of the clean mesh; the first of them are used up
  std::size_t next_ = 0;
  std::vector<bool> removed_; ///< by vertex
  std::vector<std::uint32_t> holes_;
  double shift_u_;
  double moved_u_ = 0.0;
  double hole_u_ = 0.0;
};

} // namespace

TriangleMesh makeTorus(double bigRadius_u, double smallRadius_u, int around, int across)
{
  TriangleMesh torus;
  const auto number = [&](int i, int j) { return static_cast<std::uint32_t>((i % around) * across + j % across); };
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across;
      const double out = bigRadius_u + smallRadius_u * std::cos(b);
      torus.vertices_W.emplace_back(out * std::cos(a), out * std::sin(a), smallRadius_u * std::sin(b));
      torus.triangles.push_back({ number(i, j), number(i + 1, j), number(i + 1, j + 1) });
      torus.triangles.push_back({ number(i, j), number(i + 1, j + 1), number(i, j + 1) });
    }
  }
  return torus;
}

TriangleMesh makeCellBox(int cells)
{
  TriangleMesh box;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto number = [&](const std::array<int, 3>& place)
  {
    const auto [at, isNew] = numbers.try_emplace(place, static_cast<std::uint32_t>(box.vertices_W.size()));
    if (isNew)
    {
      box.vertices_W.emplace_back(2.0 * place[0] / cells - 1, 2.0 * place[1] / cells - 1, 2.0 * place[2] / cells - 1);
    }
    return at->second;
  };
  for (int side = 0; side < 6; ++side)
  {
    const int axis = side / 2, level = side % 2 == 0 ? 0 : cells;
    // Low sides look along -axis: their two directions change places.
    const int u = (axis + (level == 0 ? 2 : 1)) % 3, v = 3 - axis - u;
    for (int i = 0; i < cells * cells; ++i)
    {
      std::array<int, 3> place{};
      place[axis] = level;
      place[u] = i / cells;
      place[v] = i % cells;
      const std::uint32_t a = number(place), b = number((++place[u], place)), c = number((++place[v], place));
      const std::uint32_t d = number((--place[u], place));
      box.triangles.push_back({ a, b, c });
      box.triangles.push_back({ a, c, d });
    }
  }
  return box;
}

TriangleMesh shrunk(const TriangleMesh& mesh, double by_u)
{
  TriangleMesh result = mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    pullIn(result, t, { by_u, by_u, by_u });
  }
  return result;
}

BadMesh makeBadMesh(Random& random)
{
  BadMesh made = cleanStart(random);
  Spoiler(made, random).spoil();
  return made;
}

BadMesh makeHarmlessBadMesh(Random& random)
{
  BadMesh made = cleanStart(random);
  made.bad = withDefects(made.clean, random);
  made.sameSurface = true;
  return made;
}

} // namespace palpate::test
