// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/Table.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace palpate::lab
{
namespace
{

std::string number(double value)
{
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return { text, end.ptr };
}

std::string number(const std::optional<double>& value)
{
  return value ? number(*value) : std::string();
}

std::string quoted(const std::string& text)
{
  if (text.find_first_of(",\"\n") == std::string::npos)
  {
    return text;
  }
  std::string field = "\"";
  for (const char c : text)
  {
    field += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return field + '"';
}

} // namespace

const char* name(Verdict verdict)
{
  switch (verdict)
  {
    case Verdict::Pass:
      return "pass";
    case Verdict::Fail:
      return "fail";
    case Verdict::Info:
      return "info";
    case Verdict::Absent:
      return "absent";
  }
  return "unknown";
}

std::string caseName(std::initializer_list<std::pair<const char*, double>> pairs)
{
  std::string text;
  for (const auto& [key, value] : pairs)
  {
    text += (text.empty() ? "" : " ") + std::string(key) + "=" + number(value);
  }
  return text;
}

Table::Table(std::string experiment) : experiment_(std::move(experiment)) {}

Row& Table::add(Row row)
{
  for (const std::optional<double>& number : { row.value, row.truth, row.passLine })
  {
    if (number && !std::isfinite(*number))
    {
      throw std::domain_error(this->experiment_ + ": " + row.subject.quantity + " of " + row.subject.method +
                              " in case " + row.subject.caseName + " is not a finite number");
    }
  }
  this->rows_.push_back(std::move(row));
  return this->rows_.back();
}

Row& Table::within(Subject subject, double value, double truth, double tolerance)
{
  const Verdict verdict = std::abs(value - truth) <= tolerance ? Verdict::Pass : Verdict::Fail;
  return this->add({ std::move(subject), value, truth, tolerance, verdict, {} });
}

Row& Table::atMost(Subject subject, double value, double limit)
{
  const Verdict verdict = value <= limit ? Verdict::Pass : Verdict::Fail;
  return this->add({ std::move(subject), value, 0.0, limit, verdict, {} });
}

Row& Table::atLeast(Subject subject, double value, double limit)
{
  const Verdict verdict = value >= limit ? Verdict::Pass : Verdict::Fail;
  subject.quantity += ", at least";
  return this->add({ std::move(subject), value, {}, limit, verdict, {} });
}

Row& Table::info(Subject subject, double value)
{
  return this->add({ std::move(subject), value, {}, {}, Verdict::Info, {} });
}

Row& Table::absent(Subject subject)
{
  return this->add({ std::move(subject), {}, {}, {}, Verdict::Absent, {} });
}

std::string toCsv(const Table& table)
{
  std::string csv = std::string(csvHeader) + "\n";
  for (const Row& row : table.rows())
  {
    for (const std::string& field :
      { table.experiment(), row.subject.caseName, row.subject.method, row.subject.quantity, number(row.value),
        row.subject.unit, number(row.truth), number(row.passLine), std::string(name(row.verdict)) })
    {
      csv += quoted(field) + ",";
    }
    csv += row.cost ? number(row.cost->p50_us) + "," + number(row.cost->p99_us) + "," + number(row.cost->most_us)
                    : std::string(",,");
    csv += "\n";
  }
  return csv;
}

} // namespace palpate::lab
