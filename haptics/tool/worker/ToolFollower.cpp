// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/worker/ToolFollower.h"

#include <utility>

namespace palpate
{

ToolFollower::ToolFollower(ToolMove move, ToolLinks& links, std::uint64_t work)
  : move_(std::move(move)), links_(links), work_(work)
{
  this->publish();
}

void ToolFollower::step()
{
  const ToolHand hand = this->links_.hand.read();
  if (!hand.tracked || !this->isPlaced(hand.pose_W))
  {
    return;
  }
  this->report_.last = this->move_.update(hand.pose_W, this->work_);
  ++this->report_.updates;
  this->report_.spent += this->report_.last.spent ? 1 : 0;
  this->held_ = this->report_.last.spent ? this->held_ + 1 : 0;
  if (this->held_ == 0 || this->held_ > longestHeld)
  {
    this->publish();
  }
  this->links_.report.write(this->report_);
}

/// True if the tool stands somewhere, at the latest now: a hand comes from outside, where it was free.
bool ToolFollower::isPlaced(const Pose& hand_W)
{
  const bool placed = this->move_.placed() || this->move_.place(hand_W).empty();
  this->report_.placed = placed;
  this->links_.report.write(this->report_);
  return placed;
}

void ToolFollower::publish()
{
  ToolContacts contacts = this->move_.contacts();
  contacts.revision = ++this->revision_;
  this->links_.contacts.write(contacts);
}

} // namespace palpate
