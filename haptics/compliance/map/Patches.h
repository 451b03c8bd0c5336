// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "haptics/compliance/element/StrainPoints.h"
#include "haptics/compliance/map/SurfaceMap.h"

namespace palpate
{

/// The border of a body as triangles between its vertices, and the triangles at each vertex. In a body with mid-edge
/// nodes each triangle has six nodes.
class BorderFaces
{
public:
  using Face = std::array<std::uint32_t, 3>;

  /// `border`: of the mesh.
  BorderFaces(const StrainPoints& body, const std::vector<Face>& border);

  [[nodiscard]] const std::vector<Face>& faces() const { return this->faces_; }
  /// The mid-edge nodes of ab, bc, ca of each face; empty for a body without such nodes.
  [[nodiscard]] const std::vector<Face>& halves() const { return this->halves_; }
  [[nodiscard]] const std::vector<std::uint32_t>& facesAt(std::uint32_t node) const { return this->facesAt_[node]; }
  [[nodiscard]] std::array<Vec3, 3> cornersOf(std::uint32_t face) const;
  [[nodiscard]] const Vec3& place(std::uint32_t node) const { return this->rest_W_[node]; }
  /// Mean length of the edges that end at a node of the border [u].
  [[nodiscard]] double edgeLengthAt(std::uint32_t node) const;

private:
  std::vector<Vec3> rest_W_;
  std::vector<Face> faces_;
  std::vector<Face> halves_;
  std::vector<std::vector<std::uint32_t>> facesAt_;
};

/// A patch's radius in lengths of edges: from 2 on force ripples by less than .5 % over a mesh, and at 2.5 contact of
/// balls agrees with Hertz as well as the mesh allows.
inline constexpr double patchEdges = 2.5;

/// The map from the nodes to a patch of radius `radius_u` around a point on a face: weights 1 - (d/a)^2 integrated over
/// the connected faces around it with the body's own shape functions, put on the nodes as a distributing coupling
/// (the mean displacement and the mean rotation of the weighted nodes move the point). Force and moment are kept to
/// rounding. A patch that is `wider` than the usual one by a factor covers as many more faces, each of which is
/// integrated over with as many fewer points.
[[nodiscard]] NodeBlocks patchAt(
  const BorderFaces& border, const Vec3& center_W, std::uint32_t face, double radius_u, double wider = 1.0);

} // namespace palpate
