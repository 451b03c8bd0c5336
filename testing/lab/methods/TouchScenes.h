// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/support/Random.h"

namespace palpate::lab
{

/// A mesh to touch, a path to touch it along, and the force that must be felt.
struct TouchScene
{
  std::string name;
  TriangleMesh mesh;
  double metre_u = 1.0;  ///< scene units in a metre
  double depth_u = 1e-3; ///< how deep the device is led, about
  /// The device at tick 0, 1, ... for a ball of radius r_u; free at tick 0.
  std::function<Vec3(int tick, double r_u)> device_W;
  /// The true force per unit of stiffness at a device point of that path, by formula or exact oracle [u].
  std::function<Vec3(const Vec3& p_W, double r_u)> force_u;
  std::vector<std::string> failing; ///< the methods that theory says cannot do it

  [[nodiscard]] bool fails(const std::string& method) const;
};

/// Plane, thin plate, convex edge, corner, wedge, sphere, groove, fast sheet, soup, and a plane a millionth as large.
[[nodiscard]] std::vector<TouchScene> touchScenes(test::Random& random);

} // namespace palpate::lab
