// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/mesh/ToolMesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "haptics/core/DisjointSets.h"
#include "haptics/tool/mesh/MassMetric.h"

namespace palpate
{
namespace
{

constexpr std::size_t mostTriangles = 250000;
constexpr double furthestHandle = 10.0;   // diagonals of the tool: a turn by a degree moves it by a sixth of its size
constexpr double furthestParts = 10.0;    // times the sum of the diagonals of the parts
constexpr double furthestDiagonals = 1e6; // 64 roundings of such a coordinate are an eighth of the rest gap
constexpr double simpleShare = 0.02;      // of its radius: a third of the just noticeable difference of a force
constexpr double bytesATriangle = 190.0;  // boxes, corners, flags of a tool, and as much for temporary data
constexpr double flatShare = 0.1;         // of the rest gap: a smaller bend is no feature that is felt

bool allFinite(const TriangleMesh& mesh)
{
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
    [&](const auto& t)
    {
      return std::all_of(t.begin(), t.end(),
        [&](std::uint32_t v) { return v >= mesh.vertices_W.size() || mesh.vertices_W[v].allFinite(); });
    });
}

Eigen::AlignedBox3d boundsOf(const TriangleMesh& mesh)
{
  Eigen::AlignedBox3d bounds;
  for (const Vec3& v : mesh.vertices_W)
  {
    bounds.extend(v);
  }
  return bounds;
}

/// For each vertex the first vertex of its part.
std::vector<std::uint32_t> partsOf(const TriangleMesh& mesh)
{
  DisjointSets parts(mesh.vertices_W.size());
  for (const auto& t : mesh.triangles)
  {
    parts.join(t[0], t[1]);
    parts.join(t[0], t[2]);
  }
  return parts.all();
}

/// The sum of the diagonals of all parts.
double partsMeasure_u(const TriangleMesh& mesh)
{
  const std::vector<std::uint32_t> part = partsOf(mesh);
  std::vector<Eigen::AlignedBox3d> bounds(mesh.vertices_W.size());
  for (std::uint32_t v = 0; v < part.size(); ++v)
  {
    bounds[part[v]].extend(mesh.vertices_W[v]);
  }
  return std::accumulate(bounds.begin(), bounds.end(), 0.0,
    [](double sum, const Eigen::AlignedBox3d& box) { return sum + (box.isEmpty() ? 0.0 : box.diagonal().norm()); });
}

std::string refusalOf(const TriangleMesh& raw, const CleanResult& clean)
{
  if (!allFinite(raw))
  {
    return "the tool has vertices that are not finite numbers: remove them, or clean the mesh";
  }
  if (!clean.ok())
  {
    return "the mesh cannot be a tool: " + clean.refusal;
  }
  if (clean.mesh.triangles.size() == 1)
  {
    return "the tool is one triangle: use a mesh with at least two triangles";
  }
  if (clean.mesh.triangles.size() > mostTriangles)
  {
    const double memory_MB = 1e-6 * bytesATriangle * static_cast<double>(clean.mesh.triangles.size());
    return "the tool has " + std::to_string(clean.mesh.triangles.size()) + " triangles, which would need about " +
           std::to_string(static_cast<int>(memory_MB)) +
           " MB and would be too slow to follow a hand: simplify the mesh to " + std::to_string(mostTriangles) +
           " or fewer";
  }
  if (boundsOf(clean.mesh).diagonal().norm() > furthestParts * partsMeasure_u(clean.mesh))
  {
    return "the parts of the tool lie far apart: use only the part for the hand";
  }
  return {};
}

std::string refuseHandle(const TriangleMesh& mesh, const Vec3& handle_W)
{
  const Eigen::AlignedBox3d bounds = boundsOf(mesh);
  const bool near =
    handle_W.allFinite() && bounds.exteriorDistance(handle_W) <= furthestHandle * bounds.diagonal().norm();
  return near ? "" : "the handle lies far outside of the tool: move the handle or the mesh closer";
}

double bytesOf(const BoxedMesh& shape)
{
  const TriangleMesh& mesh = shape.mesh();
  return static_cast<double>(shape.nodes().size() * sizeof(BoxedMesh::Node) +
                             mesh.triangles.size() * (sizeof(mesh.triangles[0]) + sizeof(FlatFlags)) +
                             mesh.vertices_W.size() * sizeof(Vec3));
}

} // namespace

Outcome<ToolMesh> makeTool(const TriangleMesh& raw, const std::optional<Vec3>& handle_W)
{
  Outcome<ToolMesh> result;
  const CleanResult given = cleanMesh(raw);
  result.problem = refusalOf(raw, given);
  if (result.ok() && handle_W)
  {
    result.problem = refuseHandle(given.mesh, *handle_W);
  }
  if (!result.ok())
  {
    return result;
  }
  const MassMetric metric = handle_W ? metricAbout(given.mesh, *handle_W) : massMetric(raw, given);
  TriangleMesh moved = given.mesh;
  for (Vec3& v : moved.vertices_W)
  {
    v -= metric.centre_W;
  }
  CleanResult body = cleanMesh(moved); // far from the origin the shift rounds, and slivers that vanish must be detected
  if (!body.ok())
  {
    result.problem =
      "the tool is so far from the origin that rounding destroys its triangles: move the tool closer to the origin";
    return result;
  }
  ToolMesh& tool = result.value;
  tool.centre_W = metric.centre_W;
  tool.solid = metric.solid;
  tool.diagonal_u = boundsOf(body.mesh).diagonal().norm();
  tool.gyration_u = std::max(metric.gyration_u, 1e-3 * tool.diagonal_u);
  for (const Vec3& v : body.mesh.vertices_W)
  {
    tool.reach_u = std::max(tool.reach_u, v.norm());
  }
  tool.simple = simpleShapeOf(body.mesh, simpleShare);
  tool.shape_B = std::make_shared<const BoxedMesh>(std::move(body.mesh), flatShare * tool.restGap_u());
  return result;
}

std::shared_ptr<const BoxedMesh> makeToolScene(TriangleMesh clean, const ToolMesh& tool)
{
  return std::make_shared<const BoxedMesh>(std::move(clean), flatShare * tool.restGap_u());
}

std::string refusePose(const ToolMesh& tool, const Pose& pose_W)
{
  if (!pose_W.p.allFinite() || !pose_W.q.coeffs().allFinite())
  {
    return "the pose of the tool is not made of finite numbers";
  }
  if (std::abs(pose_W.q.squaredNorm() - 1.0) > 1e-6)
  {
    return "the quaternion of the tool's pose is not of length one: normalise it";
  }
  if (pose_W.p.cwiseAbs().maxCoeff() > furthestDiagonals * tool.diagonal_u)
  {
    return "the tool is a million times its size away from the origin: move tool and scene there";
  }
  return {};
}

std::string refuseScene(const ToolMesh& tool, const BoxedMesh& scene)
{
  const auto& vertices = scene.mesh().vertices_W;
  const bool far = std::any_of(vertices.begin(), vertices.end(),
    [&](const Vec3& v) { return v.cwiseAbs().maxCoeff() > furthestDiagonals * tool.diagonal_u; });
  return far ? "the scene reaches a million times the size of the tool: scale the tool, or cut the scene" : "";
}

std::string describeFelt(const ToolMesh& tool, bool asBall)
{
  if (!tool.simple)
  {
    return {};
  }
  const std::string is = describe(*tool.simple);
  if (asBall)
  {
    const auto kilobytes = static_cast<long>(1e-3 * bytesOf(*tool.shape_B)) + 1;
    return "rendered as its exact shape, " + is + "; its " + std::to_string(tool.shape_B->mesh().triangles.size()) +
           " triangles would need a thread and " + std::to_string(kilobytes) + " kB";
  }
  if (tool.simple->kind != SimpleShape::Kind::Ball)
  {
    return is + ", rendered by its mesh";
  }
  return is + (tool.ball_u() > 0.0 ? ", too large for a tick among so many triangles: rendered by its mesh"
                                   : ", not held at its centre: rendered by its mesh");
}

} // namespace palpate
