// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <span>

#include "haptics/core/Outcome.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// Stiffness of a beam's section, which bends alike about all axes across it.
struct BeamSection
{
  double stretch_N = 0.0;                                   ///< E A
  double shear_N = std::numeric_limits<double>::infinity(); ///< shear factor times G A; infinity: a thin beam
  double bend_Nu2 = 0.0;                                    ///< E I
  double twist_Nu2 = 0.0;                                   ///< G J
};

/// Section of a round rod. Its shear factor is 6 (1 + nu) / (7 + 6 nu) (Cowper 1966).
[[nodiscard]] BeamSection roundSection(double radius_u, double young_N_per_u2, double poisson) noexcept;

/// A beam between two nodes, straight at rest.
struct WireBeam
{
  BeamSection section;
  double length_u = 0.0;
  /// Orientation of the beam at rest, whose x axis leads along it, in the frames of its two nodes.
  Quat first = Quat::Identity();
  Quat second = Quat::Identity();
};

/// A thin body that bends: a chain of beams, between nodes with place and orientation. Of fixed capacity.
struct Wire
{
  static constexpr int mostBeams = 64;
  static constexpr int mostNodes = mostBeams + 1;

  int count = 0; ///< of beams; one node more
  std::array<WireBeam, mostBeams> beams{};

  [[nodiscard]] int nodes() const noexcept { return this->count + 1; }
};

/// Where the nodes of a wire are.
using WirePlaces = std::array<Pose, Wire::mostNodes>;

/// A wire that is at rest along these points, at least two, with a section for each beam or one for all. A problem
/// names the beam and the reason.
[[nodiscard]] Outcome<Wire> makeWire(std::span<const Vec3> points_W, std::span<const BeamSection> sections);

/// Poses of the nodes at rest along these points: the x axis of each leads to the next one, the last excepted, and
/// frames are carried on without twist.
[[nodiscard]] WirePlaces placesAlong(std::span<const Vec3> points_W) noexcept;

} // namespace palpate
