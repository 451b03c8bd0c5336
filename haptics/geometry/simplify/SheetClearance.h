// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate
{

/// For each vertex whether another sheet of the surface is within `distance_u` of a triangle it belongs to: one that
/// cannot be reached from that triangle over triangles that are as near. Any thread.
[[nodiscard]] std::vector<bool> verticesNearOtherSheets(
  const SurfaceTree& surface, double distance_u, const std::stop_token& stop = {});

/// The same for the vertices of these triangles only; false for all others.
[[nodiscard]] std::vector<bool> verticesNearOtherSheets(const SurfaceTree& surface, double distance_u,
  const std::vector<std::uint32_t>& triangles, const std::stop_token& stop = {});

/// How many triangles the above looks at for one, on average, counted for up to `samples` of them: its cost.
[[nodiscard]] double trianglesWithin(const SurfaceTree& surface, double distance_u, std::size_t samples);

/// Two triangles that meet elsewhere than in the vertices they share, in exact arithmetic; none where the surface is
/// embedded. Any thread.
[[nodiscard]] std::optional<std::array<std::uint32_t, 2>> crossingTriangles(
  const SurfaceTree& surface, const std::stop_token& stop = {});

/// The same, of which not both are marked in `ignored`, a flag a triangle.
[[nodiscard]] std::optional<std::array<std::uint32_t, 2>> crossingTriangles(
  const SurfaceTree& surface, const std::vector<bool>& ignored, const std::stop_token& stop = {});

} // namespace palpate
