// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/contact/RadiusLimit.h"
#include "haptics/geometry/mesh/Material.h"
#include "haptics/geometry/mesh/TriangleMesh.h"
#include "haptics/geometry/scene/SceneBuilder.h"

namespace palpate
{

/// From data to a scene to the ball that touches it: for a session, the filter, the program and runs through labyrinths
/// alike.

/// Lines of data, in W.
struct TouchedLines
{
  std::string name;                                  ///< of the data
  std::shared_ptr<const TriangleMesh> segments;      ///< see segmentsOf()
  std::shared_ptr<const MaterialFields> fields = {}; ///< of their vertices, or null
};

/// A surface that lines become, or why they become none.
struct LineSurface
{
  std::optional<SurfaceInput> input; ///< none with a problem
  std::optional<Pose> plane_WP = {}; ///< given: the surface is walls across it; its z is the normal
  std::string problem = {};
};

/// Tubes of that radius [u], named after the data.
[[nodiscard]] LineSurface tubesOf(const TouchedLines& lines, double tubeRadius_u);

/// Walls for balls up to that radius [u] across `plane_WP`; without one across the plane that the lines lie in.
[[nodiscard]] LineSurface wallsAcross(
  const TouchedLines& lines, double ballRadius_u, const std::optional<Pose>& plane_WP = std::nullopt);

/// A complete scene, or the refusal.
struct WholeScene
{
  std::shared_ptr<const Scene> scene; ///< null with a refusal
  std::vector<SurfaceReport> reports; ///< one an input
  std::string refused;                ///< the name of the first surface that cannot be touched,
  std::string refusal;                ///< and why; empty
};

[[nodiscard]] WholeScene wholeScene(const std::vector<SurfaceInput>& inputs, unsigned workers = 1);

/// The ball that touches a scene, beside the one that was asked for.
struct ChosenBall
{
  ContactPlan plan;  ///< with that ball
  RadiusLimit limit; ///< of the one that was asked for
};

/// `keepLimit`: no larger than finishes its work in a tick.
[[nodiscard]] ChosenBall chooseBall(const Scene& scene, const ContactPlan& asked, bool keepLimit);

} // namespace palpate
