// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::lab
{

/// A library's answers to the collision queries a haptic tick could be built on. The whole cost of a query is in the
/// call; building happens when it is made.
class Backend
{
public:
  virtual ~Backend() = default;
  /// Does the closed segment meet the surface anywhere?
  [[nodiscard]] virtual bool meets(const Vec3& from_W, const Vec3& to_W) = 0;
  /// The fraction of the segment, 0..1, at which the segment first meets the surface; nothing where it does not.
  [[nodiscard]] virtual std::optional<double> firstHit(const Vec3& from_W, const Vec3& to_W) = 0;
  /// How far p is from the surface [u]; nothing where the library does not offer it.
  [[nodiscard]] virtual std::optional<double> distance_u(const Vec3& /*p_W*/) { return std::nullopt; }
};

/// The arithmetic in which a library decides whether a segment meets a triangle.
enum class Arithmetic
{
  Exact,
  Double,
  Single,
};

/// A library that queries can be asked of. Without `make`: it was not there when this was built.
struct BackendKind
{
  const char* name;
  Arithmetic arithmetic;
  std::unique_ptr<Backend> (*make)(const TriangleMesh& mesh) = nullptr;
};

/// Ours, cgal, vtkStaticCellLocator, vtkCellLocator, embree, bullet, in this order, whether they are there or not.
[[nodiscard]] std::vector<BackendKind> backendKinds();

/// Our sweep of a point over the product's own tree.
[[nodiscard]] std::unique_ptr<Backend> makeOurs(const TriangleMesh& mesh);
/// CGAL's AABB tree over triangles in plain double precision, its fastest kernel.
[[nodiscard]] std::unique_ptr<Backend> makeCgal(const TriangleMesh& mesh);
/// CGAL's AABB tree with exact predicates: the oracle for the others.
[[nodiscard]] std::unique_ptr<Backend> makeExact(const TriangleMesh& mesh);
/// The exact predicates (and distances in double precision) on every triangle, no tree: the oracle for the oracle.
[[nodiscard]] std::unique_ptr<Backend> makeBruteForce(const TriangleMesh& mesh);
[[nodiscard]] std::unique_ptr<Backend> makeVtkStaticCellLocator(const TriangleMesh& mesh);
[[nodiscard]] std::unique_ptr<Backend> makeVtkCellLocator(const TriangleMesh& mesh);
[[nodiscard]] std::unique_ptr<Backend> makeEmbree(const TriangleMesh& mesh);
[[nodiscard]] std::unique_ptr<Backend> makeBullet(const TriangleMesh& mesh);

} // namespace palpate::lab
