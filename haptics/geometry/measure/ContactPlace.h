// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "haptics/core/Types.h"
#include "haptics/geometry/measure/Curvature.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// The place of a scene where a proxy rests, and the properties of the surface there.
struct ContactPlace
{
  std::string surface;          ///< name of it
  std::uint32_t triangle = 0;   ///< of its tree
  Vec3 p_W = Vec3::Zero();      ///< nearest to the proxy, on the triangles or lines themselves [u]
  Vec3 normal_W = Vec3::Zero(); ///< unit, to the side of the proxy
  std::optional<Curvature> curvature;
  std::optional<double> thickness_u; ///< of the wall behind it, straight in; nothing: none is met
};

/// The place nearest to a proxy of the whole scene, with moving surfaces at the end of their motion; nothing in an
/// empty scene. `device_W`, behind the surface that is pressed, says which side is outside where the proxy lies on the
/// surface itself. Not for the tick; any other thread.
[[nodiscard]] std::optional<ContactPlace> placeOf(const Scene& scene, const Vec3& proxy_W, const Vec3& device_W);

} // namespace palpate
