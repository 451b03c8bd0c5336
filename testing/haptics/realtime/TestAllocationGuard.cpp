// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <mutex>

#include <gtest/gtest.h>

#include "testing/support/AllocationGuard.h"

namespace palpate::test
{
namespace
{

TEST(AllocationGuard, SeesAnAllocationItsFreeingAndALock)
{
  if (!AllocationGuard::works())
  {
    SUCCEED() << "the sanitizer has taken the allocator's place";
    return;
  }
  std::mutex mutex;
  const AllocationGuard guard;
  auto* volatile memory = new int(1);
  delete memory;
  mutex.lock();
  mutex.unlock();
  EXPECT_EQ(guard.allocations(), 1U);
  EXPECT_EQ(guard.frees(), 1U);
  EXPECT_EQ(guard.locks(), 1U);
}

} // namespace
} // namespace palpate::test
