// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "haptics/session/soft/BodyMaker.h"

namespace palpate
{

/// A soft body in virtual time: a snapshot of one tick arrives one period later, on any machine.
class VirtualBody
{
public:
  /// `period_s`: from snapshot to snapshot, and the delay of each. The reference is kept.
  VirtualBody(BodyMaker& maker, double period_s) : maker_(maker), period_s_(period_s) {}

  /// Before a tick at `time_s`: the body for that tick; `hand`: of the tick before. The body returned before stays
  /// valid until the call after this one. Null if the first snapshot cannot be made.
  [[nodiscard]] const PressedBody* at(double time_s, const BodyHand& hand);
  /// The last snapshot.
  [[nodiscard]] const std::shared_ptr<const PressedBody>& now() const noexcept { return this->now_; }

private:
  [[nodiscard]] std::shared_ptr<const PressedBody> press(double time_s, const BodyHand& hand);

  BodyMaker& maker_;
  double period_s_;
  double due_s_ = 0.0; ///< arrival time of the pending snapshot
  double nextLook_s_ = std::numeric_limits<double>::lowest();
  std::shared_ptr<const PressedBody> before_, now_, underWay_;
};

} // namespace palpate
