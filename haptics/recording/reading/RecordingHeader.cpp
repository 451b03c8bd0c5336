// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/reading/RecordingHeader.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "haptics/core/Checksum.h"
#include "haptics/recording/Recording.h"
#include "haptics/recording/RecordingLayout.h"

namespace palpate
{
namespace
{

/// The number of a format that this program reads; none: another one.
std::optional<int> formatOf(const std::string& version)
{
  for (int format = Recording::oldestFormatVersion; format <= Recording::formatVersion; ++format)
  {
    if (version == std::to_string(format))
    {
      return format;
    }
  }
  return std::nullopt;
}

std::string deviceIn(const std::string& text)
{
  const std::string field = "\ndevice: ";
  const std::size_t at = text.find(field);
  return at == std::string::npos ? "" : text.substr(at + field.size(), text.find('\n', at + 1) - at - field.size());
}

enum class HeaderCheck
{
  None, ///< it has no checksum
  Right,
  Wrong,
};

/// A line that is not there is no line that is wrong: older formats have none.
HeaderCheck checkOf(std::string_view header)
{
  const std::size_t last = headerCheckDigits + headerEnd.size();
  if (header.size() < headerCheck.size() + last)
  {
    return HeaderCheck::None;
  }
  const std::string_view text = header.substr(0, header.size() - last);
  const bool right = header.substr(text.size(), headerCheckDigits) == checkDigits(crc32c(text.data(), text.size()));
  return !text.ends_with(headerCheck) ? HeaderCheck::None : right ? HeaderCheck::Right : HeaderCheck::Wrong;
}

RecordingHeader refused(std::string problem)
{
  return { std::move(problem), 0, "", 0 };
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
  const HeaderCheck check = checkOf(std::string_view(text).substr(0, size));
  if (check == HeaderCheck::Wrong)
  {
    return damaged(size); // even the number of its format may be another than was written
  }
  const std::string version = text.substr(recordingMagic.size(), text.find('\n') - recordingMagic.size());
  const std::optional<int> format = formatOf(version);
  if (!format)
  {
    return refused("is a recording of format " + version.substr(0, 16) + ", this program reads format " +
                   std::to_string(Recording::formatVersion) + " and back to " +
                   std::to_string(Recording::oldestFormatVersion) + ": record it again");
  }
  if (size == 0)
  {
    return refused("is cut short or damaged: its header does not end");
  }
  if (check == HeaderCheck::None && *format >= Recording::checkedFormatVersion)
  {
    return damaged(size);
  }
  return { "", *format, deviceIn(text.substr(0, end + 1)), size };
}

} // namespace palpate
