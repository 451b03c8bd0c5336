// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/worker/ToolFollower.h"

#include <utility>

#include "haptics/core/PoseMath.h"

namespace palpate
{
namespace
{

ToolContacts toWorld(const Pose& scene_WS, ToolContacts set)
{
  set.pose_W = scene_WS * set.pose_W;
  for (std::uint32_t i = 0; i < set.count; ++i)
  {
    set.contacts[i].n_W = scene_WS.q * set.contacts[i].n_W;
    set.contacts[i].arm_W = scene_WS.q * set.contacts[i].arm_W;
  }
  return set;
}

} // namespace

ToolFollower::ToolFollower(ToolMove move_S, ToolLinks& links, std::uint64_t work, const ToolStart& start)
  : move_S_(std::move(move_S)), links_(links), work_(work), scene_WS_(start.scene_WS), revision_(start.revision)
{
  bool placed = start.tool_W && this->isPlaced(into(this->scene_WS_, *start.tool_W));
  for (std::size_t i = 0; !placed && i < start.came_W.size(); ++i)
  {
    placed = this->isPlaced(into(this->scene_WS_, start.came_W[i]));
  }
  this->publish();
}

void ToolFollower::carry(const Pose& scene_WS)
{
  this->scene_WS_ = scene_WS;
  this->publish();
}

void ToolFollower::step()
{
  const ToolHand hand = this->links_.hand.read();
  const Pose hand_S = into(this->scene_WS_, hand.pose_W);
  if (!hand.tracked || !this->isPlaced(hand_S))
  {
    return;
  }
  this->move_S_.rub(hand.friction);
  this->report_.last = this->move_S_.update(hand_S, this->work_);
  ++this->report_.updates;
  this->report_.spent += this->report_.last.spent ? 1 : 0;
  this->held_ = this->report_.last.spent ? this->held_ + 1 : 0;
  if (this->held_ == 0 || this->held_ > longestHeld)
  {
    this->publish();
  }
  this->links_.report.write(this->report_);
}

std::optional<Pose> ToolFollower::tool_W() const
{
  return this->move_S_.placed() ? std::optional(this->scene_WS_ * this->move_S_.pose_W()) : std::nullopt;
}

/// True if the tool has a pose, which it may get now: a hand comes from outside, where the tool was free.
bool ToolFollower::isPlaced(const Pose& hand_S)
{
  const bool placed = this->move_S_.placed() || this->move_S_.place(hand_S).empty();
  this->report_.placed = placed;
  this->links_.report.write(this->report_);
  return placed;
}

void ToolFollower::publish()
{
  ToolContacts contacts = toWorld(this->scene_WS_, this->move_S_.contacts());
  contacts.held = true;
  contacts.revision = ++this->revision_;
  this->links_.contacts.write(contacts);
}

} // namespace palpate
