// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace palpate
{

/// The words of a text that is not trusted.

/// The whole word as a number; none where it is something else or overflows. NaN and infinity are numbers.
template<class T>
[[nodiscard]] std::optional<T> numberIn(std::string_view word)
{
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
}

/// The same, with a plus before it or without.
template<class T>
[[nodiscard]] std::optional<T> signedNumberIn(std::string_view word)
{
  word.remove_prefix(word.size() > 1 && word.front() == '+' && word[1] != '-' ? 1 : 0);
  return numberIn<T>(word);
}

/// Without the blanks around it.
[[nodiscard]] inline std::string_view trimmed(std::string_view text)
{
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The text before the separator; the separator is removed too.
[[nodiscard]] inline std::string_view takeUntil(std::string_view& text, char separator)
{
  const std::size_t end = text.find(separator);
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return part;
}

/// The texts between separators. Behind the last one nothing needs to stand.
[[nodiscard]] inline std::vector<std::string> partsOf(std::string_view text, char separator)
{
  std::vector<std::string> parts;
  while (!text.empty())
  {
    parts.emplace_back(takeUntil(text, separator));
  }
  return parts;
}

} // namespace palpate
