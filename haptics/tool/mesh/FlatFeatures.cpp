// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/mesh/FlatFeatures.h"

#include <algorithm>
#include <cmath>

#include "haptics/geometry/measure/SurfaceTurns.h"

namespace palpate
{
namespace
{

class Flatness
{
public:
  Flatness(const TriangleMesh& mesh, double flat_u)
    : mesh_(mesh), flat_u_(flat_u), flags_(mesh.triangles.size()), ends_(mesh.vertices_W.size())
  {
    forEachEdge(sidesOf(mesh),
      [this](auto first, auto last)
      {
        if (last - first == 2 && this->isFlat(first[0], first[1]))
        {
          this->flags_[first[0].triangle].bits |= 1 << first[0].k;
          this->flags_[first[1].triangle].bits |= 1 << first[1].k;
        }
        else
        {
          this->noteEnd(first->low, first->high);
          this->noteEnd(first->high, first->low);
        }
      });
    this->flagCorners();
  }

  [[nodiscard]] std::vector<FlatFlags> take() { return std::move(this->flags_); }

private:
  /// The other ends of a vertex's edges that bend: two are enough.
  struct Ends
  {
    std::array<std::uint32_t, 2> other{};
    std::uint8_t count = 0; ///< 3: more than two
  };

  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t t) const
  {
    const auto [a, b, c] = this->mesh_.triangles[t];
    return { this->mesh_.vertices_W[a], this->mesh_.vertices_W[b], this->mesh_.vertices_W[c] };
  }

  [[nodiscard]] bool isFlat(const Side& one, const Side& two) const
  {
    const auto a = this->corners(one.triangle), b = this->corners(two.triangle);
    const Vec3 &apexA = a[(one.k + 2) % 3], &apexB = b[(two.k + 2) % 3], &start = this->mesh_.vertices_W[one.low];
    const Vec3 along = (this->mesh_.vertices_W[one.high] - start).normalized();
    const Vec3 acrossA = (apexA - start) - along.dot(apexA - start) * along;
    const Vec3 acrossB = (apexB - start) - along.dot(apexB - start) * along;
    return std::abs(unitNormal(a).dot(apexB - start)) <= this->flat_u_ &&
           std::abs(unitNormal(b).dot(apexA - start)) <= this->flat_u_ && acrossA.dot(acrossB) < 0.0;
  }

  void noteEnd(std::uint32_t vertex, std::uint32_t other)
  {
    Ends& ends = this->ends_[vertex];
    if (ends.count < 2)
    {
      ends.other[ends.count] = other;
    }
    ends.count = std::min<int>(ends.count + 1, 3);
  }

  [[nodiscard]] bool straight(std::uint32_t vertex) const
  {
    const Ends& ends = this->ends_[vertex];
    if (ends.count != 2)
    {
      return ends.count == 0;
    }
    const Vec3 a = this->mesh_.vertices_W[ends.other[0]] - this->mesh_.vertices_W[vertex];
    const Vec3 b = this->mesh_.vertices_W[ends.other[1]] - this->mesh_.vertices_W[vertex];
    const double reach = (b - a).norm();
    return a.dot(b) < 0.0 && reach > 0.0 && a.cross(b).norm() <= this->flat_u_ * reach;
  }

  void flagCorners()
  {
    for (std::size_t t = 0; t < this->flags_.size(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->flags_[t].bits |= this->straight(this->mesh_.triangles[t][k]) ? 8 << k : 0;
      }
    }
  }

  const TriangleMesh& mesh_;
  double flat_u_;
  std::vector<FlatFlags> flags_;
  std::vector<Ends> ends_;
};

} // namespace

std::vector<FlatFlags> flatFlags(const TriangleMesh& mesh, double flat_u)
{
  return Flatness(mesh, flat_u).take();
}

} // namespace palpate
