// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/hid/PidHabits.h"

namespace palpate::test
{

std::string PidHabits::text() const
{
  std::string text = this->pointsTo ? "points to" : "comes from";
  text += this->bindsTrigger ? ", binds the trigger" : "";
  text += this->stopAllDisables ? ", stop disables" : "";
  text += this->conditions == ConditionOrder::OnlyAfterSetEffect  ? ", settings first"
          : this->conditions == ConditionOrder::OnlyWithSetEffect ? ", settings last"
                                                                  : "";
  text += this->wakesCentred ? ", wakes centred" : "";
  text += this->deadConditions ? ", dead conditions" : "";
  text += this->oneMotor ? ", one motor" : "";
  text += this->wipesSilently ? ", wipes silently" : "";
  return text;
}

std::vector<PidHabits> allHabits()
{
  std::vector<PidHabits> all;
  constexpr unsigned switches = 7;
  for (const ConditionOrder order :
    { ConditionOrder::Any, ConditionOrder::OnlyAfterSetEffect, ConditionOrder::OnlyWithSetEffect })
  {
    for (unsigned bits = 0; bits < 1U << switches; ++bits)
    {
      const auto on = [bits](unsigned i) { return (bits >> i & 1U) != 0; };
      all.push_back({ on(0), on(1), on(2), order, on(3), on(4), on(5), on(6) });
    }
  }
  return all;
}

} // namespace palpate::test
