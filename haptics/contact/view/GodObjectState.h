// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "haptics/contact/view/FaceList.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// Dimension of the feature the ball touches; the value orders ties in time.
enum class FeatureKind : std::uint8_t
{
  Face = 0,
  Edge = 1,
  Vertex = 2,
};

/// One touched feature: which, on which side. Normal and gap are recomputed, never stored.
struct ActiveFeature
{
  std::uint32_t surface = 0; ///< index into Scene::surfaces()
  std::uint32_t a = 0;       ///< face: triangle; edge: lower vertex; vertex: vertex
  std::uint32_t b = 0;       ///< edge: higher vertex; else 0
  FeatureKind kind = FeatureKind::Face;
  std::int8_t side = 1; ///< face: sign of the normal that points at the ball; else 1
  bool stuck = false;   ///< face evicted and hit again without progress (r = 0)

  friend bool operator==(const ActiveFeature&, const ActiveFeature&) = default;
};

/// The result of friction in a tick.
enum class FrictionState : std::uint8_t
{
  None,   ///< no contact, or no friction
  Sticks, ///< the god-object stayed where it was
  Slips,  ///< it trails the frictionless one
};

/// A ball and the features that it touches: all that has an effect on where a god-object goes.
struct TouchingBall
{
  /// Three features hold a ball, the others are candidates. To try all sets of up to three of 20 planes takes 4 to
  /// 8 us. Where more than these are touched, the one with the widest gap makes room.
  static constexpr int maxFeatures = 24;

  Vec3 x_W = Vec3::Zero();
  bool placed = false; ///< false until the first sample
  bool slips = false;  ///< under friction: it moved along in the last tick
  int count = 0;
  std::array<ActiveFeature, maxFeatures> features{};
  Vec3 device_W = Vec3::Zero(); ///< of the last tick
  double texture = -1.0;        ///< share of it that is felt, see SurfaceResponse; below 0: nothing is held
};

/// All that a god-object remembers between ticks.
struct GodObjectState : TouchingBall
{
  FacesAround around; ///< has an effect on the cost alone, and on where a tick over budget ends
};

/// A plane that holds the ball, and how deep the device is pressed along it.
struct ActivePlane
{
  ActiveFeature feature;
  double depth_u = 0.0; ///< multiplier of the projection
};

/// The result of one tick of contact.
struct ContactResult
{
  Vec3 proxy_W = Vec3::Zero();
  Vec3 pull_W = Vec3::Zero(); ///< the displacement of the coupling: proxy - device, or see SurfaceResponse
  double held_u2 = 0.0; ///< twice the energy the coupling holds, over its stiffness: |pull|^2, or see SurfaceResponse
  std::array<ActivePlane, 3> held{};
  int heldCount = 0;
  int contacts = 0; ///< planes with l > 0 after merging coplanar ones
  int passes = 0;
  int sweeps = 0;
  std::uint32_t work = 0;  ///< done, in the unit of ContactPlan::workBudget
  bool capped = false;     ///< the pass cap ended the tick before a rest was proven
  bool overBudget = false; ///< the node budget was met: the ball moved only as far as proven free
  bool infeasible = false; ///< the projection found no feasible point: the ball stayed
  FrictionState friction = FrictionState::None;
  bool seatFailed = false; ///< no free place within the radius at the start: Fault::PlacementFailed
};

/// Receives the tick's path, a polyline: tests check in exact arithmetic that it crosses nothing.
class PathSink
{
public:
  virtual ~PathSink() = default;
  virtual void segment(const Vec3& from_W, const Vec3& to_W) noexcept = 0;
};

} // namespace palpate
