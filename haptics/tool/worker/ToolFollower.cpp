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
  if (!hand.tracked)
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

void ToolFollower::publish()
{
  ToolContacts contacts = this->move_.contacts();
  contacts.revision = ++this->revision_;
  this->links_.contacts.write(contacts);
}

} // namespace palpate
