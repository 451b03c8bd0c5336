// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <thread>

namespace palpate::test
{

/// Waits until something holds, generously: a machine may be busy.
template<class Condition>
bool eventually(Condition condition)
{
  for (int i = 0; i < 4000; ++i)
  {
    if (condition())
    {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

} // namespace palpate::test
