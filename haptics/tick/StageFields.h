// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tick/Stages.h"

namespace palpate
{

/// Calls function(name of the stage, fields) for each stage with a plan, where fields(visit, parameters...) hands each
/// member of that plan to visit(name, member...). Of several parameters it takes the same member of each.
template<class Function>
void forEachPlan(const Function& function)
{
  TickStages::forEach(
    [&function]<class S>(std::type_identity<S>)
    {
      if constexpr (HasPlan<S>)
      {
        function(S::name, [](const auto& visit, auto&... parameters) { S::planFields(visit, parameters...); });
      }
    });
}

/// The same for each stage whose state is part of a recording.
template<class Function>
void forEachState(const Function& function)
{
  TickStages::forEach(
    [&function]<class S>(std::type_identity<S>)
    {
      if constexpr (RecordsState<S>)
      {
        function(S::name, [](const auto& visit, auto&... states) { S::stateFields(visit, states...); });
      }
    });
}

} // namespace palpate
