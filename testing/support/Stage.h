// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "haptics/contact/GodObject.h"
#include "haptics/contact/carry/CarryBall.h"
#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::test
{

/// Surfaces whose poses are given as functions of time, sampled into snapshots as a view would.
class Stage
{
public:
  using Path = std::function<Pose(double time_s)>;

  /// `path`: pose of the mesh in W.
  void add(const TriangleMesh& mesh, Path path);
  void add(const Surface& surface, Path path);

  /// The scene whose surfaces go from where they are at one time to where they are at another.
  [[nodiscard]] std::shared_ptr<const Scene> between(double from_s, double to_s);
  [[nodiscard]] Pose pose(std::size_t surface, double time_s) const { return this->paths_[surface](time_s); }

private:
  std::vector<Surface> surfaces_;
  std::vector<Path> paths_;
  std::uint64_t revision_ = 0;
};

/// A god-object on a stage, 1 ms a tick: snapshots of 16 ticks each, the poses between them interpolated tick by tick.
class Actor
{
public:
  /// Placed at `start_W` at time 0. `stage` must outlive it.
  Actor(Stage& stage, const ContactPlan& plan, const Vec3& start_W);

  /// One tick with the device at p_W.
  ContactResult tick(const Vec3& p_W);

  /// Where a surface is in this tick.
  [[nodiscard]] Pose pose(std::size_t surface) const
  {
    return this->scene_->surfaces()[surface].motion.at(this->share());
  }
  /// The god-object in the frame of a surface.
  [[nodiscard]] Vec3 inSurface(std::size_t surface) const;

  GodObjectState state;
  CarryResult carry;
  bool carries = true; ///< false: it is only shown where the surfaces are now, as if they had always been there

private:
  static constexpr int ticksPerSnapshot = 16;
  [[nodiscard]] static double snapshot_s() { return ticksPerSnapshot * 1e-3; }
  [[nodiscard]] double share() const { return static_cast<double>(this->inSnapshot_) / ticksPerSnapshot; }

  Stage& stage_;
  ContactPlan plan_;
  std::shared_ptr<const Scene> scene_;
  double begin_s_ = 0.0;
  int inSnapshot_ = 0;
};

} // namespace palpate::test
