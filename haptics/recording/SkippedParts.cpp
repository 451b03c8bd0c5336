// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/SkippedParts.h"

namespace palpate
{

std::string SkippedParts::describe() const
{
  constexpr std::size_t mostNames = 4;
  std::uint64_t all = 0;
  std::size_t named = 0;
  std::string names;
  for (const auto& [name, count] : this->counts)
  {
    all += count;
    if (named++ < mostNames)
    {
      names += (names.empty() ? "" : ", ") + name + " (" + std::to_string(count) + ")";
    }
  }
  if (all == 0)
  {
    return {};
  }
  return std::to_string(all) + (all == 1 ? " part was" : " parts were") +
         " skipped that this program does not know: " + names + (named > mostNames ? " and others" : "");
}

} // namespace palpate
