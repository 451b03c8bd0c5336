// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticVesselMiddle.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "haptics/core/PoseMath.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

namespace
{
using palpate::Vec3;

constexpr int Rays = 24;
/// Of the vessel's diagonal: so far beside the wall a point on the wall is tried.
constexpr double Beside = 1e-4;

using Section = std::array<Vec3, Rays>;

struct Across
{
  Vec3 U, V; ///< unit vectors, normal to one another
};

/// The first places of the wall along rays all around; nothing: a ray meets none.
std::optional<Section> WallAround(vtkStaticCellLocator& wall, const Vec3& p, const Across& across, double far)
{
  Section section;
  vtkNew<vtkGenericCell> cell;
  for (int i = 0; i < Rays; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / Rays;
    const Vec3 end = p + far * (std::cos(angle) * across.U + std::sin(angle) * across.V);
    double t = 0.0, at[3], parameters[3];
    int sub = 0;
    vtkIdType id = 0;
    if (!wall.IntersectWithLine(p.data(), end.data(), 0.0, t, at, parameters, sub, id, cell))
    {
      return std::nullopt;
    }
    section[static_cast<std::size_t>(i)] = Vec3(at);
  }
  return section;
}

/// Of the circle x^2 + y^2 + a x + b y + c = 0 in the plane through p.
Vec3 CircleMiddle(const Section& section, const Vec3& p, const Across& across)
{
  palpate::Mat3 squares = palpate::Mat3::Zero();
  Vec3 sums = Vec3::Zero();
  for (const Vec3& at : section)
  {
    const Vec3 row((at - p).dot(across.U), (at - p).dot(across.V), 1.0);
    squares += row * row.transpose();
    sums -= row.head<2>().squaredNorm() * row;
  }
  const Vec3 circle = squares.ldlt().solve(sums);
  return p - 0.5 * circle.x() * across.U - 0.5 * circle.y() * across.V;
}

double Away(vtkStaticCellLocator& wall, const Vec3& p)
{
  double nearest[3], distance2 = 0.0;
  vtkIdType id = 0;
  int sub = 0;
  wall.FindClosestPoint(p.data(), nearest, id, sub, distance2);
  return std::sqrt(distance2);
}
} // namespace

Vec3 vtkHapticVesselMiddle(vtkPolyData& vessel, const Vec3& point_W, const Vec3& direction_W)
{
  const double far = vessel.GetLength();
  const double along = direction_W.norm();
  if (vessel.GetNumberOfCells() == 0 || !point_W.allFinite() || !(along > 0.0) || !std::isfinite(along))
  {
    return point_W;
  }
  vtkNew<vtkStaticCellLocator> wall;
  wall->SetDataSet(&vessel);
  wall->BuildLocator();
  const Vec3 axis = direction_W / along;
  const Vec3 u = axis.unitOrthogonal();
  const Across across{ u, axis.cross(u) };
  Vec3 best = point_W;
  double clearance = Away(*wall, point_W);
  const bool onWall = clearance < Beside * far;
  for (int i = 0; i < (onWall ? Rays : 1); ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / Rays;
    const Vec3 aside = std::cos(angle) * across.U + std::sin(angle) * across.V;
    const Vec3 from = onWall ? Vec3(point_W + 2.0 * Beside * far * aside) : point_W;
    const std::optional<Section> section = WallAround(*wall, from, across, far);
    const Vec3 middle = section ? CircleMiddle(*section, from, across) : best;
    const double away = Away(*wall, middle);
    if (away > clearance && WallAround(*wall, middle, across, far))
    {
      best = middle;
      clearance = away;
    }
  }
  return best;
}
