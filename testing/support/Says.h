// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <string_view>

namespace palpate::test
{

/// Whether `text` names each fact: a file, a number with its unit, the noun that matters. A sentence may be worded
/// anew, a fact may not get lost.
inline ::testing::AssertionResult says(std::string_view text, std::initializer_list<std::string_view> facts)
{
  std::string missing;
  for (const std::string_view fact : facts)
  {
    missing += text.find(fact) == std::string_view::npos ? " \"" + std::string(fact) + "\"" : "";
  }
  return missing.empty() ? ::testing::AssertionSuccess()
                         : ::testing::AssertionFailure() << "\"" << text << "\" does not name" << missing;
}

} // namespace palpate::test
