// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/reading/RecordingHeader.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "haptics/core/Checksum.h"
#include "haptics/recording/Recording.h"
#include "haptics/recording/bytes/RecordingLayout.h"

namespace palpate
{
namespace
{

std::string deviceIn(const std::string& text)
{
  const std::string field = "\ndevice: ";
  const std::size_t at = text.find(field);
  return at == std::string::npos ? "" : text.substr(at + field.size(), text.find('\n', at + 1) - at - field.size());
}

/// Whether its last line is the checksum of the lines before; none: there is no such line.
std::optional<bool> checkOf(std::string_view header)
{
  const std::size_t last = headerCheckDigits + headerEnd.size();
  const std::string_view text = header.substr(0, header.size() - std::min(last, header.size()));
  if (!text.ends_with(headerCheck))
  {
    return std::nullopt;
  }
  return header.substr(text.size(), headerCheckDigits) == checkDigits(crc32c(text.data(), text.size()));
}

RecordingHeader refused(std::string problem)
{
  return { std::move(problem), "", 0 };
}

RecordingHeader damaged(std::size_t size)
{
  return refused(
    "is damaged: its header, bytes 0 to " + std::to_string(size - 1) + ", is not as it was written" + otherCopy);
}

} // namespace

RecordingHeader readRecordingHeader(const std::vector<char>& bytes)
{
  constexpr std::size_t longest = 4096;
  const std::string text(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), longest)));
  if (!text.starts_with(recordingMagic))
  {
    return refused("is not a recording of Palpate, or its first bytes are damaged");
  }
  const std::size_t end = text.find(headerEnd);
  const std::size_t size = end == std::string::npos ? 0 : end + headerEnd.size();
  const std::optional<bool> right = checkOf(std::string_view(text).substr(0, size));
  if (right && !*right)
  {
    return damaged(size); // even the number of its format may be another than was written
  }
  const std::string version = text.substr(recordingMagic.size(), text.find('\n') - recordingMagic.size());
  if (version != std::to_string(Recording::formatVersion))
  {
    return refused("is a recording of format " + version.substr(0, 16) + ", this program reads format " +
                   std::to_string(Recording::formatVersion) + ": record it again");
  }
  if (size == 0)
  {
    return refused("is cut short or damaged: its header does not end");
  }
  return right ? RecordingHeader{ "", deviceIn(text.substr(0, end + 1)), size } : damaged(size);
}

} // namespace palpate
