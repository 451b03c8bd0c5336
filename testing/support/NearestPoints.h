// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::test
{

/// The nearest part of a mesh to a point, by CGAL's tree and constructions; nothing of the code under test is used.
class NearestPoints
{
public:
  explicit NearestPoints(const TriangleMesh& mesh);
  ~NearestPoints();

  /// Distance of the mesh [u].
  [[nodiscard]] double distance_u(const Vec3& centre_W) const;
  /// For each triangle that comes within `distance_u` its nearest point; equal ones once.
  [[nodiscard]] std::vector<Vec3> within(const Vec3& centre_W, double distance_u) const;

private:
  class Tree;
  std::unique_ptr<const Tree> tree_;
};

} // namespace palpate::test
