// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "haptics/geometry/SurfaceTree.h"

namespace palpate
{

/// For each vertex whether another sheet of the surface is within `distance_u` of a triangle it belongs to: one that
/// cannot be reached from that triangle over triangles that are as near. Any thread.
[[nodiscard]] std::vector<bool> verticesNearOtherSheets(
  const SurfaceTree& surface, double distance_u, const std::stop_token& stop = {});

/// Two triangles that meet elsewhere than in the vertices they share, in exact arithmetic; none where the surface is
/// embedded. Any thread.
[[nodiscard]] std::optional<std::array<std::uint32_t, 2>> crossingTriangles(
  const SurfaceTree& surface, const std::stop_token& stop = {});

} // namespace palpate
