// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "testing/support/CostSample.h"
#include "testing/support/LeastCosts.h"

namespace palpate::lab
{

enum class Verdict
{
  Pass,
  Fail,
  Info,   ///< a figure without a known truth or limit
  Absent, ///< an optional library is not there
};

[[nodiscard]] const char* name(Verdict verdict);

/// Cost of a tick of a method [us]. A maximum is given only where each tick was timed in several runs: of a single run
/// the longest tick is mostly the machine's.
struct Cost
{
  double p50_us = 0.0;
  double p99_us = 0.0;
  std::optional<double> most_us = {};

  [[nodiscard]] static Cost of(const test::CostSample& sample)
  {
    return { sample.quantile_us(0.5), sample.quantile_us(0.99) };
  }
  [[nodiscard]] static Cost of(const test::LeastCosts& least)
  {
    return { least.quantile_us(0.5), least.quantile_us(0.99), least.quantile_us(1.0) };
  }
};

/// A case of the experiment, the method that was tried on it, and the measured quantity.
struct Subject
{
  std::string caseName;
  std::string method;
  std::string quantity;
  std::string unit = {}; ///< empty: a pure number
};

/// A case as pairs the charts can read: "rate=1000 delay=2".
[[nodiscard]] std::string caseName(std::initializer_list<std::pair<const char*, double>> pairs);

/// One line of an experiment's CSV. Without a value: absent.
struct Row
{
  Subject subject;
  std::optional<double> value;
  std::optional<double> truth;
  std::optional<double> passLine;
  Verdict verdict = Verdict::Info;
  std::optional<Cost> cost;
};

/// The verdicts of one experiment. A value that is not finite is an error of the experiment and throws
/// std::domain_error: an unstable simulation is a result and has a number of its own (see Outcome).
class Table
{
public:
  explicit Table(std::string experiment);

  /// Passes where |value - truth| <= tolerance; the pass line is the tolerance.
  Row& within(Subject subject, double value, double truth, double tolerance);
  /// Passes where value <= limit; the ideal is 0.
  Row& atMost(Subject subject, double value, double limit);
  /// Passes where value >= limit; for methods that must be seen to fail. The quantity is marked "at least".
  Row& atLeast(Subject subject, double value, double limit);
  Row& info(Subject subject, double value);
  Row& absent(Subject subject);

  [[nodiscard]] const std::string& experiment() const { return this->experiment_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return this->rows_; }

private:
  Row& add(Row row);

  std::string experiment_;
  std::vector<Row> rows_;
};

/// How contact ended, as a number a chart can name. Unit of such a row: outcomeUnit.
enum class Outcome
{
  Held = 0,     ///< as it should be
  Through = 1,  ///< passed a surface
  Stuck = 2,    ///< stayed where nothing holds it
  Unstable = 3, ///< left every bound
  Wrong = 4,    ///< neither of these, but the force is not the true one
};

inline constexpr const char* outcomeUnit = "0 held, 1 through, 2 stuck, 3 unstable, 4 wrong";

/// The header of every CSV of the lab, in one place.
inline constexpr const char* csvHeader =
  "experiment,case,method,quantity,value,unit,truth,pass_line,verdict,cost_us_p50,cost_us_p99,cost_us_most";

/// The table as CSV: numbers with as many digits as bring them back exactly, fields with commas quoted.
[[nodiscard]] std::string toCsv(const Table& table);

} // namespace palpate::lab
