// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticTextRows.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "haptics/core/Text.h"

std::vector<std::string> vtkHapticTextRows::Next()
{
  std::vector<std::string> row;
  bool more = true;
  while (more)
  {
    row.push_back(this->NextField());
    more = !this->Rest.empty() && this->Rest.front() == ',';
    this->Rest.remove_prefix(this->Rest.starts_with("\r\n") ? 2 : this->Rest.empty() ? 0 : 1);
  }
  return row;
}

std::string vtkHapticTextRows::NextField()
{
  if (!this->Rest.starts_with('"'))
  {
    const std::size_t length = std::min(this->Rest.find_first_of(",\r\n"), this->Rest.size());
    std::string field(this->Rest.substr(0, length));
    this->Rest.remove_prefix(length);
    return field;
  }
  std::string field;
  std::size_t at = 1;
  while (at < this->Rest.size() && (this->Rest[at] != '"' || this->Rest.substr(at).starts_with("\"\"")))
  {
    field += this->Rest[at];
    at += this->Rest[at] == '"' ? 2 : 1;
  }
  this->Rest.remove_prefix(std::min(at + 1, this->Rest.size()));
  return field;
}

std::string vtkHapticTextRows::Quoted(const std::string& field)
{
  if (field.find_first_of(",\"\r\n") == std::string::npos)
  {
    return field;
  }
  std::string quoted = "\"";
  for (const char c : field)
  {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + '"';
}

std::string vtkHapticTextRows::Digits(double value)
{
  char text[64];
  const auto end = std::to_chars(std::begin(text), std::end(text), value).ptr;
  return { text, end };
}

double vtkHapticTextRows::Number(const std::string& field)
{
  const std::optional<double> value = palpate::numberIn<double>(field);
  if (!value)
  {
    throw std::runtime_error("'" + field.substr(0, 24) + "' is not a number");
  }
  return *value;
}
