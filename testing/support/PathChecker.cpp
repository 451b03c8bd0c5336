// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/PathChecker.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "testing/support/ExactTriangles.h"

namespace palpate::test
{
namespace
{

std::string text(const Vec3& v)
{
  std::ostringstream out;
  out.precision(17);
  out << "(" << v.x() << ", " << v.y() << ", " << v.z() << ")";
  return out.str();
}

} // namespace

PathChecker::PathChecker(const TriangleMesh& mesh, double radius_u, double clearanceTolerance_u)
  : grid_(std::make_shared<const TriangleGrid>(mesh)), leastDistance_u_(std::max(0.0, radius_u - clearanceTolerance_u))
{
}

PathChecker::PathChecker(const PathChecker& sameMesh, double radius_u, double clearanceTolerance_u)
  : grid_(sameMesh.grid_), leastDistance_u_(std::max(0.0, radius_u - clearanceTolerance_u))
{
}

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
    else if (!piece.to_W.allFinite())
    {
      found = "the path ends nowhere";
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
  const auto way = segmentOf<Filtered>(piece.from_W, piece.to_W);
  const double least = this->leastDistance_u_;
  for (const std::uint32_t t : this->grid_->near(piece.from_W, piece.to_W, least))
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
    const auto exactWay = segmentOf<Rational>(piece.from_W, piece.to_W);
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
