// SPDX-License-Identifier: GPL-3.0-or-later
// A client's text about a server by the plugin that is loaded there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "vtkHapticSurfacePart.h"

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(SurfacePart, AServerOfTheSameVersionIsNothingToTellAndAnyOtherIsSaidWithTheCure)
{
  EXPECT_EQ(vtkHapticOtherVersion(PALPATE_VERSION), "");
  EXPECT_THAT(vtkHapticOtherVersion("99.9"), AllOf(HasSubstr("Palpate 99.9, and here is another"),
                                               HasSubstr(std::string("load the plugin Palpate ") + PALPATE_VERSION)));
  EXPECT_THAT(vtkHapticOtherVersion(""), AllOf(HasSubstr("does not answer"), HasSubstr("PV_PLUGIN_PATH")));
}
