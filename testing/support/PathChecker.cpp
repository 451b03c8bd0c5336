// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/PathChecker.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <CGAL/squared_distance_3.h>

namespace palpate::test
{
namespace
{

using Filtered = CGAL::Exact_predicates_inexact_constructions_kernel;
using Rational = CGAL::Simple_cartesian<CGAL::Exact_rational>;

template<class Kernel>
typename Kernel::Point_3 point(const Vec3& v)
{
  return { v.x(), v.y(), v.z() };
}

template<class Kernel>
typename Kernel::Triangle_3 triangleOf(const TriangleMesh& mesh, std::size_t t)
{
  const auto [a, b, c] = mesh.triangles[t];
  return { point<Kernel>(mesh.vertices_W[a]), point<Kernel>(mesh.vertices_W[b]), point<Kernel>(mesh.vertices_W[c]) };
}

/// Squared distance of two convex sets that do not meet: an end of one against the other, or edge against edge.
template<class Kernel>
typename Kernel::FT squaredDistance(const typename Kernel::Segment_3& way, const typename Kernel::Triangle_3& triangle)
{
  auto least = std::min(CGAL::squared_distance(way.source(), triangle), CGAL::squared_distance(way.target(), triangle));
  for (int k = 0; k < 3; ++k)
  {
    const typename Kernel::Segment_3 side(triangle.vertex(k), triangle.vertex(k + 1));
    least = std::min(least, CGAL::squared_distance(way, side));
  }
  return least;
}

std::string text(const Vec3& v)
{
  std::ostringstream out;
  out.precision(17);
  out << "(" << v.x() << ", " << v.y() << ", " << v.z() << ")";
  return out.str();
}

} // namespace

/// Triangles by cell. Comparisons and a monotone rounding only: what is near is never missed.
class PathChecker::Grid
{
public:
  explicit Grid(const TriangleMesh& mesh) : mesh_(mesh)
  {
    this->low_ = this->high_ = mesh.vertices_W.at(mesh.triangles.at(0)[0]);
    for (const auto& t : mesh.triangles)
    {
      for (const std::uint32_t corner : t)
      {
        this->low_ = this->low_.cwiseMin(mesh.vertices_W[corner]);
        this->high_ = this->high_.cwiseMax(mesh.vertices_W[corner]);
      }
    }
    this->side_ = std::clamp(static_cast<int>(1.5 * std::sqrt(static_cast<double>(mesh.triangles.size()) / 6)), 1, 160);
    this->cells_.resize(static_cast<std::size_t>(this->side_) * this->side_ * this->side_);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    {
      const auto [a, b, c] = mesh.triangles[t];
      const Vec3 &va = mesh.vertices_W[a], &vb = mesh.vertices_W[b], &vc = mesh.vertices_W[c];
      this->forEachCell(va.cwiseMin(vb).cwiseMin(vc), va.cwiseMax(vb).cwiseMax(vc),
        [&](std::size_t cell) { this->cells_[cell].push_back(t); });
    }
  }

  [[nodiscard]] const TriangleMesh& mesh() const { return this->mesh_; }

  /// All triangles whose boxes come within `margin` of the box of the piece, each once.
  [[nodiscard]] std::vector<std::uint32_t> near(const Piece& piece, double margin) const
  {
    const Vec3 room = Vec3::Constant(margin);
    std::vector<std::uint32_t> found;
    this->forEachCell(piece.from_W.cwiseMin(piece.to_W) - room, piece.from_W.cwiseMax(piece.to_W) + room,
      [&](std::size_t cell) { found.insert(found.end(), this->cells_[cell].begin(), this->cells_[cell].end()); });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

private:
  [[nodiscard]] int cellOf(double value, int axis) const
  {
    const double extent = this->high_[axis] - this->low_[axis];
    const double place = extent > 0 ? (value - this->low_[axis]) / extent * this->side_ : 0.0;
    return static_cast<int>(std::clamp(place, 0.0, this->side_ - 1.0));
  }

  template<class Visit>
  void forEachCell(const Vec3& low, const Vec3& high, Visit visit) const
  {
    std::array<int, 3> first{}, last{};
    for (int axis = 0; axis < 3; ++axis)
    {
      first[axis] = this->cellOf(low[axis], axis);
      last[axis] = this->cellOf(high[axis], axis);
    }
    for (int k = first[2]; k <= last[2]; ++k)
    {
      for (int j = first[1]; j <= last[1]; ++j)
      {
        for (int i = first[0]; i <= last[0]; ++i)
        {
          visit((static_cast<std::size_t>(k) * this->side_ + j) * this->side_ + i);
        }
      }
    }
  }

  TriangleMesh mesh_;
  Vec3 low_, high_;
  int side_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;
};

PathChecker::PathChecker(const TriangleMesh& mesh, double radius_u, double clearanceTolerance_u)
  : grid_(std::make_shared<const Grid>(mesh)), leastDistance_u_(std::max(0.0, radius_u - clearanceTolerance_u))
{
}

PathChecker::PathChecker(const PathChecker& sameMesh, double radius_u, double clearanceTolerance_u)
  : grid_(sameMesh.grid_), leastDistance_u_(std::max(0.0, radius_u - clearanceTolerance_u))
{
}

PathChecker::~PathChecker() = default;

void PathChecker::segment(const Vec3& from_W, const Vec3& to_W) noexcept
{
  this->pieces_.push_back({ from_W, to_W });
}

std::string PathChecker::finding(const Vec3& start_W)
{
  std::string found;
  Vec3 at_W = start_W;
  for (const Piece& piece : this->pieces_)
  {
    if (piece.from_W != at_W)
    {
      found = "the path jumps from " + text(at_W) + " to " + text(piece.from_W);
    }
    else if (piece.from_W != piece.to_W)
    {
      found = this->findingFor(piece);
    }
    ++this->judged_;
    at_W = piece.to_W;
    if (!found.empty())
    {
      break;
    }
  }
  this->pieces_.clear();
  return found;
}

std::string PathChecker::findingFor(const Piece& piece) const
{
  const Filtered::Segment_3 way(point<Filtered>(piece.from_W), point<Filtered>(piece.to_W));
  const double least = this->leastDistance_u_;
  for (const std::uint32_t t : this->grid_->near(piece, least))
  {
    const auto triangle = triangleOf<Filtered>(this->grid_->mesh(), t);
    if (CGAL::do_intersect(way, triangle))
    {
      return "from " + text(piece.from_W) + " to " + text(piece.to_W) + " the centre meets triangle " +
             std::to_string(t);
    }
    if (least == 0.0 || squaredDistance<Filtered>(way, triangle) >= least * least)
    {
      continue;
    }
    // The double answer is only a suspicion.
    const Rational::Segment_3 exactWay(point<Rational>(piece.from_W), point<Rational>(piece.to_W));
    const auto d2 = squaredDistance<Rational>(exactWay, triangleOf<Rational>(this->grid_->mesh(), t));
    if (d2 < CGAL::Exact_rational(least) * CGAL::Exact_rational(least))
    {
      std::ostringstream out;
      out.precision(17);
      out << "from " << text(piece.from_W) << " to " << text(piece.to_W) << " the centre comes within "
          << std::sqrt(CGAL::to_double(d2)) << " of triangle " << t << ", allowed " << least;
      return out.str();
    }
  }
  return {};
}

} // namespace palpate::test
