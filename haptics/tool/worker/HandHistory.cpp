// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/worker/HandHistory.h"

#include <algorithm>

#include "haptics/tool/motion/Turn.h"

namespace palpate
{
namespace
{

constexpr double apart = 0.125; // of the tool's diagonal
constexpr double rounding_s = 1e-9;

bool isApart(const Pose& a_W, const Pose& b_W, const ToolMesh& tool)
{
  const double way_u = (b_W.p - a_W.p).norm() + turnFromTo(a_W.q, b_W.q).norm() * tool.reach_u;
  return way_u >= apart * tool.diagonal_u;
}

} // namespace

void HandHistory::note(const ToolHand& hand, const ToolMesh& tool)
{
  if (!hand.tracked || !refusePose(tool, hand.pose_W).empty())
  {
    return;
  }
  if (hand.map != this->map_)
  {
    this->past_.clear();
    this->map_ = hand.map;
  }
  if (this->past_.empty() || isApart(this->past_.back().pose_W, hand.pose_W, tool))
  {
    this->past_.push_back({ hand.pose_W, hand.time_s });
  }
  this->past_.back().left_s = hand.time_s;
  while (hand.time_s - this->past_.front().left_s > longest_s + rounding_s)
  {
    this->past_.pop_front();
  }
}

std::vector<Pose> HandHistory::newestFirst(const ToolHand& now) const
{
  std::vector<Pose> poses_W;
  for (auto past = this->past_.rbegin(); now.map == this->map_ && past != this->past_.rend(); ++past)
  {
    if (now.time_s - past->left_s <= longest_s + rounding_s)
    {
      poses_W.push_back(past->pose_W);
    }
  }
  return poses_W;
}

} // namespace palpate
