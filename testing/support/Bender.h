// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate::test
{

/// A surface whose vertices and whose pose are functions of time, sampled into snapshots as a view would, and a hand on
/// it: 1 ms a tick through the whole tick without limits, scene and device in metres. A snapshot is felt when the next
/// one is there.
class Bender
{
public:
  /// Where a vertex of the mesh is, in the frame of the surface.
  using Path = std::function<Vec3(const Vec3& inMesh_S, double time_s)>;

  enum class Between
  {
    Moves, ///< vertices go straight from one snapshot to the next
    Steps, ///< each snapshot is there at once
  };

  Bender(TriangleMesh mesh, Path path, int ticksPerSnapshot, Between between = Between::Moves);
  Bender(const Bender&) = delete;
  Bender& operator=(const Bender&) = delete;

  /// Another surface of the scene, which stands.
  void addStanding(const TriangleMesh& mesh);
  TickOutput tick(const Vec3& p_W);
  /// The next tick takes the next snapshot, wherever the surface is.
  void cutShort() { this->inSnapshot_ = this->ticksPerSnapshot_; }

  /// From the snapshot before to the one after, in the tick that was.
  [[nodiscard]] double share() const { return static_cast<double>(this->inSnapshot_) / this->ticksPerSnapshot_; }
  [[nodiscard]] double snapshot_s() const { return 1e-3 * this->ticksPerSnapshot_; }
  /// Where a vertex is felt in the tick that was, if it goes straight.
  [[nodiscard]] Vec3 between(const Vec3& inMesh_S) const;
  /// Where the surface's frame is in the tick that was: evenly along a line, turned by the normalised mean.
  [[nodiscard]] Pose pose_WS() const;
  /// The whole mesh as it is felt in the tick that was, in its frame.
  [[nodiscard]] TriangleMesh mesh_S() const;
  /// And in W.
  [[nodiscard]] TriangleMesh mesh() const;
  [[nodiscard]] const std::shared_ptr<const Scene>& scene() const { return this->scene_; }

  HapticParameters parameters; ///< stiffness and friction are the test's
  RendererState state;
  std::optional<double> lineRadius_u;                  ///< given: the mesh holds curves of this radius
  std::uint64_t frame = 0;                             ///< names the surface's frame: it bends there under any pose
  std::function<Pose(double time_s)> path_WS;          ///< of the surface's frame; where there is none, it is W
  std::function<TickOutput(const TickInput&)> compute; ///< a tick; the renderer's on `state` unless given
  std::function<void(const std::shared_ptr<const Scene>&)> onScene = {}; ///< sees each one before its first tick

private:
  [[nodiscard]] Pose poseAt(double time_s) const { return this->path_WS ? this->path_WS(time_s) : Pose{}; }
  [[nodiscard]] std::shared_ptr<const Scene> snapshot(double time_s, const Scene* felt);
  void nextSnapshot();

  TriangleMesh mesh_;
  Path path_;
  int ticksPerSnapshot_;
  Between between_;
  std::vector<SurfaceInput> standing_;
  SceneBuilder builder_;
  std::shared_ptr<const Scene> scene_, previous_;
  double begin_s_ = 0.0;
  int inSnapshot_ = 0;
  std::uint64_t tick_ = 0;
};

} // namespace palpate::test
