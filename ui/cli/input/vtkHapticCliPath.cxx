// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliPath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

#include "haptics/core/Text.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticFileGuards.h"

namespace
{
enum Column : std::size_t
{
  T,
  X,
  Y,
  Z,
  QW,
  QX,
  QY,
  QZ,
  ColumnCount,
};
constexpr std::array<std::string_view, ColumnCount> Names = { "t", "x", "y", "z", "qw", "qx", "qy", "qz" };

using Row = std::array<double, ColumnCount>;

/// Where in the file something is wrong.
struct Place
{
  const std::string& File;
  std::size_t Line = 0;

  [[nodiscard]] vtkHapticCliProblem Problem(const std::string& what) const
  {
    return vtkHapticCliProblem(this->File + ": line " + std::to_string(this->Line) + ": " + what);
  }
};

std::vector<std::string_view> Fields(std::string_view line)
{
  std::vector<std::string_view> fields;
  while (line.find(',') != std::string_view::npos)
  {
    fields.push_back(palpate::trimmed(palpate::takeUntil(line, ',')));
  }
  fields.push_back(palpate::trimmed(line));
  return fields;
}

void CheckComplete(const std::vector<Column>& columns, const Place& place)
{
  const auto missing = [&columns](Column column)
  { return std::find(columns.begin(), columns.end(), column) == columns.end(); };
  const bool oriented = !missing(QW) || !missing(QX) || !missing(QY) || !missing(QZ);
  for (std::size_t column = T; column < (oriented ? ColumnCount : QW); ++column)
  {
    if (missing(static_cast<Column>(column)))
    {
      throw place.Problem("the column '" + std::string(Names[column]) + "' is missing; the header is t,x,y,z or " +
                          "t,x,y,z,qw,qx,qy,qz");
    }
  }
}

std::vector<Column> ParseHeader(std::string_view line, const Place& place)
{
  std::vector<Column> columns;
  for (const std::string_view field : Fields(line))
  {
    const auto* name = std::find(Names.begin(), Names.end(), field);
    if (name == Names.end())
    {
      throw place.Problem("the column '" + std::string(field.substr(0, 24)) +
                          "' is unknown; valid columns are t,x,y,z " + "and qw,qx,qy,qz");
    }
    const auto column = static_cast<Column>(name - Names.begin());
    if (std::find(columns.begin(), columns.end(), column) != columns.end())
    {
      throw place.Problem("the column '" + std::string(field) + "' appears twice");
    }
    columns.push_back(column);
  }
  CheckComplete(columns, place);
  return columns;
}

double ParseNumber(std::string_view field, Column column, const Place& place)
{
  const std::optional<double> value = palpate::signedNumberIn<double>(field);
  if (!value || !std::isfinite(*value))
  {
    throw place.Problem(
      std::string(Names[column]) + " is '" + std::string(field.substr(0, 24)) + "', which is not a finite number");
  }
  return *value;
}

Row ParseRow(std::string_view line, const std::vector<Column>& columns, const Place& place)
{
  const std::vector<std::string_view> fields = Fields(line);
  if (fields.size() != columns.size())
  {
    throw place.Problem("it has " + std::to_string(fields.size()) + " values; the header names " +
                        std::to_string(columns.size()) + " columns");
  }
  Row row{};
  row[QW] = 1.0;
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    row[columns[i]] = ParseNumber(fields[i], columns[i], place);
  }
  return row;
}

palpate::PathSample ToPathRow(const Row& row, const Place& place)
{
  constexpr double tolerance = 1e-3; // rounding in a file with few digits
  const palpate::Quat q(row[QW], row[QX], row[QY], row[QZ]);
  if (std::abs(q.norm() - 1.0) > tolerance)
  {
    throw place.Problem("qw,qx,qy,qz is not a unit quaternion");
  }
  palpate::PathSample result;
  result.time_s = row[T];
  result.hand_W.p = palpate::Vec3(row[X], row[Y], row[Z]);
  result.hand_W.q = q.normalized();
  return result;
}

/// Only the end of a file may have blank lines: in the middle one would be a tick that is not there.
void CheckRestIsBlank(std::ifstream& file, const Place& place)
{
  std::string line;
  while (std::getline(file, line))
  {
    if (!palpate::trimmed(line).empty())
    {
      throw place.Problem("the row is empty although more rows follow");
    }
  }
}

std::vector<palpate::PathSample> ReadRows(std::ifstream& file, const std::vector<Column>& columns, Place& place)
{
  std::vector<palpate::PathSample> rows;
  std::string line;
  while (std::getline(file, line))
  {
    ++place.Line;
    if (palpate::trimmed(line).empty())
    {
      CheckRestIsBlank(file, place);
      break;
    }
    rows.push_back(ToPathRow(ParseRow(line, columns, place), place));
    if (rows.size() > 1 && !(rows.back().time_s > rows[rows.size() - 2].time_s))
    {
      throw place.Problem("t does not increase; each row must be later than the row before");
    }
  }
  return rows;
}
} // namespace

std::vector<palpate::PathSample> vtkHapticCliReadPath(const std::string& name, bool turned)
{
  if (const std::string problem = vtkHapticFileGuards::CheckFile(name); !problem.empty())
  {
    throw vtkHapticCliProblem(name + ": " + problem);
  }
  std::ifstream file(name);
  Place place{ name, 1 };
  std::string line;
  std::getline(file, line);
  const std::vector<Column> columns = ParseHeader(line, place);
  if (turned && std::find(columns.begin(), columns.end(), QW) == columns.end())
  {
    throw place.Problem("a tool needs its rotation: add the columns qw,qx,qy,qz, a unit quaternion");
  }
  std::vector<palpate::PathSample> rows = ReadRows(file, columns, place);
  if (rows.empty())
  {
    throw vtkHapticCliProblem(name + ": the file has a header but no rows; give at least one row");
  }
  return rows;
}

void vtkHapticCliCheckPlanePath(const std::string& file, const std::vector<palpate::PathSample>& path)
{
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    if (path[i].hand_W.p.z() != 0.0)
    {
      std::ostringstream text;
      text << file << ": row " << i + 1 << " has z = " << path[i].hand_W.p.z()
           << "; the hand must be in the plane z = 0";
      throw vtkHapticCliProblem(text.str());
    }
  }
}
