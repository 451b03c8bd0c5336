// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/tool/certify/TrianglePair.h"
#include "haptics/tool/motion/ScrewStep.h"

namespace palpate
{

/// A part of a step, from one share to another, with the tool's rotations at both: input of a proof.
struct Span
{
  double from = 0.0, to = 1.0;
  Mat3 turnFrom = Mat3::Identity(), turnTo = Mat3::Identity();
};

/// Two triangles during a step. Arms are the tool's corners from its centre, rotated as at the step's start.
struct MovingPair
{
  Corners arms_W;
  Corners scene_W;
};

/// Gap of a plane between two triangles during a span [u]: at least the linear interpolation of the gaps at its ends,
/// less the dip D^2 / 8 max f'', the error of that interpolation.
struct SpanGap
{
  double from = 0.0, to = 0.0, dip = 0.0;

  /// Lower bound of the distance at a share of the span.
  [[nodiscard]] double at(double share) const noexcept
  {
    return this->from + share * (this->to - this->from) - 4.0 * share * (1.0 - share) * this->dip;
  }
  /// Lower bound of the distance everywhere in the span.
  [[nodiscard]] double least() const noexcept { return std::min(this->from, this->to) - this->dip; }
  /// The same in the first `share` of the span.
  [[nodiscard]] double leastUntil(double share) const noexcept
  {
    return std::min(this->from, this->at(share)) - share * share * this->dip;
  }
  /// The share at which the line falls below a gap: only the order in which pairs are examined depends on it.
  [[nodiscard]] double crossing(double gap_u) const noexcept
  {
    if (this->from < gap_u)
    {
      return 0.0;
    }
    return this->to < gap_u ? (this->from - gap_u) / (this->from - this->to) : 1.0;
  }
};

/// Motion of the plane of a proof during a span.
enum class PlaneWay : std::uint8_t
{
  InScene, ///< fixed in the scene
  InTool,  ///< moves and rotates with the tool
  Between, ///< its normal is interpolated linearly from the first to the last
};

/// The plane of a proof.
struct ProvenPlane
{
  PlaneWay way = PlaneWay::InScene;
  Vec3 first_W = Vec3::Zero(); ///< normal at the start of the span
  Vec3 last_W = Vec3::Zero();  ///< normal at the end, for Between
};

/// Gaps that are proven for all of a span and not only for its ends, each a lower bound of the distance of two
/// triangles.
class SpanProof
{
public:
  SpanProof(const ScrewStep& step, const Span& span, const MovingPair& pair) noexcept;

  [[nodiscard]] SpanGap gapOf(const ProvenPlane& plane) const noexcept;
  [[nodiscard]] const ScrewStep& step() const noexcept { return this->step_; }
  [[nodiscard]] const Span& span() const noexcept { return this->span_; }
  [[nodiscard]] const MovingPair& pair() const noexcept { return this->pair_; }
  [[nodiscard]] const Corners& toolFrom_W() const noexcept { return this->from_; }
  [[nodiscard]] const Corners& toolTo_W() const noexcept { return this->to_; }
  /// The plane is fixed in the scene. A rotation about n does not lower the bound.
  [[nodiscard]] SpanGap inScene(const Vec3& n_W) const noexcept;
  /// The plane moves and rotates with the tool; n at the start of the span.
  [[nodiscard]] SpanGap inTool(const Vec3& n_W) const noexcept;
  /// The normal is interpolated linearly: in between it is shorter than 1, which only lowers the bound.
  [[nodiscard]] SpanGap between(const Vec3& nFrom_W, const Vec3& nTo_W) const noexcept;

private:
  [[nodiscard]] SpanGap withDip(double gapFrom, double gapTo, double bend) const noexcept;

  const ScrewStep& step_;
  const Span& span_;
  const MovingPair& pair_;
  double length_;
  double speed_rad_; ///< |w| of a whole step
  Corners from_, to_;
  Corners inward_;              ///< second derivative of each corner at the start of the span
  std::array<double, 3> reach_; ///< distance of each corner from the centre
};

} // namespace palpate
