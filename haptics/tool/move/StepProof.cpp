// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/move/StepProof.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace palpate
{
namespace
{

constexpr double mayBeLost = 0.2; // of a gap that is too small already

/// The larger gap along the planes of the two triangles.
double gapByFaces(const Corners& tool_W, const Corners& scene_W)
{
  double best = -std::numeric_limits<double>::infinity();
  for (const Vec3& n : { unitNormal(scene_W), unitNormal(tool_W) })
  {
    best = std::max({ best, gapAlong(n, tool_W, scene_W), gapAlong(-n, tool_W, scene_W) });
  }
  return best;
}

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
    if (!this->budget_.spend(1 + looks / work_price::looksPerUnit))
    {
      this->verdict_.share = 0.0;
      return std::move(this->verdict_);
    }
    this->near_.setStep(this->step_, this->task_.way_u);
    this->budget_.charge(this->collect() * work_price::gap);
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
  /// Returns the number of gaps that it computed.
  std::uint64_t collect()
  {
    std::vector<DoubtfulPair>& doubtful = this->verdict_.doubtful;
    std::uint64_t asked = 0;
    for (std::uint32_t i = 0; i < this->near_.leaves().size(); ++i)
    {
      LeafPair& pair = this->near_.leaves()[i];
      if (!pair.split && !this->farEnough(pair))
      {
        ++asked;
        this->note(pair, this->near_.gapOf(pair), true, i);
      }
    }
    for (std::uint32_t i = 0; i < this->near_.triangles().size(); ++i)
    {
      NearTriangles& pair = this->near_.triangles()[i];
      if (!this->farEnough(pair))
      {
        ++asked;
        this->note(pair, this->gapOf(i), false, i);
      }
    }
    std::sort(doubtful.begin(), doubtful.end(),
      [](const DoubtfulPair& a, const DoubtfulPair& b)
      { return std::tie(a.crossing, a.leaf, a.index) < std::tie(b.crossing, b.leaf, b.index); });
    return asked;
  }

  /// True if the pair is known to be so far away that no step of this length brings it near.
  template<class AnyPair>
  [[nodiscard]] bool farEnough(const AnyPair& pair) const
  {
    return this->near_.knownGap_u(pair) - this->task_.displacement_u > this->clearance_.gap_u;
  }

  template<class AnyPair>
  void note(AnyPair& pair, const SpanGap& gap, bool leaf, std::uint32_t index)
  {
    this->near_.learn(pair, gap);
    if (!(gap.least() >= this->clearance_.gap_u))
    {
      this->verdict_.doubtful.push_back({ gap.crossing(this->clearance_.gap_u), gap.to, leaf, index });
    }
  }

  /// The gap along the pair's last plane; without a plane no gap.
  [[nodiscard]] SpanGap gapOf(std::uint32_t index)
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

  [[nodiscard]] SpanGap inTool(const NearTriangles& pair)
  {
    const MovingPair moving = this->near_.moving(pair);
    return SpanProof(this->step_, this->whole_, moving).inTool(this->start_ * pair.plane.n);
  }

  [[nodiscard]] bool holds(const SpanGap& gap) const
  {
    return gap.leastUntil(this->verdict_.share) >= this->clearance_.gap_u;
  }

  /// The part of the share that a known plane proves, because no work is left to search for another plane.
  [[nodiscard]] double shareBy(const SpanGap& known) const
  {
    double share = this->verdict_.share;
    while (share > this->clearance_.finest && !(known.leastUntil(share) >= this->clearance_.gap_u))
    {
      share *= 0.5;
    }
    return share > this->clearance_.finest ? share : 0.0;
  }

  void judgeLeaf(std::uint32_t index)
  {
    LeafPair& pair = this->near_.leaves()[index];
    const SpanGap known = this->near_.gapOf(pair);
    if (this->holds(known))
    {
      return;
    }
    if (!this->budget_.spend(work_price::leafPlane))
    {
      this->verdict_.share = this->shareBy(known);
      return;
    }
    if (this->near_.findPlane(pair, this->verdict_.share, this->clearance_.gap_u))
    {
      this->near_.learn(pair, this->near_.gapOf(pair));
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
    if (this->budget_.left() == 0)
    {
      this->verdict_.share = this->shareBy(known);
      return;
    }
    NearTriangles& pair = this->near_.triangles()[index];
    const MovingPair moving = this->near_.moving(pair);
    const Start start = this->startOf(moving, known.from);
    this->near_.learn(pair, start.gap_u);
    if (this->farEnough(pair))
    {
      return;
    }
    PairProof proof(this->step_, start.clearance, this->budget_);
    const double proven = proof.provenUntil(moving, this->verdict_.share, pair.plane, start.nearest);
    if (proven < this->verdict_.share)
    {
      this->verdict_.share = this->budget_.left() > 0 ? proven : std::max(proven, this->shareBy(known));
      this->verdict_.blocking = static_cast<int>(index);
    }
    else if (pair.plane.kind != PlaneKind::None)
    {
      this->near_.learn(pair, this->gapOf(index));
    }
  }

  /// A pair at the start of the step.
  struct Start
  {
    Clearance clearance;
    double gap_u = 0.0;                 ///< lower bound
    std::optional<NearestPair> nearest; ///< if it had to be computed
  };

  /// A pair that is nearer than the gap already may lose a fifth of its distance. In most cases a plane of one of the
  /// two triangles shows whether it is.
  [[nodiscard]] Start startOf(const MovingPair& moving, double knownGap_u) const
  {
    const double plenty_u = this->clearance_.gap_u / (1.0 - mayBeLost);
    Corners tool_W = moving.arms_W;
    for (Vec3& p : tool_W)
    {
      p += this->step_.from_W.p;
    }
    const double byFaces_u = std::max(gapByFaces(tool_W, moving.scene_W), boxesApart_u(tool_W, moving.scene_W));
    if (byFaces_u > plenty_u || knownGap_u >= this->clearance_.gap_u)
    {
      return { this->clearance_, std::max(byFaces_u, knownGap_u), std::nullopt };
    }
    const NearestPair nearest = nearestPair(tool_W, moving.scene_W);
    return { { std::min(this->clearance_.gap_u, (1.0 - mayBeLost) * nearest.distance_u), this->clearance_.finest }, 0.0,
      nearest };
  }

  NearPairs& near_;
  const StepTask& task_;
  const ScrewStep& step_;
  Clearance clearance_;
  WorkBudget& budget_;
  Span whole_;
  Mat3 start_; ///< rotation of the tool at the start of the step
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
