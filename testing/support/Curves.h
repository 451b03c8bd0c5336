// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "haptics/contact/GodObject.h"
#include "haptics/geometry/mesh/PolyLines.h"
#include "haptics/geometry/scene/Scene.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// Curves of one radius.
struct Tubes
{
  PolyLines curves;
  double radius_u = 0.0;
};

/// One line through these points.
[[nodiscard]] Tubes tubeThrough(const std::vector<Vec3>& points_W, double radius_u);
/// A helix about z of so many turns from z = 0 on, `pieces` to a turn.
[[nodiscard]] Tubes helix(double coil_u, double pitch_u, int turns, int pieces, double radius_u);
/// Lines that wander at random through the cube [-half, half]^3 in steps of about a quarter of it.
[[nodiscard]] Tubes wanderingTubes(int lines, int points, double half_u, double radius_u, Random& random);

/// Each set of curves as a surface; the mesh, if it has triangles, behind them. Throws with the reason if one is
/// refused.
[[nodiscard]] std::shared_ptr<const Scene> sceneOf(const std::vector<Tubes>& tubes, const TriangleMesh& mesh = {});

/// Distance of two segments, a0 a1 and b0 b1 [u].
[[nodiscard]] double segmentDistance(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

/// How far p is from the nearest tube's skin [u], negative inside. All segments are asked.
[[nodiscard]] double clearance(const std::vector<Tubes>& tubes, const Vec3& p_W);

/// A hand in a world of tubes, one tick a call: it dashes through it, and strokes along lines from inside their tubes.
class TubeHand
{
public:
  /// `tubes` must outlive it. `fastest_u`: its largest displacement in a tick.
  TubeHand(const std::vector<Tubes>& tubes, double half_u, double fastest_u, std::uint64_t seed);

  [[nodiscard]] Vec3 next();

private:
  void choose();

  const std::vector<Tubes>& tubes_;
  double half_u_, fastest_u_;
  Random random_;
  Vec3 p_W_ = Vec3::Zero(), goal_W_ = Vec3::Zero();
  double step_u_ = 0.0;
  std::size_t tube_ = 0, line_ = 0, point_ = 0;
  int rubs_ = 0; ///< points of the line left to stroke along
};

/// Judges the path of a ball's centre: whether it is continuous and how near it comes to any tube.
class TubeChecker final : public PathSink
{
public:
  /// `tubes` must outlive it.
  explicit TubeChecker(const std::vector<Tubes>& tubes) : tubes_(tubes) {}

  void segment(const Vec3& from_W, const Vec3& to_W) noexcept override;

  /// Judges the path since the last call and forgets it: least clearance of the centre over all of the path [u], which
  /// no ball of radius r may bring below r. `start_W`, `end_W`: where the centre was before and is now. NaN for a path
  /// with gaps.
  [[nodiscard]] double leastClearance(const Vec3& start_W, const Vec3& end_W);

private:
  const std::vector<Tubes>& tubes_;
  std::vector<std::pair<Vec3, Vec3>> pieces_;
};

} // namespace palpate::test
