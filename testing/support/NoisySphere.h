// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::test
{

/// A sphere of radius 50 mm with smooth bumps: |height| < 1.5 mm, shortest wavelength 3 mm. The icosahedron with each
/// edge cut in n, so 20 n^2 triangles; closed, manifold, and seen from the origin every ray meets it exactly once.
class NoisySphere
{
public:
  /// About `triangles` triangles in scene units of `unitsPerMillimetre` each (mm 1, m 1e-3, km 1e-6).
  NoisySphere(std::size_t triangles, double unitsPerMillimetre);

  [[nodiscard]] const TriangleMesh& mesh() const noexcept { return this->mesh_; }
  [[nodiscard]] double unitsPerMillimetre() const noexcept { return this->unit_; }
  /// Distance from the origin to the mesh (not to the smooth surface) along `direction` [u].
  [[nodiscard]] double surfaceRadius_u(const Vec3& direction) const;

private:
  /// A point of a flat icosahedron face in whole steps along its two first sides: weight n - i - j belongs to corner 0.
  [[nodiscard]] std::uint32_t vertexAt(std::uint32_t face, std::uint32_t i, std::uint32_t j) const;
  [[nodiscard]] std::uint32_t edgeVertex(std::uint32_t from, std::uint32_t to, std::uint32_t step) const;
  void makeVertices();
  void makeTriangles();

  TriangleMesh base_;
  std::uint32_t n_;
  double unit_;
  TriangleMesh mesh_;
};

/// A device point of a slide, and how far below the mesh it is, towards the centre.
struct SlidePoint
{
  Vec3 p_W = Vec3::Zero();
  double depth_u = 0.0;
};

/// Tick i (1 ms) of a slide at 100 mm/s round a noisy sphere on a slowly turning great circle, 1 to 2 mm deep.
[[nodiscard]] SlidePoint slideOver(const NoisySphere& sphere, std::size_t tick);
/// A free point 5 mm above the beginning of the slide.
[[nodiscard]] Vec3 slideStart_W(const NoisySphere& sphere);

} // namespace palpate::test
