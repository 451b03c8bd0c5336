// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "testing/lab/Experiment.h"

namespace palpate::lab
{

/// The experiments with these names ("all": every one), in the order of the list. Throws std::invalid_argument that
/// names the nearest ones for a name that is not known.
[[nodiscard]] std::vector<Experiment> choose(const std::vector<std::string>& names);

/// How many verdicts of a run passed, and the failures.
struct Score
{
  int passed = 0;
  int judged = 0;
  int absent = 0;
  std::vector<std::string> failures; ///< "experiment, case, method: quantity ..."
};

/// Runs them one after another, one CSV each in `folder`, which is made; `log` sees progress and failures.
/// Throws std::runtime_error with the file where it cannot be written. An experiment that throws is one failure.
[[nodiscard]] Score run(
  const std::vector<Experiment>& chosen, Conditions conditions, const std::filesystem::path& folder, std::ostream& log);

} // namespace palpate::lab
