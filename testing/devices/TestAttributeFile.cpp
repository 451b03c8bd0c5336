// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "devices/common/AttributeFile.h"

namespace palpate
{
namespace
{

TEST(AttributeFile, IsReadWhole)
{
  EXPECT_EQ(contentOf("/proc/sys/kernel/ostype"), "Linux\n");
}

// Page 0 of a process is no memory: the file opens, and to read it is an error, as of a device that has just gone.
TEST(AttributeFile, ThatOpensAndCannotBeReadIsEmpty)
{
  EXPECT_NO_THROW(EXPECT_EQ(contentOf("/proc/self/mem"), ""));
  EXPECT_EQ(contentOf("/proc"), "");
  EXPECT_EQ(contentOf("/no/such/file"), "");
}

} // namespace
} // namespace palpate
