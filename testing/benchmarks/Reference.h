// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "haptics/geometry/TriangleMesh.h"

namespace palpate::test
{

/// A well-kept library's answer to one collision query, to compare a tick with.
class Reference
{
public:
  virtual ~Reference() = default;
  [[nodiscard]] virtual const char* name() const = 0;
  /// Does the segment meet the surface? The whole cost is in here.
  [[nodiscard]] virtual bool meets(const Vec3& from_W, const Vec3& to_W) = 0;
};

/// CGAL's AABB tree over triangles, do_intersect(segment).
[[nodiscard]] std::unique_ptr<Reference> cgalReference(const TriangleMesh& mesh);
/// vtkStaticCellLocator, IntersectWithLine.
[[nodiscard]] std::unique_ptr<Reference> vtkReference(const TriangleMesh& mesh);

} // namespace palpate::test
