// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/move/StepProof.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace palpate
{
namespace
{

constexpr double mayBeLost = 0.2;          // of a gap that is too small already
constexpr std::uint64_t looksPerUnit = 16; // looks, most of them at a key, that cost what the visit of a box costs

class StepProof
{
public:
  StepProof(NearPairs& near, const StepTask& task, WorkBudget& budget)
    : near_(near), task_(task), step_(task.step), clearance_(task.clearance), budget_(budget)
  {
    this->whole_.turnTo = this->step_.turn(1.0);
    this->start_ = this->step_.from_W.q.toRotationMatrix();
  }

  StepVerdict judge()
  {
    const std::size_t looks = this->near_.leaves().size() + this->near_.triangles().size();
    if (!this->budget_.spend(1 + looks / looksPerUnit))
    {
      this->verdict_.share = 0.0;
      return std::move(this->verdict_);
    }
    this->near_.setStep(this->step_, this->task_.way_u);
    this->collect();
    for (const DoubtfulPair& doubt : this->verdict_.doubtful)
    {
      if (this->verdict_.share <= 0.0)
      {
        break;
      }
      doubt.leaf ? this->judgeLeaf(doubt.index) : this->judgeTriangles(doubt.index);
    }
    return std::move(this->verdict_);
  }

private:
  void collect()
  {
    std::vector<DoubtfulPair>& doubtful = this->verdict_.doubtful;
    for (std::uint32_t i = 0; i < this->near_.leaves().size(); ++i)
    {
      LeafPair& pair = this->near_.leaves()[i];
      if (!pair.split && !this->farEnough(pair))
      {
        this->note(pair, this->near_.gapOf(pair), true, i);
      }
    }
    for (std::uint32_t i = 0; i < this->near_.triangles().size(); ++i)
    {
      NearTriangles& pair = this->near_.triangles()[i];
      if (!this->farEnough(pair))
      {
        this->note(pair, this->gapOf(i), false, i);
      }
    }
    std::sort(doubtful.begin(), doubtful.end(),
      [](const DoubtfulPair& a, const DoubtfulPair& b)
      { return std::tie(a.crossing, a.leaf, a.index) < std::tie(b.crossing, b.leaf, b.index); });
  }

  /// Known to be so far away that no step of this length brings it near.
  template<class AnyPair>
  [[nodiscard]] bool farEnough(const AnyPair& pair) const
  {
    return this->near_.knownGap_u(pair) - this->task_.displacement_u > this->clearance_.gap_u;
  }

  template<class AnyPair>
  void note(AnyPair& pair, const SpanGap& gap, bool leaf, std::uint32_t index)
  {
    this->near_.learn(pair, gap.from);
    if (!(gap.least() >= this->clearance_.gap_u))
    {
      this->verdict_.doubtful.push_back({ gap.crossing(this->clearance_.gap_u), gap.to, leaf, index });
    }
  }

  /// What the plane of the last time says; without one nothing.
  [[nodiscard]] SpanGap gapOf(std::uint32_t index) const
  {
    const NearTriangles& pair = this->near_.triangles()[index];
    switch (pair.plane.kind)
    {
      case PlaneKind::InScene:
        return this->near_.gapOf(pair, pair.plane.n);
      case PlaneKind::InTool:
        return this->inTool(pair);
      case PlaneKind::None:
        break;
    }
    return {};
  }

  [[nodiscard]] SpanGap inTool(const NearTriangles& pair) const
  {
    const MovingPair moving = this->near_.moving(pair);
    return SpanProof(this->step_, this->whole_, moving).inTool(this->start_ * pair.plane.n);
  }

  [[nodiscard]] bool holds(const SpanGap& gap) const
  {
    return gap.leastUntil(this->verdict_.share) >= this->clearance_.gap_u;
  }

  void judgeLeaf(std::uint32_t index)
  {
    LeafPair& pair = this->near_.leaves()[index];
    if (this->holds(this->near_.gapOf(pair)) ||
        this->near_.findPlane(pair, this->verdict_.share, this->clearance_.gap_u))
    {
      return;
    }
    const std::size_t first = this->near_.triangles().size();
    this->near_.split(pair);
    for (std::size_t i = first; i < this->near_.triangles().size(); ++i)
    {
      this->judgeTriangles(static_cast<std::uint32_t>(i));
    }
  }

  void judgeTriangles(std::uint32_t index)
  {
    const SpanGap known = this->verdict_.share > 0.0 ? this->gapOf(index) : SpanGap();
    if (this->verdict_.share <= 0.0 || this->holds(known))
    {
      return;
    }
    NearTriangles& pair = this->near_.triangles()[index];
    const MovingPair moving = this->near_.moving(pair);
    PairProof proof(this->step_, this->clearanceFor(moving, known.from), this->budget_);
    const double proven = proof.provenUntil(moving, this->verdict_.share, pair.plane);
    if (proven < this->verdict_.share)
    {
      this->verdict_.share = proven;
      this->verdict_.blocking = static_cast<int>(index);
    }
  }

  /// A pair that stands nearer than the gap already may lose a fifth of what it has.
  [[nodiscard]] Clearance clearanceFor(const MovingPair& moving, double knownGap_u) const
  {
    if (knownGap_u >= this->clearance_.gap_u)
    {
      return this->clearance_;
    }
    const SpanProof proof(this->step_, this->whole_, moving);
    const double distance = nearestPair(proof.toolFrom_W(), moving.scene_W).distance_u;
    return { std::min(this->clearance_.gap_u, (1.0 - mayBeLost) * distance), this->clearance_.finest };
  }

  NearPairs& near_;
  const StepTask& task_;
  const ScrewStep& step_;
  Clearance clearance_;
  WorkBudget& budget_;
  Span whole_;
  Mat3 start_; ///< how the tool is turned where the step begins
  StepVerdict verdict_;
};

} // namespace

StepVerdict proveStep(NearPairs& near, const StepTask& task, WorkBudget& budget)
{
  return StepProof(near, task, budget).judge();
}

bool standsFree(NearPairs& near, const Pose& pose_W, double way_u, double gap_u)
{
  ScrewStep still;
  still.from_W = pose_W;
  near.setStep(still, way_u);
  for (LeafPair& pair : near.leaves())
  {
    if (!near.findPlane(pair, 0.0, gap_u))
    {
      near.split(pair);
    }
  }
  const Mat3 turn = pose_W.q.toRotationMatrix();
  return std::all_of(near.triangles().begin(), near.triangles().end(),
    [&](const NearTriangles& pair)
    {
      const MovingPair moving = near.moving(pair);
      const Corners tool_W = near.toolAt_W(pair.toolTriangle, turn, pose_W.p);
      return gapAlong(nearestPair(tool_W, moving.scene_W).n, tool_W, moving.scene_W) >= gap_u;
    });
}

} // namespace palpate
