// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/simplify/SurfaceDistance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "haptics/geometry/tree/TreeWalk.h"

namespace palpate
{
namespace
{

double distanceToBox(const TreeNode& node, int child, const Vec3& x_W) noexcept
{
  double squared = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double x = x_W[static_cast<int>(axis)];
    const double out = std::max({ node.low_W[axis][child] - x, x - node.high_W[axis][child], 0.0 });
    squared += out * out;
  }
  return std::sqrt(squared);
}

void lookAtLeaf(const SurfaceData& surface, std::uint32_t leaf, const Vec3& x_W, NearestPoint& best) noexcept
{
  surface.forEachInLeaf(leaf,
    [&](std::uint32_t t) noexcept
    {
      const auto& [a, b, c] = surface.face(t).corner_W;
      const Vec3 p_W = nearestOnTriangle(x_W, a, b, c);
      const double distance = (p_W - x_W).norm();
      if (distance <= best.distance_u)
      {
        best = { t, p_W, distance };
      }
    });
}

double distanceTo(const FaceRecord& face, const Vec3& x_W) noexcept
{
  return (nearestOnTriangle(x_W, face.corner_W[0], face.corner_W[1], face.corner_W[2]) - x_W).norm();
}

/// A convex part of a triangle.
struct Piece
{
  static constexpr int most = 12;
  std::array<Vec3, most> corner_W;
  int count = 0;
  std::uint32_t hint = SurfaceData::none; ///< a triangle that was near something larger

  [[nodiscard]] Vec3 centre_W() const noexcept
  {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < this->count; ++i)
    {
      sum += this->corner_W[i];
    }
    return sum / this->count;
  }
};

/// Cuts at the plane offset = normal . x. The first part is where normal . x is less; either may be empty.
std::pair<Piece, Piece> cut(const Piece& piece, const Vec3& normal_W, double offset) noexcept
{
  std::pair<Piece, Piece> parts;
  parts.first.hint = parts.second.hint = piece.hint;
  for (int i = 0; i < piece.count; ++i)
  {
    const Vec3 &p = piece.corner_W[i], &q = piece.corner_W[(i + 1) % piece.count];
    const double at = normal_W.dot(p) - offset, next = normal_W.dot(q) - offset;
    if (at <= 0.0)
    {
      parts.first.corner_W[parts.first.count++] = p;
    }
    if (at >= 0.0)
    {
      parts.second.corner_W[parts.second.count++] = p;
    }
    if ((at < 0.0 && next > 0.0) || (at > 0.0 && next < 0.0))
    {
      const Vec3 middle = p + at / (at - next) * (q - p);
      parts.first.corner_W[parts.first.count++] = middle;
      parts.second.corner_W[parts.second.count++] = middle;
    }
  }
  parts.first.count = parts.first.count < 3 ? 0 : parts.first.count;
  parts.second.count = parts.second.count < 3 ? 0 : parts.second.count;
  return parts;
}

/// From corner to corner.
Vec3 longestWay(const Piece& piece) noexcept
{
  Vec3 longest = Vec3::Zero();
  for (int i = 0; i < piece.count; ++i)
  {
    for (int j = i + 1; j < piece.count; ++j)
    {
      const Vec3 way = piece.corner_W[j] - piece.corner_W[i];
      longest = way.squaredNorm() > longest.squaredNorm() ? way : longest;
    }
  }
  return longest;
}

double area(const Piece& piece) noexcept
{
  Vec3 twice = Vec3::Zero();
  for (int i = 2; i < piece.count; ++i)
  {
    twice += (piece.corner_W[i - 1] - piece.corner_W[0]).cross(piece.corner_W[i] - piece.corner_W[0]);
  }
  return 0.5 * twice.norm();
}

/// Across its longest extent.
std::pair<Piece, Piece> halves(const Piece& piece) noexcept
{
  const Vec3 normal = longestWay(piece).normalized();
  return cut(piece, normal, normal.dot(piece.centre_W()));
}

/// The pieces of one surface that are still to be proven near another one.
class Prover
{
public:
  Prover(const SurfaceData& from, const SurfaceData& to, double limit_u) : from_(from), to_(to), limit_u_(limit_u)
  {
    const double size = std::max({ from.low_W.cwiseAbs().maxCoeff(), from.high_W.cwiseAbs().maxCoeff(),
      to.low_W.cwiseAbs().maxCoeff(), to.high_W.cwiseAbs().maxCoeff() });
    this->rounding_u_ = 64 * std::numeric_limits<double>::epsilon() * size;
  }

  DistanceProof run(const std::stop_token& stop)
  {
    constexpr std::size_t piecesATriangle = 16;
    const std::size_t triangles = this->from_.faces.size() + this->to_.faces.size();
    const std::size_t budget = 100'000 + piecesATriangle * triangles;
    this->proof_.verdict = DistanceProof::Verdict::Within;
    for (std::size_t t = 0; t < this->from_.faces.size() && this->stillWithin(); ++t)
    {
      const auto& [a, b, c] = this->from_.cornersOf(static_cast<std::uint32_t>(t));
      this->pending_.push_back({ { a, b, c }, 3 });
      while (!this->pending_.empty() && this->stillWithin())
      {
        const Piece piece = this->pending_.back();
        this->pending_.pop_back();
        this->look(piece);
        if (this->proof_.pieces > budget || (this->proof_.pieces % 1024 == 0 && stop.stop_requested()))
        {
          this->proof_.verdict = DistanceProof::Verdict::Open;
        }
      }
    }
    return this->proof_;
  }

private:
  [[nodiscard]] bool stillWithin() const noexcept { return this->proof_.verdict == DistanceProof::Verdict::Within; }

  /// True if one triangle has all of the piece within reach; then the piece counts as proven.
  bool accept(const Piece& piece, std::uint32_t triangle) noexcept
  {
    const FaceRecord& face = this->to_.face(triangle);
    double furthest = 0.0;
    for (int i = 0; i < piece.count; ++i)
    {
      furthest = std::max(furthest, distanceTo(face, piece.corner_W[i]) + this->rounding_u_);
      if (furthest > this->limit_u_)
      {
        return false;
      }
    }
    this->proof_.bound_u = std::max(this->proof_.bound_u, furthest);
    return true;
  }

  void look(const Piece& piece)
  {
    ++this->proof_.pieces;
    if (piece.hint != SurfaceData::none && this->accept(piece, piece.hint))
    {
      return;
    }
    const Vec3 centre_W = piece.centre_W();
    const NearestPoint nearest = nearestOn(this->to_, centre_W, this->limit_u_ + this->rounding_u_);
    if (nearest.triangle == SurfaceData::none)
    {
      this->proof_.verdict = DistanceProof::Verdict::Beyond;
      this->proof_.witness_W = centre_W;
      return;
    }
    if (this->accept(piece, nearest.triangle))
    {
      return;
    }
    if (!this->mayBeCut(piece) || (!this->cutAlong(piece, nearest.triangle, this->overhang(piece, nearest.triangle)) &&
                                    !this->cutAlong(piece, nearest.triangle, 0.0)))
    {
      this->halve(piece);
    }
  }

  /// How far a point may stand out sideways over a triangle and still be within reach, with as much again for corners.
  double overhang(const Piece& piece, std::uint32_t triangle) const noexcept
  {
    const FaceRecord& face = this->to_.face(triangle);
    double height = 0.0;
    for (int i = 0; i < piece.count; ++i)
    {
      height = std::max(height, std::abs(face.normal_W.dot(piece.corner_W[i] - face.corner_W[0])));
    }
    return height < this->limit_u_ ? 0.5 * std::sqrt(this->limit_u_ * this->limit_u_ - height * height) : 0.0;
  }

  /// Of a piece as thin as rounding a cut along its length leaves the same piece again.
  [[nodiscard]] bool mayBeCut(const Piece& piece) const noexcept
  {
    return piece.count + 3 <= Piece::most && area(piece) > this->rounding_u_ * longestWay(piece).norm();
  }

  /// The part over the triangle is proven, the rest is pending. False, with nothing changed, if that cannot be done, or
  /// if that part is so small that the rest would be cut by the lines of many more triangles than it lies near to.
  bool cutAlong(const Piece& piece, std::uint32_t triangle, double over_u)
  {
    const FaceRecord& face = this->to_.face(triangle);
    Piece inside = piece;
    std::array<Piece, 3> outside;
    for (std::size_t k = 0; k < 3 && inside.count > 0; ++k)
    {
      const Vec3 &a = face.corner_W[k], &b = face.corner_W[(k + 1) % 3];
      const Vec3 outward = (b - a).cross(face.normal_W).normalized();
      std::tie(inside, outside[k]) = cut(inside, outward, outward.dot(a) + over_u);
    }
    constexpr double leastShare = 0.05;
    if (inside.count == 0 || area(inside) <= leastShare * area(piece) || !this->accept(inside, triangle))
    {
      return false;
    }
    for (Piece& rest : outside)
    {
      rest.hint = SurfaceData::none;
      if (rest.count > 0)
      {
        this->pending_.push_back(rest);
      }
    }
    return true;
  }

  void halve(const Piece& piece)
  {
    const auto [first, second] = halves(piece);
    if (first.count == 0 || second.count == 0)
    {
      this->proof_.verdict = DistanceProof::Verdict::Open; // too small to be cut in doubles
      return;
    }
    this->pending_.push_back(first);
    this->pending_.push_back(second);
  }

  const SurfaceData& from_;
  const SurfaceData& to_;
  double limit_u_;
  double rounding_u_ = 0.0;
  std::vector<Piece> pending_;
  DistanceProof proof_;
};

} // namespace

NearestPoint nearestOn(const SurfaceData& surface, const Vec3& x_W, double within_u)
{
  NearestPoint best;
  best.distance_u = within_u;
  const auto reaches = [&best](double distance) noexcept { return distance <= best.distance_u; };
  const auto distancesTo = [&x_W](const TreeNode& node) noexcept {
    return std::array<double, 2>{ distanceToBox(node, 0, x_W), distanceToBox(node, 1, x_W) };
  };
  const auto lookAt = [&](std::uint32_t leaf) noexcept { lookAtLeaf(surface, leaf, x_W, best); };
  walkNearestFirst(surface.nodes, 0.0, distancesTo, reaches, reaches, lookAt);
  return best;
}

DistanceProof proveWithin(const SurfaceTree& from, const SurfaceTree& to, double limit_u, std::stop_token stop)
{
  return Prover(from.data(), to.data(), limit_u).run(stop);
}

} // namespace palpate
