// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>
#include <utility>

namespace palpate
{

/// Runs both, at the same time if `threads` > 1 and the system has a thread to give, else one after the other. Returns
/// when both have ended; throws the exception of one of them, that of the first before that of the second. Neither may
/// write to data that the other reads or writes.
template<class First, class Second>
void inTwo(unsigned threads, First&& first, Second&& second)
{
  // Without a thread to be had, a task that may be deferred is.
  const auto policy = threads > 1 ? std::launch::async | std::launch::deferred : std::launch::deferred;
  std::future<void> other = std::async(policy, [&second] { second(); });
  first(); // where it throws, the future waits for the other as it goes
  other.get();
}

} // namespace palpate
