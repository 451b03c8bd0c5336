// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/pairs/PairFront.h"

#include <algorithm>

namespace palpate
{
namespace
{

constexpr double touchingWithin = 16.0; // rest gaps
constexpr std::size_t mostNear = 4000;  // leaves, and twice those that touch
constexpr std::size_t mostGrowth = 4000;

} // namespace

PairFront::PairFront(const BoxedMesh& tool_B, const BoxedMesh& scene_W, double restGap_u)
  : tool_B_(tool_B), scene_W_(scene_W), restGap_u_(restGap_u)
{
}

double PairFront::room_u() const noexcept
{
  return this->pending_.empty() ? this->margin_u_ - this->restGap_u_ - (this->way_u_ - this->gathered_u_) : 0.0;
}

void PairFront::begin(double margin_u)
{
  this->margin_u_ = margin_u;
  this->gathered_u_ = this->way_u_;
  this->touching_ = 0;
  this->front_.insert(this->front_.end(), this->near_.begin(), this->near_.end());
  this->near_.clear();
  if (this->front_.empty() || this->front_.size() > 2 * this->freshFront_ + mostGrowth)
  {
    this->front_.clear();
    this->freshFront_ = 0;
    this->pending_ = { BoxPair{} };
    return;
  }
  const auto reached = std::partition(this->front_.begin(), this->front_.end(),
    [&](const BoxPair& pair) { return pair.key_u > this->way_u_ + margin_u; });
  this->pending_.assign(reached, this->front_.end());
  this->front_.erase(reached, this->front_.end());
}

bool PairFront::gather(const Pose& pose_W, double margin_u, WorkBudget& budget)
{
  if (this->pending_.empty())
  {
    this->begin(margin_u);
  }
  const BoxPose pose(pose_W);
  while (!this->pending_.empty())
  {
    if (!budget.spend())
    {
      return false;
    }
    const BoxPair pair = this->pending_.back();
    this->pending_.pop_back();
    this->visit(pair, pose);
    if (this->near_.size() > mostNear + 2 * this->touching_ && this->margin_u_ > touchingWithin * this->restGap_u_)
    {
      this->shrink();
    }
  }
  this->freshFront_ = this->freshFront_ == 0 ? this->front_.size() + this->near_.size() : this->freshFront_;
  return true;
}

void PairFront::visit(const BoxPair& pair, const BoxPose& pose)
{
  const BoxedMesh::Node &a = this->tool_B_.nodes()[pair.tool], &b = this->scene_W_.nodes()[pair.scene];
  const double gap = boxGap(a.box, pose, b.box);
  const BoxPair known{ pair.tool, pair.scene, this->way_u_ + gap };
  if (gap > this->margin_u_)
  {
    this->front_.push_back(known);
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

/// Halves the margin, so that one place full of triangles does not make the list long.
void PairFront::shrink()
{
  this->margin_u_ *= 0.5;
  const auto out = std::partition(this->near_.begin(), this->near_.end(),
    [&](const BoxPair& pair) { return pair.key_u <= this->way_u_ + this->margin_u_; });
  this->front_.insert(this->front_.end(), out, this->near_.end());
  this->near_.erase(out, this->near_.end());
}

} // namespace palpate
