// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/Runner.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <numeric>
#include <ostream>
#include <stdexcept>

namespace palpate::lab
{
namespace
{

/// Levenshtein's distance.
std::size_t editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{ 0 });
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ row[j + 1] + 1, row[j] + 1, changed });
    }
  }
  return row.back();
}

std::string nearNames(const std::string& wrong, const std::vector<Experiment>& all)
{
  std::vector<std::string> names;
  for (const Experiment& e : all)
  {
    names.push_back(e.name);
  }
  const auto distance = [&wrong](const std::string& name)
  { return name.find(wrong) != std::string::npos ? 0 : editDistance(wrong, name); };
  std::stable_sort(names.begin(), names.end(),
    [&distance](const std::string& a, const std::string& b) { return distance(a) < distance(b); });
  names.resize(std::min<std::size_t>(names.size(), 3));
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

/// Says how far an experiment is, at most once in two seconds.
class ProgressLine
{
public:
  ProgressLine(std::string name, std::ostream& log) : name_(std::move(name)), log_(log) {}

  void operator()(double share)
  {
    const auto now = std::chrono::steady_clock::now();
    if (now - this->last_ >= std::chrono::seconds(2))
    {
      this->last_ = now;
      this->log_ << this->name_ << ": " << static_cast<int>(100.0 * share) << " %" << std::endl;
    }
  }

  [[nodiscard]] double elapsed_s() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->begin_).count();
  }

private:
  std::string name_;
  std::ostream& log_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_ = begin_;
};

void write(const std::filesystem::path& file, const std::string& text)
{
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out)
  {
    throw std::runtime_error(file.string() + " cannot be written: give a folder that is writable with --out");
  }
}

std::string describe(const Table& table, const Row& row)
{
  std::string text = table.experiment() + ", " + row.subject.caseName + ", " + row.subject.method + ": " +
                     row.subject.quantity + " is " + std::to_string(row.value.value_or(0.0)) + " " + row.subject.unit;
  if (row.truth)
  {
    text += ", should be " + std::to_string(*row.truth);
  }
  return row.passLine ? text + ", limit " + std::to_string(*row.passLine) : text;
}

void count(const Table& table, Score& score)
{
  for (const Row& row : table.rows())
  {
    score.passed += row.verdict == Verdict::Pass;
    score.judged += row.verdict == Verdict::Pass || row.verdict == Verdict::Fail;
    score.absent += row.verdict == Verdict::Absent;
    if (row.verdict == Verdict::Fail)
    {
      score.failures.push_back(describe(table, row));
    }
  }
}

} // namespace

std::vector<Experiment> choose(const std::vector<std::string>& names)
{
  const std::vector<Experiment> all = experiments();
  if (std::find(names.begin(), names.end(), "all") != names.end())
  {
    return all;
  }
  for (const std::string& name : names)
  {
    if (std::none_of(all.begin(), all.end(), [&name](const Experiment& e) { return e.name == name; }))
    {
      throw std::invalid_argument(
        "no experiment is called '" + name + "'; near it: " + nearNames(name, all) + " (palpate-lab list shows all)");
    }
  }
  std::vector<Experiment> chosen;
  for (const Experiment& e : all)
  {
    if (std::find(names.begin(), names.end(), e.name) != names.end())
    {
      chosen.push_back(e);
    }
  }
  return chosen;
}

Score run(
  const std::vector<Experiment>& chosen, Conditions conditions, const std::filesystem::path& folder, std::ostream& log)
{
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem)
  {
    throw std::runtime_error(folder.string() + " cannot be made: " + problem.message());
  }
  Score score;
  for (const Experiment& experiment : chosen)
  {
    Table table(experiment.name);
    ProgressLine progress(experiment.name, log);
    conditions.progress = std::ref(progress);
    const std::filesystem::path file = folder / (experiment.name + ".csv");
    write(file, toCsv(table)); // before the work: a folder that cannot be written costs no experiment
    try
    {
      experiment.run(conditions, table);
    }
    catch (const std::exception& error)
    {
      score.judged += 1;
      score.failures.push_back(experiment.name + ": stopped: " + error.what());
    }
    write(file, toCsv(table));
    const int passedBefore = score.passed, judgedBefore = score.judged;
    count(table, score);
    log << experiment.name << ": " << score.passed - passedBefore << " of " << score.judged - judgedBefore << " in "
        << static_cast<int>(progress.elapsed_s() + 0.5) << " s" << std::endl;
  }
  return score;
}

} // namespace palpate::lab
