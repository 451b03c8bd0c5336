// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace palpate
{

/// What of a recording this program does not know: how often, by name.
struct SkippedParts
{
  std::map<std::string, std::uint64_t> counts;

  void note(const std::string& name) { ++this->counts[name]; }

  /// Empty, or one phrase with the number of all and the first few names.
  [[nodiscard]] std::string describe() const;
};

} // namespace palpate
