// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "testing/lab/methods/ContactMethod.h"
#include "testing/lab/methods/RayCaster.h"

namespace palpate::lab
{

using MakeRays = std::unique_ptr<RayCaster> (*)(const TriangleMesh& mesh);
using MakeBall = std::unique_ptr<ContactMethod> (*)(const World& world, double radius_m);

/// Segments against triangles in Embree, in its robust mode and single precision; null where this was built without
/// Embree.
[[nodiscard]] MakeRays embreeRays();
/// A ball that Bullet sweeps towards the device and along the surfaces that it meets, at most ten times a tick, as
/// Bullet's kinematic character does. In millimetres, as Bullet asks for bodies of about one unit. Null where this was
/// built without Bullet.
[[nodiscard]] MakeBall bulletBall();

/// Behind these two; defined only where the library is there.
[[nodiscard]] std::unique_ptr<RayCaster> makeEmbreeRays(const TriangleMesh& mesh);
[[nodiscard]] std::unique_ptr<ContactMethod> makeBulletBall(const World& world, double radius_m);

} // namespace palpate::lab
