// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "haptics/tool/certify/SpanProof.h"
#include "haptics/tool/motion/WorkBudget.h"

namespace palpate
{

/// The frame in which a plane that separated two triangles is kept.
enum class PlaneKind : std::uint8_t
{
  None,
  InScene, ///< normal in W
  InTool,  ///< normal in the tool's body frame B
};

/// The last direction that separated a pair, to be tried first.
struct CachedPlane
{
  PlaneKind kind = PlaneKind::None;
  Vec3 n = Vec3::Zero();
};

/// Required gap of a step between a pair.
struct Clearance
{
  double gap_u = 0.0;  ///< to be proven everywhere
  double finest = 0.0; ///< a part of the step no longer than this share of it is not divided
};

/// The share of a step from its start over which a pair is proven to stay apart. A part of the step that is not proven
/// as a whole is halved, the first half first. Without budget the rest counts as unproven.
class PairProof
{
public:
  PairProof(const ScrewStep& step, const Clearance& clearance, WorkBudget& budget) noexcept;

  /// The proven share, at most `until`. If one plane separates the pair in all of it, `cached` keeps that plane.
  /// `first`: the nearest points at the start of the step, if they are known.
  [[nodiscard]] double provenUntil(const MovingPair& pair, double until, CachedPlane& cached,
    const std::optional<NearestPair>& first = std::nullopt) noexcept;

private:
  [[nodiscard]] double proven(const MovingPair& pair, const Span& span, int depth, CachedPlane* cached) noexcept;
  [[nodiscard]] bool holds(const MovingPair& pair, const Span& span, CachedPlane* cached) noexcept;
  [[nodiscard]] bool nearestHolds(
    const SpanProof& proof, const Span& span, const MovingPair& pair, CachedPlane* cached) noexcept;
  [[nodiscard]] NearestPair nearestAt(double share, const Corners& tool_W, const Corners& scene_W) noexcept;
  [[nodiscard]] bool separates(const SpanProof& proof, const ProvenPlane& plane) const noexcept;
  [[nodiscard]] bool offer(const SpanProof& proof, const Vec3& n_W, CachedPlane* cached) const noexcept;

  const ScrewStep& step_;
  Clearance clearance_;
  WorkBudget& budget_;
  Mat3 start_; ///< rotation of the tool at the start of the step
  /// The two shares of the last queries: half of a span has an end in common with the span.
  struct Asked
  {
    double share = -1.0;
    NearestPair nearest;
  };
  std::array<Asked, 2> asked_{};
};

} // namespace palpate
