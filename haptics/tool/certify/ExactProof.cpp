// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/certify/ExactProof.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <CGAL/Exact_rational.h>

namespace palpate
{
namespace
{

using Exact = CGAL::Exact_rational;
using Exact3 = std::array<Exact, 3>;
using ExactCorners = std::array<Exact3, 3>;

constexpr double roundings = 64.0; // of the largest coordinate: error bound of a posed corner

Exact3 exact(const Vec3& v)
{
  return { Exact(v.x()), Exact(v.y()), Exact(v.z()) };
}

ExactCorners exact(const Corners& corners)
{
  return { exact(corners[0]), exact(corners[1]), exact(corners[2]) };
}

Exact dot(const Exact3& a, const Exact3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Exact3 minus(const Exact3& a, const Exact3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Exact3 plus(const Exact3& a, const Exact3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

Exact3 times(const Exact& s, const Exact3& a)
{
  return { s * a[0], s * a[1], s * a[2] };
}

Exact3 cross(const Exact3& a, const Exact3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

/// The root, rounded up to a double.
Exact rootAbove(const Exact& square)
{
  double root = std::sqrt(CGAL::to_double(square));
  while (Exact(root) * Exact(root) < square)
  {
    root = std::nextafter(root, std::numeric_limits<double>::infinity());
  }
  return Exact(root);
}

Exact lengthAbove(const Exact3& a)
{
  return rootAbove(dot(a, a));
}

/// Gap of the tool above the scene along a normal.
Exact exactGap(const Exact3& n, const ExactCorners& tool, const ExactCorners& scene)
{
  Exact lowest = dot(n, tool[0]), highest = dot(n, scene[0]);
  for (int i = 1; i < 3; ++i)
  {
    lowest = std::min(lowest, dot(n, tool[i]));
    highest = std::max(highest, dot(n, scene[i]));
  }
  return lowest - highest;
}

/// The bounds of SpanProof in rational numbers, from its posed corners.
class ExactSpan
{
public:
  explicit ExactSpan(const SpanProof& proof)
    : span_(proof.span()), v_(exact(proof.step().v_W)), w_(exact(proof.step().w_W)),
      centre_(exact(proof.step().centre_W(span_.from))), from_(exact(proof.toolFrom_W())), to_(exact(proof.toolTo_W())),
      scene_(exact(proof.pair().scene_W)), length_(Exact(span_.to) - Exact(span_.from)), w2_(dot(w_, w_)),
      speed_(rootAbove(w2_))
  {
    for (int i = 0; i < 3; ++i)
    {
      const Exact3 arm = minus(this->from_[i], this->centre_);
      this->inward_[i] = cross(this->w_, cross(this->w_, arm));
      this->reach_[i] = lengthAbove(arm);
    }
  }

  [[nodiscard]] Exact least(const ProvenPlane& plane) const
  {
    const Exact3 first = exact(plane.first_W);
    const Exact3 last = exact(this->lastOf(plane));
    const Exact from = exactGap(first, this->from_, this->scene_), to = exactGap(last, this->to_, this->scene_);
    const Exact dip = this->length_ * this->length_ * std::max(Exact(0), this->bendOf(plane)) / 8;
    return std::min(from, to) - dip;
  }

private:
  [[nodiscard]] Vec3 lastOf(const ProvenPlane& plane) const
  {
    switch (plane.way)
    {
      case PlaneWay::InScene:
        break;
      case PlaneWay::InTool:
        return this->span_.turnTo * (this->span_.turnFrom.transpose() * plane.first_W);
      case PlaneWay::Between:
        return plane.last_W;
    }
    return plane.first_W;
  }

  [[nodiscard]] Exact bendOf(const ProvenPlane& plane) const
  {
    Exact bend = 0;
    for (int i = 0; i < 3; ++i)
    {
      bend = std::max(bend, this->bendAt(plane, i));
    }
    return bend;
  }

  [[nodiscard]] Exact bendAt(const ProvenPlane& plane, int i) const
  {
    const Exact3 first = exact(plane.first_W), last = exact(plane.last_W);
    const Exact jerk = this->w2_ * this->speed_ * this->reach_[i] * this->length_;
    if (plane.way == PlaneWay::InScene)
    {
      return dot(first, this->inward_[i]) + jerk;
    }
    if (plane.way == PlaneWay::InTool)
    {
      const Exact3 arm = minus(this->scene_[i], this->centre_);
      const Exact3 pull = cross(this->w_, plus(cross(this->w_, arm), times(2, this->v_)));
      const Exact third = this->w2_ * (this->speed_ * lengthAbove(arm) + 3 * lengthAbove(this->v_));
      return third * this->length_ - dot(first, pull);
    }
    const Exact3 change = minus(last, first);
    const Exact turning = 2 * dot(change, minus(this->to_[i], this->from_[i])) / (this->length_ * this->length_) +
                          2 * lengthAbove(change) * this->w2_ * this->reach_[i];
    return turning + std::max(dot(first, this->inward_[i]), dot(last, this->inward_[i])) + jerk;
  }

  const Span& span_;
  Exact3 v_, w_, centre_;
  ExactCorners from_, to_, scene_, inward_;
  Exact length_, w2_, speed_;
  std::array<Exact, 3> reach_;
};

double largestCoordinate(const SpanProof& proof)
{
  double largest = 0.0;
  for (const Corners* corners : { &proof.toolFrom_W(), &proof.toolTo_W(), &proof.pair().scene_W })
  {
    for (const Vec3& p : *corners)
    {
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

} // namespace

bool holdsExactly(const SpanProof& proof, const ProvenPlane& plane, double gap_u)
{
  const double rounding_u = roundings * std::numeric_limits<double>::epsilon() * largestCoordinate(proof);
  return ExactSpan(proof).least(plane) >= Exact(gap_u) - Exact(rounding_u);
}

} // namespace palpate
