// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "haptics/force/WorkspaceMap.h"
#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/geometry/scene/SceneBuilder.h"

namespace palpate
{

/// A plane world, with start and exit if it is a maze. In scene units, z = 0.
struct Labyrinth
{
  std::string name;
  CurveSet curves;
  std::optional<Eigen::Vector2d> start_W, exit_W;
  double corridor_u = 1.0; ///< width of its corridors, > 0

  /// Radius of the disc that is led through: the disc fits with clearance, and never leaves a corridor by rounding.
  [[nodiscard]] double radius_u() const noexcept { return 0.2 * this->corridor_u; }
  /// How near to the exit's middle the disc has arrived; less than half a corridor and a radius, so never through a
  /// wall.
  [[nodiscard]] double exitReach_u() const noexcept { return 0.4 * this->corridor_u; }
};

/// Empty, or one sentence that names the plane world and says why nobody can even explore it: no line, lines that are
/// all one point, a number that is not finite, corridors without width.
[[nodiscard]] std::string refuseWorld(const Labyrinth& labyrinth);

/// Empty, or one sentence that names the labyrinth and says why no hand can be led through it: the refusals of
/// refuseWorld(), no place to start, no exit.
[[nodiscard]] std::string refuse(const Labyrinth& labyrinth);

/// A rectangle in the plane.
struct PlaneBox
{
  Eigen::Vector2d low_W, high_W;
};

/// The box of the lines. Where start or exit lie outside, the fence goes as far beyond them as they are from the box.
/// Needs a line.
[[nodiscard]] PlaneBox fence(const Labyrinth& labyrinth);

/// Its lines and the fence round them, so that nobody goes round a maze.
[[nodiscard]] CurveSet fenced(const Labyrinth& labyrinth);

/// The same as one surface, for a SceneBuilder.
[[nodiscard]] SurfaceInput wallsOf(const Labyrinth& labyrinth);

/// The fence, fitted into the square inside a device's workspace, middle on middle.
[[nodiscard]] WorkspaceMap fitted(const Labyrinth& labyrinth, double workspaceRadius_m);

} // namespace palpate
