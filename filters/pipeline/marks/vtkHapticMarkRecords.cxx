// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMarkRecords.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkHapticTextRows.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkXMLPolyDataWriter.h"

namespace
{
constexpr const char* SourceColumn = "Source";
constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> ReadHeader(vtkHapticTextRows& rows)
{
  std::vector<std::string> names = rows.Next();
  const std::vector<std::string> first = { SourceColumn, "X", "Y", "Z" };
  if (names.size() < first.size() || !std::equal(first.begin(), first.end(), names.begin()))
  {
    throw std::runtime_error("the first columns must be Source, X, Y and Z");
  }
  return names;
}

vtkHapticMarkRecord ReadRecord(const std::vector<std::string>& names, const std::vector<std::string>& row)
{
  if (row.size() != names.size())
  {
    throw std::runtime_error(
      "it has " + std::to_string(row.size()) + " fields for " + std::to_string(names.size()) + " columns");
  }
  vtkHapticMarkRecord record{ row.front(), {} };
  for (std::size_t i = 1; i < row.size(); ++i)
  {
    if (names[i] == vtkHapticMarkRecords::NameColumn)
    {
      record.Name = row[i];
    }
    else
    {
      record.Numbers.emplace_back(names[i], vtkHapticTextRows::Number(row[i]));
    }
  }
  return record;
}

std::string WritePoints(const vtkHapticMarkRecords& marks, const std::string& path)
{
  vtkNew<vtkPolyData> points;
  marks.FillPoints(points);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(points);
  return writer->Write() == 1 ? "" : "could not be written; is the disk full or the folder read-only?";
}

std::string WriteText(const vtkHapticMarkRecords& marks, const std::string& path)
{
  std::ofstream file(path, std::ios::binary);
  file << marks.ToText();
  file.close();
  return file ? "" : "could not be written; is the disk full or the folder read-only?";
}
} // namespace

double vtkHapticMarkRecord::Number(std::string_view name) const
{
  const auto found =
    std::find_if(this->Numbers.begin(), this->Numbers.end(), [name](const auto& each) { return each.first == name; });
  return found != this->Numbers.end() ? found->second : NotKnown;
}

std::vector<std::string> vtkHapticMarkRecords::Columns() const
{
  std::vector<std::string> columns;
  for (const vtkHapticMarkRecord& record : this->Records)
  {
    for (const auto& [name, value] : record.Numbers)
    {
      if (std::find(columns.begin(), columns.end(), name) == columns.end())
      {
        columns.push_back(name);
      }
    }
  }
  return columns;
}

void vtkHapticMarkRecords::FillTable(vtkTable* table) const
{
  table->Initialize();
  vtkNew<vtkStringArray> sources;
  sources->SetName(SourceColumn);
  for (const vtkHapticMarkRecord& record : this->Records)
  {
    sources->InsertNextValue(record.Source);
  }
  table->AddColumn(sources);
  vtkNew<vtkStringArray> given;
  given->SetName(NameColumn);
  for (const vtkHapticMarkRecord& record : this->Records)
  {
    given->InsertNextValue(record.Name);
  }
  for (const std::string& name : this->Columns())
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name.c_str());
    for (const vtkHapticMarkRecord& record : this->Records)
    {
      column->InsertNextValue(record.Number(name));
    }
    table->AddColumn(column);
  }
  table->AddColumn(given);
}

void vtkHapticMarkRecords::FillPoints(vtkPolyData* points) const
{
  points->Initialize();
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (const vtkHapticMarkRecord& record : this->Records)
  {
    const vtkIdType id = places->InsertNextPoint(record.Number("X"), record.Number("Y"), record.Number("Z"));
    vertices->InsertNextCell(1, &id);
  }
  points->SetPoints(places);
  points->SetVerts(vertices);
  vtkNew<vtkTable> table;
  this->FillTable(table);
  for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
  {
    points->GetPointData()->AddArray(table->GetColumn(column));
  }
}

std::string vtkHapticMarkRecords::ToText() const
{
  if (this->Records.empty())
  {
    return {};
  }
  const std::vector<std::string> columns = this->Columns();
  const bool named = std::any_of(
    this->Records.begin(), this->Records.end(), [](const vtkHapticMarkRecord& record) { return !record.Name.empty(); });
  const auto row = [&](const std::string& source, const std::string& given, const auto& field)
  {
    std::string text = vtkHapticTextRows::Quoted(source);
    for (const std::string& name : columns)
    {
      text += ',' + field(name) + (named && name == "Z" ? ',' + vtkHapticTextRows::Quoted(given) : "");
    }
    return text + '\n';
  };
  std::string text =
    row(SourceColumn, NameColumn, [](const std::string& name) { return vtkHapticTextRows::Quoted(name); });
  for (const vtkHapticMarkRecord& record : this->Records)
  {
    text += row(record.Source, record.Name,
      [&record](const std::string& name) { return vtkHapticTextRows::Digits(record.Number(name)); });
  }
  return text;
}

std::string vtkHapticMarkRecords::FromText(std::string_view text)
{
  this->Records.clear();
  if (text.empty())
  {
    return {};
  }
  std::vector<vtkHapticMarkRecord> records;
  try
  {
    vtkHapticTextRows rows(text);
    const std::vector<std::string> names = ReadHeader(rows);
    while (!rows.AtEnd())
    {
      records.push_back(ReadRecord(names, rows.Next()));
    }
  }
  catch (const std::runtime_error& error)
  {
    return "mark " + std::to_string(records.size() + 1) + " of the list cannot be read: " + error.what();
  }
  this->Records = std::move(records);
  return {};
}

std::string vtkHapticMarkRecords::Read(const std::string& path)
{
  this->Records.clear();
  std::ifstream file(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file || text.empty())
  {
    return path + ": no marks could be read; choose a file that was written by Save Marks as csv";
  }
  const std::string problem = this->FromText(text);
  return problem.empty() ? "" : path + ": " + problem;
}

std::string vtkHapticMarkRecords::Write(const std::string& path) const
{
  const bool points = path.ends_with(".vtp");
  if (this->Records.empty() || (!points && !path.ends_with(".csv")))
  {
    return path + (this->Records.empty() ? ": there are no marks to write; set a mark first"
                                         : ": marks are written as csv or vtp; use one of these suffixes");
  }
  const std::string whole = path + ".part";
  std::string problem = points ? WritePoints(*this, whole) : WriteText(*this, whole);
  if (problem.empty())
  {
    std::error_code error;
    std::filesystem::rename(whole, path, error);
    problem = error ? "could not be written: " + error.message() : "";
  }
  if (!problem.empty())
  {
    std::error_code ignored;
    std::filesystem::remove(whole, ignored);
  }
  return problem.empty() ? "" : path + ": " + problem;
}
