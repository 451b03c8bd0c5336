// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "haptics/core/Types.h"
#include "testing/lab/methods/FaceTree.h"

namespace palpate::lab
{

/// A textbook proxy to which surfaces that move are a new scene each tick: its place in W stays, and the segment to the
/// device is looked at as if the surfaces had always been where they are now. The proxy rests `gap` above a touched
/// surface, so a surface that comes at it by more than that in a tick leaves it behind.
class StaticFrameProxy
{
public:
  static constexpr double gap_u = 1e-4;

  StaticFrameProxy(const std::vector<TriangleMesh>& meshes, const Vec3& start_W);

  /// One tick: poses of the surfaces, in their order, and the device. Where the proxy is [u].
  Vec3 tick(const std::vector<Pose>& poses_WS, const Vec3& p_W);

private:
  std::vector<std::unique_ptr<const FaceTree>> faces_;
  Vec3 x_W_;
};

} // namespace palpate::lab
