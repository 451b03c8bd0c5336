// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/mesh/FilledTwice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptics/core/Across.h"

namespace palpate
{
namespace
{

using Corners = std::array<Vec3, 4>;

/// An interval of a line; empty where `to` is not above `from`.
struct Piece
{
  double from_u = 0.0;
  double to_u = 0.0;
};

/// True if the line passes on one side of all corners, seen along one of two directions across it.
bool isBeside(const Corners& corners, const Vec3& from_W, const Vec3& across_W)
{
  const auto offset = [&](const Vec3& p) { return across_W.dot(p - from_W); };
  const auto [least, most] = std::ranges::minmax(corners, {}, offset);
  return offset(least) > 0.0 || offset(most) < 0.0;
}

/// The interval of a line in a tetrahedron.
Piece pieceIn(const Corners& corners, const LinePiece& line)
{
  Piece piece{ 0.0, line.length_u };
  for (std::size_t opposite = 0; opposite < 4; ++opposite)
  {
    const Vec3& a = corners[(opposite + 1) % 4];
    Vec3 out = (corners[(opposite + 2) % 4] - a).cross(corners[(opposite + 3) % 4] - a);
    out *= out.dot(corners[opposite] - a) > 0.0 ? -1.0 : 1.0;
    const double outside = out.dot(line.from_W - a), grows = out.dot(line.along_W);
    if (grows > 0.0)
    {
      piece.to_u = std::min(piece.to_u, -outside / grows);
    }
    else if (grows < 0.0)
    {
      piece.from_u = std::max(piece.from_u, -outside / grows);
    }
    else if (outside > 0.0)
    {
      return {};
    }
  }
  return piece;
}

/// Length that is in more than one interval.
double sharedBy(std::vector<Piece>& pieces)
{
  std::ranges::sort(pieces, {}, &Piece::from_u);
  double shared_u = 0.0, filledTo_u = 0.0;
  for (const Piece& piece : pieces)
  {
    shared_u += std::max(std::min(piece.to_u, filledTo_u) - piece.from_u, 0.0);
    filledTo_u = std::max(filledTo_u, piece.to_u);
  }
  return shared_u;
}

/// For a line that runs along no edge or face.
double filledAlong(const TetraMesh& mesh, std::span<const Vec3> places_W, const LinePiece& line)
{
  const auto [across, other] = tangentsOf(line.along_W);
  std::vector<Piece> pieces;
  double turned_u = 0.0;
  for (const Tetra& t : mesh.tetras)
  {
    const Corners corners{ places_W[t[0]], places_W[t[1]], places_W[t[2]], places_W[t[3]] };
    if (isBeside(corners, line.from_W, across) || isBeside(corners, line.from_W, other))
    {
      continue;
    }
    const Piece piece = pieceIn(corners, line);
    if (piece.to_u <= piece.from_u)
    {
      continue;
    }
    const double volume = (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0]);
    turned_u += volume < 0.0 ? piece.to_u - piece.from_u : 0.0;
    pieces.push_back(piece);
  }
  return turned_u + sharedBy(pieces);
}

} // namespace

double filledTwice(const TetraMesh& mesh, std::span<const Vec3> places_W, const LinePiece& line)
{
  constexpr double aside = 1e-4; // of the line: far more than rounding, far less than a tetrahedron
  const auto [across, other] = tangentsOf(line.along_W);
  double least_u = std::numeric_limits<double>::infinity();
  for (const double turn : { 0.4, 2.5, 4.6 }) // in no direction that a regular mesh has
  {
    LinePiece beside = line;
    beside.from_W += aside * line.length_u * (std::cos(turn) * across + std::sin(turn) * other);
    least_u = std::min(least_u, filledAlong(mesh, places_W, beside));
  }
  return least_u;
}

} // namespace palpate
