// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "testing/lab/methods/FaceTree.h"

namespace palpate::lab
{

/// The half space n . x >= c.
struct Plane
{
  Vec3 n = Vec3::UnitZ();
  double c = 0.0;

  /// How far v_W is in front [u]; negative behind.
  [[nodiscard]] double height(const Vec3& v_W) const { return this->n.dot(v_W) - this->c; }
};

/// The plane of a face, `gap` nearer to the side on which from_W is.
[[nodiscard]] Plane planeTowards(const Face& face, const Vec3& from_W, double gap);
/// The same plane, to rounding and to `tolerance`.
[[nodiscard]] bool same(const Plane& a, const Plane& b, double tolerance);
/// The point nearest to p_W in front of all planes; at most 24 of them.
[[nodiscard]] Vec3 nearestInFront(const std::vector<Plane>& planes, const Vec3& p_W);

} // namespace palpate::lab
