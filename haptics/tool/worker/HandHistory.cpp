// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/worker/HandHistory.h"

#include <algorithm>

#include "haptics/tool/motion/Turn.h"

namespace palpate
{
namespace
{

constexpr double apart = 0.125; // of the tool's diagonal

} // namespace

void HandHistory::note(const ToolHand& hand, const ToolMesh& tool)
{
  if (!hand.tracked || !refusePose(tool, hand.pose_W).empty())
  {
    return;
  }
  if (!this->poses_W_.empty())
  {
    const Pose& last_W = this->poses_W_[(this->next_ + this->poses_W_.size() - 1) % this->poses_W_.size()];
    const double way_u = (hand.pose_W.p - last_W.p).norm() + turnFromTo(last_W.q, hand.pose_W.q).norm() * tool.reach_u;
    if (way_u < apart * tool.diagonal_u)
    {
      return;
    }
  }
  if (this->poses_W_.size() < capacity)
  {
    this->poses_W_.push_back(hand.pose_W);
    return;
  }
  this->poses_W_[this->next_] = hand.pose_W;
  this->next_ = (this->next_ + 1) % capacity;
}

std::vector<Pose> HandHistory::newestFirst() const
{
  std::vector<Pose> poses_W = this->poses_W_;
  std::rotate(poses_W.begin(), poses_W.begin() + static_cast<std::ptrdiff_t>(this->next_), poses_W.end());
  std::reverse(poses_W.begin(), poses_W.end());
  return poses_W;
}

} // namespace palpate
