// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <new>

namespace palpate
{

/// Work that may need more memory than there is: no room for a factor is no reason to end the program that asked for
/// it. `giveUp` frees what the work was about and says why.
template<class Work, class GiveUp>
void inItsMemory(const Work& work, const GiveUp& giveUp)
{
  try
  {
    work();
  }
  catch (const std::bad_alloc&)
  {
    giveUp();
  }
}

} // namespace palpate
