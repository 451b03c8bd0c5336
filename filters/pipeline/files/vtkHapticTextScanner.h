// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticTextScanner_h
#define vtkHapticTextScanner_h

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "haptics/core/Text.h"

/// The words and lines of an untrusted text. Functions throw std::runtime_error with a sentence for a person.
namespace vtkHapticText
{
inline constexpr std::string_view Blanks = " \t\r\v\f";

[[nodiscard]] inline bool IsBlank(std::string_view line)
{
  return line.find_first_not_of(Blanks) == std::string_view::npos;
}

/// Takes the first word off `rest`; empty when there is none.
[[nodiscard]] inline std::string_view TakeWord(std::string_view& rest)
{
  rest.remove_prefix(std::min(rest.find_first_not_of(Blanks), rest.size()));
  const std::size_t length = std::min(rest.find_first_of(Blanks), rest.size());
  const std::string_view word = rest.substr(0, length);
  rest.remove_prefix(length);
  return word;
}

/// A file may hold anything: a message shows at most a short, printable piece of it.
[[nodiscard]] inline std::string Quoted(std::string_view word)
{
  std::string shown(word.substr(0, 24));
  std::replace_if(
    shown.begin(), shown.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return "'" + shown + "'";
}

template<class T>
[[nodiscard]] T ParseOrThrow(std::string_view word, const char* where)
{
  if (word.empty())
  {
    throw std::runtime_error(std::string("a number is missing in ") + where);
  }
  const std::optional<T> value = palpate::signedNumberIn<T>(word);
  if (!value)
  {
    throw std::runtime_error(
      Quoted(word) + " in " + where + " is not a " + (std::is_integral_v<T> ? "whole " : "") + "number");
  }
  return *value;
}

template<class T>
[[nodiscard]] T TakeNumber(std::string_view& rest, const char* where)
{
  return ParseOrThrow<T>(TakeWord(rest), where);
}

/// Colours and the like: whatever stands behind a record has to be numbers.
inline void SkipNumbers(std::string_view line, const char* where)
{
  while (!IsBlank(line))
  {
    static_cast<void>(TakeNumber<double>(line, where));
  }
}

/// A line of three coordinates, and maybe a weight or a colour.
inline void ReadPoint(std::string_view line, std::vector<double>& coordinates)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    coordinates.push_back(TakeNumber<double>(line, "a point"));
  }
  SkipNumbers(line, "a point");
}

/// Hands out the lines that say something: comments cut off, blank ones passed over.
class LineReader
{
public:
  explicit LineReader(std::string_view text) : Rest(text) {}

  [[nodiscard]] bool Next(std::string_view& line)
  {
    while (this->NextRaw(line))
    {
      line = line.substr(0, std::min(line.find('#'), line.size()));
      if (!IsBlank(line))
      {
        return true;
      }
    }
    return false;
  }

  /// The next line as it stands, without its line end.
  [[nodiscard]] bool NextRaw(std::string_view& line)
  {
    if (this->Rest.empty())
    {
      return false;
    }
    const std::size_t length = std::min(this->Rest.find('\n'), this->Rest.size());
    line = this->Rest.substr(0, length);
    this->Rest.remove_prefix(std::min(length + 1, this->Rest.size()));
    ++this->Number;
    return true;
  }

  /// The unread rest.
  [[nodiscard]] std::string_view Remaining() const { return this->Rest; }
  /// "line 12: ": where the last line stands.
  [[nodiscard]] std::string Place() const { return "line " + std::to_string(this->Number) + ": "; }

private:
  std::string_view Rest;
  std::size_t Number = 0;
};
} // namespace vtkHapticText

#endif
