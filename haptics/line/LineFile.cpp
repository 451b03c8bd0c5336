// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/line/LineFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "haptics/core/Text.h"

namespace palpate
{
namespace
{

constexpr std::size_t mostPlaces = 1000000;
constexpr std::array<std::string_view, 3> names{ "s", "value", "friction" };
constexpr std::size_t absent = names.size();

/// For each column the number of its name; empty: the header is none.
std::vector<std::size_t> columnsOf(std::string_view header)
{
  std::vector<std::size_t> columns;
  while (!header.empty())
  {
    const std::string_view name = trimmed(takeUntil(header, ','));
    const auto known = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    if (known == absent || std::count(columns.begin(), columns.end(), known) > 0)
    {
      return {};
    }
    columns.push_back(known);
  }
  const auto has = [&](std::size_t name) { return std::count(columns.begin(), columns.end(), name) > 0; };
  return has(0) && has(1) ? columns : std::vector<std::size_t>();
}

/// False: it is not a row of that many finite numbers.
bool readRow(std::string_view line, const std::vector<std::size_t>& columns, LinePlace& place)
{
  std::array<double, names.size()> values{};
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    const bool last = i + 1 == columns.size();
    if (last == (line.find(',') != std::string_view::npos))
    {
      return false;
    }
    const std::optional<double> value = numberIn<double>(trimmed(takeUntil(line, ',')));
    if (!value || !std::isfinite(*value))
    {
      return false;
    }
    values[columns[i]] = *value;
  }
  place = { values[0], values[1], values[2] };
  return true;
}

} // namespace

Outcome<std::vector<LinePlace>> parseLine(std::string_view text)
{
  Outcome<std::vector<LinePlace>> parsed;
  const std::vector<std::size_t> columns = columnsOf(takeUntil(text, '\n'));
  if (columns.empty())
  {
    return { {}, "line 1: the header must have s and value, and may have friction" };
  }
  for (std::size_t number = 2; !text.empty(); ++number)
  {
    const std::string_view line = trimmed(takeUntil(text, '\n'));
    const std::string where = "line " + std::to_string(number) + ": ";
    LinePlace place;
    if (!readRow(line, columns, place))
    {
      return { {}, where + "expected one finite number per column" };
    }
    if (!parsed.value.empty() && !(place.s_m > parsed.value.back().s_m))
    {
      return { {}, where + "s must grow from line to line" };
    }
    if (parsed.value.size() == mostPlaces)
    {
      return { {}, where + "more than 1000000 positions cannot be distinguished by a hand" };
    }
    parsed.value.push_back(place);
  }
  return parsed.value.size() < 2 ? Outcome<std::vector<LinePlace>>{ {}, "a line needs at least two positions" } : parsed;
}

void scaleToHardest(std::vector<LinePlace>& places, double hardest_N) noexcept
{
  double steepest = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i)
  {
    const LinePlace &a = places[i - 1], &b = places[i];
    steepest = std::max(steepest, std::fabs(b.potential_J - a.potential_J) / (b.s_m - a.s_m));
  }
  const double scale = steepest > 0.0 ? hardest_N / steepest : 0.0;
  for (LinePlace& place : places)
  {
    place.potential_J *= scale;
  }
}

} // namespace palpate
