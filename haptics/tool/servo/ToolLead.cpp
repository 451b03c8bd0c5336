// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/servo/ToolLead.h"

namespace palpate
{
namespace
{

constexpr double leastLength2 = 0.25, mostLength2 = 4.0; // of a unit quaternion with large rounding errors

} // namespace

Pose leadTool(const Pose& hand_W, bool anew, ToolLead& lead) noexcept
{
  const double length2 = hand_W.q.squaredNorm();
  if (!(length2 >= leastLength2 && length2 <= mostLength2))
  {
    return { hand_W.p, lead.turn_W };
  }
  const Quat hand = hand_W.q.normalized();
  if (anew || !lead.taken)
  {
    lead.grip = (hand.conjugate() * lead.turn_W).normalized();
    lead.taken = true;
  }
  lead.turn_W = (hand * lead.grip).normalized();
  return { hand_W.p, lead.turn_W };
}

} // namespace palpate
