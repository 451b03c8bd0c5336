// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/move/TouchRows.h"

#include <algorithm>
#include <tuple>

#include "haptics/tool/move/RowCells.h"

namespace palpate
{
namespace
{

constexpr double touchingWithin = 4.0; // rest gaps
constexpr double blockingWithin = 2.0;
constexpr double cellOfRows = 32.0; // rest gaps
constexpr std::size_t mostDeep = 8; // pairs beside the one that blocks

/// True if the plane between two leaves shows a larger gap.
bool showsMore(NearPairs& near, LeafPair& pair, double gap_u)
{
  if (pair.n_W.isZero())
  {
    near.findPlane(pair, 0.0, gap_u);
  }
  const double gap = near.gapOf(pair).from;
  near.learn(pair, gap);
  return gap > gap_u;
}

} // namespace

TouchRows::TouchRows(const BoxedMesh& tool_B, const BoxedMesh& scene_W, double restGap_u)
  : tool_B_(tool_B), scene_W_(scene_W), restGap_u_(restGap_u),
    cells_(std::make_unique<RowCells>(cellOfRows * restGap_u))
{
}

TouchRows::~TouchRows() = default;
TouchRows::TouchRows(TouchRows&& other) noexcept = default;

void TouchRows::findTouching(NearPairs& near, const Pose& pose_W, double way_u)
{
  this->rows_.clear();
  this->cells_->clear();
  this->asked_ = 0;
  ScrewStep still;
  still.from_W = pose_W;
  near.setStep(still, way_u);
  const Place place{ pose_W.q.toRotationMatrix(), pose_W.p, still };
  const double within_u = touchingWithin * this->restGap_u_;
  for (LeafPair& pair : near.leaves())
  {
    if (!pair.split && !pair.featureless && near.knownGap_u(pair) <= within_u && !showsMore(near, pair, within_u))
    {
      this->addLeaves(near, place, pair, within_u);
    }
  }
  for (NearTriangles& pair : near.triangles())
  {
    if (near.knownGap_u(pair) <= within_u)
    {
      near.learn(pair, this->addPair(near, place, pair.toolTriangle, pair.sceneTriangle, within_u).apart_u);
    }
  }
}

bool TouchRows::addBlocking(const NearPairs& near, const ScrewStep& step, const StepVerdict& verdict)
{
  if (verdict.blocking < 0)
  {
    return false;
  }
  const Pose there_W = step.end_W(verdict.share);
  const Place place{ there_W.q.toRotationMatrix(), there_W.p,
    { step.from_W, verdict.share * step.v_W, verdict.share * step.w_W } };
  const NearTriangles& pair = near.triangles()[verdict.blocking];
  std::size_t added =
    this->addPair(near, place, pair.toolTriangle, pair.sceneTriangle, blockingWithin * this->restGap_u_).count;
  std::vector<DoubtfulPair> deepest = verdict.doubtful;
  const std::size_t looked = std::min(deepest.size(), 8 * mostDeep);
  std::partial_sort(deepest.begin(), deepest.begin() + static_cast<std::ptrdiff_t>(looked), deepest.end(),
    [](const DoubtfulPair& a, const DoubtfulPair& b)
    { return std::tie(a.end_u, a.leaf, a.index) < std::tie(b.end_u, b.leaf, b.index); });
  std::size_t withFeatures = 0;
  for (std::size_t i = 0; i < looked && withFeatures < mostDeep; ++i)
  {
    const std::size_t more = this->addDoubtful(near, place, deepest[i]);
    added += more;
    withFeatures += more > 0 ? 1 : 0;
  }
  if (added == 0)
  {
    const Corners tool_W = near.toolAt_W(pair.toolTriangle, place.turn, place.centre_W);
    const TouchFeature nearest =
      nearestFeature(tool_W, this->scene_W_.corners(pair.sceneTriangle), place.turn, place.centre_W);
    added += this->add(nearest, place) ? 1 : 0;
  }
  return added > 0;
}

std::size_t TouchRows::addDoubtful(const NearPairs& near, const Place& place, const DoubtfulPair& doubt)
{
  const double within_u = blockingWithin * this->restGap_u_;
  if (!doubt.leaf)
  {
    const NearTriangles& pair = near.triangles()[doubt.index];
    return this->addPair(near, place, pair.toolTriangle, pair.sceneTriangle, within_u).count;
  }
  return this->addLeaves(near, place, near.leaves()[doubt.index], within_u);
}

std::size_t TouchRows::addLeaves(const NearPairs& near, const Place& place, const LeafPair& pair, double within_u)
{
  const BoxedMesh::Node &a = this->tool_B_.nodes()[pair.toolNode], &b = this->scene_W_.nodes()[pair.sceneNode];
  std::size_t added = 0;
  for (std::uint32_t i = a.second; i < a.second + a.count; ++i)
  {
    for (std::uint32_t j = b.second; j < b.second + b.count; ++j)
    {
      added += this->addPair(near, place, i, j, within_u).count;
    }
  }
  return added;
}

TouchRows::Added TouchRows::addPair(
  const NearPairs& near, const Place& place, std::uint32_t tool, std::uint32_t scene, double within_u)
{
  PosedPair pair;
  pair.toolFlat = this->tool_B_.flat(tool);
  pair.sceneFlat = this->scene_W_.flat(scene);
  if (pair.toolFlat.all() && pair.sceneFlat.all())
  {
    return {};
  }
  pair.tool_W = near.toolAt_W(tool, place.turn, place.centre_W);
  pair.scene_W = this->scene_W_.corners(scene);
  ++this->asked_;
  this->found_.clear();
  Added added;
  added.apart_u = appendFeatures(pair, place.turn, place.centre_W, within_u, this->found_);
  added.count = static_cast<std::size_t>(std::count_if(
    this->found_.begin(), this->found_.end(), [&](const TouchFeature& feature) { return this->add(feature, place); }));
  return added;
}

bool TouchRows::add(const TouchFeature& feature, const Place& place)
{
  TouchRow row;
  row.feature = feature;
  row.plane = planeAt(feature, place.turn, place.centre_W);
  row.offset_u = row.plane.gap_u;
  row.offset_u = 2.0 * row.plane.gap_u - row.linear_u(place.made);
  constexpr double sameDirection = 1e-7; // radians: rows that differ less would repeat one another
  const bool known = this->cells_->any(row.plane.arm_W, this->restGap_u_,
    [&](std::uint32_t number)
    {
      const TouchRow& other = this->rows_[number];
      return (other.plane.n_W - row.plane.n_W).squaredNorm() < sameDirection * sameDirection &&
             (other.plane.arm_W - row.plane.arm_W).cwiseAbs().maxCoeff() < this->restGap_u_;
    });
  if (!known)
  {
    this->rows_.push_back(row);
    this->cells_->add(row.plane.arm_W);
  }
  return !known;
}

} // namespace palpate
