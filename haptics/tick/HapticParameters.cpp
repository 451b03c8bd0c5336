// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/HapticParameters.h"

namespace palpate
{

std::string HapticParameters::validate() const
{
  std::string problem;
  TickStages::forEach(
    [this, &problem]<class S>(std::type_identity<S>)
    {
      if constexpr (requires { S::refuse(*this); })
      {
        problem = problem.empty() ? S::refuse(*this) : problem;
      }
    });
  return problem;
}

} // namespace palpate
