// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/pairs/PairFront.h"

#include <algorithm>

namespace palpate
{
namespace
{

constexpr double touchingWithin = 16.0; // rest gaps
/// Leaves, and twice those that touch. To make a list of thousands takes most of the work of an update.
constexpr std::size_t mostNear = 500;
constexpr std::size_t mostGrowth = 4000;
constexpr double soonReached = 4.0; // margins: a plane is kept for pairs that are no further away

} // namespace

PairFront::PairFront(const BoxedMesh& tool_B, const BoxedMesh& scene_W, double restGap_u)
  : tool_B_(tool_B), scene_W_(scene_W), restGap_u_(restGap_u)
{
}

double PairFront::room_u() const noexcept
{
  return this->pending_.empty() ? this->margin_u_ - this->restGap_u_ - (this->way_u_ - this->gathered_u_) : 0.0;
}

void PairFront::Beyond::clear()
{
  this->keys_u.clear();
  this->pairs.clear();
  this->planes.clear();
}

void PairFront::Beyond::add(const BoxPair& pair, const BoxPlane& plane)
{
  this->keys_u.push_back(pair.key_u);
  this->pairs.push_back(pair);
  this->planes.push_back(plane);
}

/// The last entry takes its place.
void PairFront::Beyond::remove(std::size_t at)
{
  this->keys_u[at] = this->keys_u.back();
  this->pairs[at] = this->pairs.back();
  this->planes[at] = this->planes.back();
  this->keys_u.pop_back();
  this->pairs.pop_back();
  this->planes.pop_back();
}

void PairFront::begin(const BoxPose& pose, double margin_u, WorkBudget& budget)
{
  this->margin_u_ = margin_u;
  this->gathered_u_ = this->way_u_;
  this->touching_ = 0;
  if (this->front_.size() + this->near_.size() > 2 * this->freshFront_ + mostGrowth ||
      this->front_.size() + this->near_.size() == 0)
  {
    this->front_.clear();
    this->near_.clear();
    this->freshFront_ = 0;
    this->pending_ = { BoxPair{} };
    return;
  }
  const double reach_u = this->way_u_ + margin_u;
  std::uint64_t asked = 0;
  for (std::size_t i = 0; i < this->front_.size();)
  {
    double& key_u = this->front_.keys_u[i];
    if (key_u > reach_u)
    {
      ++i;
      continue;
    }
    ++asked;
    const BoxPair& pair = this->front_.pairs[i];
    key_u = this->way_u_ + this->front_.planes[i].gap_u(this->tool_B_.nodes()[pair.tool].box, pose, this->turned_rad_);
    if (!(key_u > reach_u))
    {
      this->pending_.push_back(pair);
      this->front_.remove(i);
    }
  }
  this->pending_.insert(this->pending_.end(), this->near_.begin(), this->near_.end());
  this->near_.clear();
  budget.charge(asked / work_price::planesPerUnit);
}

bool PairFront::gather(const Pose& pose_W, double margin_u, WorkBudget& budget)
{
  const BoxPose pose(pose_W);
  if (this->pending_.empty())
  {
    this->begin(pose, margin_u, budget);
  }
  while (!this->pending_.empty())
  {
    if (!budget.spend())
    {
      return false;
    }
    const BoxPair pair = this->pending_.back();
    this->pending_.pop_back();
    this->prefetch();
    this->visit(pair, pose);
    if (this->near_.size() > mostNear + 2 * this->touching_ && this->margin_u_ > touchingWithin * this->restGap_u_)
    {
      this->shrink();
    }
  }
  this->freshFront_ = this->freshFront_ == 0 ? this->front_.size() + this->near_.size() : this->freshFront_;
  return true;
}

/// Prefetches the boxes of a pair that is visited soon: those of a large mesh lie far apart in memory.
void PairFront::prefetch() const noexcept
{
  constexpr std::size_t ahead = 4;
  if (this->pending_.size() >= ahead)
  {
    const BoxPair& soon = this->pending_[this->pending_.size() - ahead];
    __builtin_prefetch(&this->tool_B_.nodes()[soon.tool]);
    __builtin_prefetch(&this->scene_W_.nodes()[soon.scene]);
  }
}

void PairFront::visit(const BoxPair& pair, const BoxPose& pose)
{
  const BoxedMesh::Node &a = this->tool_B_.nodes()[pair.tool], &b = this->scene_W_.nodes()[pair.scene];
  const BoxGap found = boxGap(a.box, pose, b.box);
  const double gap = found.gap_u;
  const BoxPair known{ pair.tool, pair.scene, this->way_u_ + gap };
  if (gap > this->margin_u_)
  {
    const bool soon = gap <= soonReached * this->margin_u_;
    this->front_.add(known, soon ? BoxPlane(found, a.box, pose, b.box, this->turned_rad_) : BoxPlane());
  }
  else if (a.leaf() && b.leaf())
  {
    this->near_.push_back(known);
    this->touching_ += gap <= touchingWithin * this->restGap_u_ ? 1 : 0;
  }
  else
  {
    this->split(pair, b.leaf() || (!a.leaf() && a.box.half().squaredNorm() > b.box.half().squaredNorm()));
  }
}

void PairFront::split(const BoxPair& pair, bool tool)
{
  const BoxedMesh::Node& node = tool ? this->tool_B_.nodes()[pair.tool] : this->scene_W_.nodes()[pair.scene];
  for (const std::uint32_t child : { node.second, (tool ? pair.tool : pair.scene) + 1 })
  {
    this->pending_.push_back(tool ? BoxPair{ child, pair.scene, 0.0 } : BoxPair{ pair.tool, child, 0.0 });
  }
}

/// Halves the margin, so that a dense group of triangles does not make the list long.
void PairFront::shrink()
{
  this->margin_u_ *= 0.5;
  const auto out = std::partition(this->near_.begin(), this->near_.end(),
    [&](const BoxPair& pair) { return pair.key_u <= this->way_u_ + this->margin_u_; });
  for (auto pair = out; pair != this->near_.end(); ++pair)
  {
    this->front_.add(*pair, BoxPlane());
  }
  this->near_.erase(out, this->near_.end());
}

} // namespace palpate
