// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/certify/PairProof.h"

#include <cassert>
#include <utility>

#include "haptics/tool/certify/ExactProof.h"
#include "haptics/tool/mesh/BoxedMesh.h"

namespace palpate
{
namespace
{

constexpr int deepest = 30; // halvings: a safeguard, Clearance::finest ends them before

/// A face's normal on the side where the tool's corners are.
Vec3 towardsTool(const Vec3& n, const Corners& tool, const Corners& scene)
{
  return gapAlong(n, tool, scene) >= gapAlong(-n, tool, scene) ? n : Vec3(-n);
}

} // namespace

PairProof::PairProof(const ScrewStep& step, const Clearance& clearance, WorkBudget& budget) noexcept
  : step_(step), clearance_(clearance), budget_(budget), start_(step.from_W.q.toRotationMatrix())
{
}

double PairProof::provenUntil(
  const MovingPair& pair, double until, CachedPlane& cached, const std::optional<NearestPair>& first) noexcept
{
  this->asked_ = {};
  if (first)
  {
    this->asked_[0] = { 0.0, *first };
  }
  Span span;
  span.to = until;
  span.turnTo = this->step_.turn(until);
  return this->proven(pair, span, deepest, &cached);
}

double PairProof::proven(const MovingPair& pair, const Span& span, int depth, CachedPlane* cached) noexcept
{
  if (!this->budget_.spend(work_price::span))
  {
    return span.from;
  }
  if (this->holds(pair, span, cached))
  {
    return span.to;
  }
  if (depth == 0 || span.to - span.from <= this->clearance_.finest)
  {
    return span.from;
  }
  Span first = span, second = span;
  first.to = second.from = 0.5 * (span.from + span.to);
  first.turnTo = second.turnFrom = this->step_.turn(first.to);
  const double reached = this->proven(pair, first, depth - 1, nullptr);
  return reached < first.to ? reached : this->proven(pair, second, depth - 1, nullptr);
}

bool PairProof::separates(const SpanProof& proof, const ProvenPlane& plane) const noexcept
{
  const bool apart = proof.gapOf(plane).least() >= this->clearance_.gap_u;
  assert(!apart || holdsExactly(proof, plane, this->clearance_.gap_u));
  return apart;
}

bool PairProof::offer(const SpanProof& proof, const Vec3& n_W, CachedPlane* cached) const noexcept
{
  const bool inScene = this->separates(proof, { PlaneWay::InScene, n_W, n_W });
  const bool inTool = !inScene && this->separates(proof, { PlaneWay::InTool, n_W, n_W });
  if (cached != nullptr && (inScene || inTool))
  {
    *cached = inScene ? CachedPlane{ PlaneKind::InScene, n_W }
                      : CachedPlane{ PlaneKind::InTool, this->start_.transpose() * n_W };
  }
  return inScene || inTool;
}

bool PairProof::holds(const MovingPair& pair, const Span& span, CachedPlane* cached) noexcept
{
  const SpanProof proof(this->step_, span, pair);
  const Vec3 ofScene = towardsTool(unitNormal(pair.scene_W), proof.toolFrom_W(), pair.scene_W);
  const Vec3 ofTool = towardsTool(unitNormal(proof.toolFrom_W()), proof.toolFrom_W(), pair.scene_W);
  return this->offer(proof, ofScene, cached) || this->offer(proof, ofTool, cached) ||
         this->nearestHolds(proof, span, pair, cached);
}

NearestPair PairProof::nearestAt(double share, const Corners& tool_W, const Corners& scene_W) noexcept
{
  if (this->asked_[0].share != share)
  {
    std::swap(this->asked_[0], this->asked_[1]); // the first entry is the one used last
  }
  if (this->asked_[0].share != share)
  {
    this->asked_[0] = { share, nearestPair(tool_W, scene_W) };
  }
  return this->asked_[0].nearest;
}

bool PairProof::nearestHolds(
  const SpanProof& proof, const Span& span, const MovingPair& pair, CachedPlane* cached) noexcept
{
  const NearestPair first = this->nearestAt(span.from, proof.toolFrom_W(), pair.scene_W);
  if (first.distance_u < this->clearance_.gap_u)
  {
    return false;
  }
  if (this->offer(proof, first.n, cached))
  {
    return true;
  }
  const NearestPair last = this->nearestAt(span.to, proof.toolTo_W(), pair.scene_W);
  return last.distance_u >= this->clearance_.gap_u && (this->separates(proof, { PlaneWay::InScene, last.n, last.n }) ||
                                                        this->separates(proof, { PlaneWay::Between, first.n, last.n }));
}

} // namespace palpate
