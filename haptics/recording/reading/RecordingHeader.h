// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{

/// The text of a recording before its chunks.
struct RecordingHeader
{
  std::string problem; ///< empty, or why the recording cannot be read
  std::string device;
  std::size_t size = 0; ///< bytes
};

/// The remedy for a recording whose bytes are damaged.
inline constexpr const char* otherCopy = ": take another copy of it, or record it again";

/// Of bytes that are not trusted.
[[nodiscard]] RecordingHeader readRecordingHeader(const std::vector<char>& bytes);

} // namespace palpate
