// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/mesh/SimpleShape.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "haptics/geometry/measure/RayWalk.h"
#include "haptics/geometry/mesh/NearestOnLines.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"

namespace palpate
{
namespace
{

struct Line
{
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
};

double distanceTo(const Line& line, const Vec3& p)
{
  const Vec3 along = line.to - line.from;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp(along.dot(p - line.from) / length2, 0.0, 1.0) : 0.0;
  return (p - line.from - share * along).norm();
}

/// Least distance from a corner, from an end of the line, or between an edge and the inside of the line.
double distanceTo(const Line& line, const std::array<Vec3, 3>& t)
{
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
  {
    least = std::min(least, distanceTo(line, t[k]));
    const Vec3 edge = t[(k + 1) % 3] - t[k], along = line.to - line.from;
    double onEdge = 0.0, onLine = 0.0;
    if (nearestOnLines(t[k], edge, line.from, along, onEdge, onLine) && onEdge > 0.0 && onEdge < 1.0 && onLine > 0.0 &&
        onLine < 1.0)
    {
      least = std::min(least, (t[k] + onEdge * edge - line.from - onLine * along).norm());
    }
  }
  for (const Vec3& end : { line.from, line.to })
  {
    least = std::min(least, (end - nearestOnTriangle(end, t[0], t[1], t[2])).norm());
  }
  return least;
}

/// The centre of the ball that fits all vertices best, by least squares: |p|^2 = 2 c.p + (r^2 - |c|^2).
Line centreOf(const TriangleMesh& mesh, const Vec3& mean)
{
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const Vec3& v : mesh.vertices_W)
  {
    const Vec3 p = v - mean;
    const Eigen::Vector4d row(2.0 * p.x(), 2.0 * p.y(), 2.0 * p.z(), 1.0);
    sum += row * row.transpose();
    right += p.squaredNorm() * row;
  }
  const Vec3 centre = mean + sum.ldlt().solve(right).head<3>();
  return { centre, centre };
}

/// The axis in the longest direction, through the middle of the extents along it and across it, shortened by the
/// radius at both ends.
Line axisOf(const TriangleMesh& mesh, const Vec3& mean)
{
  Mat3 spread = Mat3::Zero();
  for (const Vec3& v : mesh.vertices_W)
  {
    spread += (v - mean) * (v - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(spread);
  const Mat3 axes = solver.eigenvectors(); // the longest comes last
  Eigen::AlignedBox3d bounds;
  for (const Vec3& v : mesh.vertices_W)
  {
    bounds.extend(Vec3(axes.transpose() * (v - mean)));
  }
  const Vec3 middle = bounds.center(), half = 0.5 * bounds.sizes();
  const double reach = std::max(0.0, half.z() - 0.5 * (half.x() + half.y()));
  const Vec3 along = reach * Vec3::UnitZ();
  return { mean + axes * (middle - along), mean + axes * (middle + along) };
}

/// The shape about a line with its radius and bound.
SimpleShape around(const TriangleMesh& mesh, const Line& line, SimpleShape::Kind kind)
{
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const auto& t : mesh.triangles)
  {
    const std::array<Vec3, 3> corners{ mesh.vertices_W[t[0]], mesh.vertices_W[t[1]], mesh.vertices_W[t[2]] };
    least = std::min(least, distanceTo(line, corners));
    for (const Vec3& p : corners)
    {
      most = std::max(most, distanceTo(line, p)); // the distance is convex: largest at a corner
    }
  }
  return { kind, line.from, line.to, 0.5 * (least + most), 0.5 * (most - least) };
}

bool isAround(const TriangleMesh& mesh, const Vec3& p)
{
  const SurfaceTree tree(mesh);
  return isClosed(tree) && sideOf(tree, p) == PointSide::Inside;
}

} // namespace

std::string describe(const SimpleShape& shape)
{
  char text[200];
  if (shape.kind == SimpleShape::Kind::Ball)
  {
    std::snprintf(text, sizeof text, "a ball of radius %.4g u to within %.2g u", shape.radius_u, shape.bound_u);
  }
  else
  {
    std::snprintf(text, sizeof text, "a needle of %.4g u and radius %.4g u to within %.2g u",
      (shape.to_B - shape.from_B).norm(), shape.radius_u, shape.bound_u);
  }
  return text;
}

std::optional<SimpleShape> simpleShapeOf(const TriangleMesh& clean, double share)
{
  if (clean.vertices_W.empty())
  {
    return std::nullopt;
  }
  Vec3 mean = Vec3::Zero();
  for (const Vec3& v : clean.vertices_W)
  {
    mean += v / static_cast<double>(clean.vertices_W.size());
  }
  const SimpleShape ball = around(clean, centreOf(clean, mean), SimpleShape::Kind::Ball);
  const SimpleShape needle = around(clean, axisOf(clean, mean), SimpleShape::Kind::Needle);
  for (const SimpleShape& shape : { ball, needle })
  {
    if (shape.bound_u <= share * shape.radius_u && isAround(clean, shape.from_B))
    {
      return shape;
    }
  }
  return std::nullopt;
}

} // namespace palpate
