// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "testing/lab/Table.h"

namespace palpate::lab
{

/// How much an experiment may take: a share of a minute, of a few minutes, or of a night.
enum class Size
{
  Quick,
  Default,
  Soak,
};

/// In so many runs each tick of a chart of speed against accuracy is timed; the least of them counts.
inline constexpr int costRuns = 3;

/// Size, seed and listener of a run. Same size and seed: same values, cost columns aside.
struct Conditions
{
  Size size = Size::Default;
  std::uint64_t seed = 1;
  std::function<void(double share)> progress; ///< may be called as often as one likes, 0..1

  template<class T>
  [[nodiscard]] T pick(T quick, T usual, T soak) const
  {
    return this->size == Size::Quick ? quick : this->size == Size::Default ? usual : soak;
  }
};

/// An experiment: simulated, in virtual time, judged by a truth that is not ours (a formula or an exact oracle).
struct Experiment
{
  std::string name;
  std::string shows;     ///< one sentence for a person
  std::vector<int> rows; ///< of testing/BAR.md
  void (*run)(const Conditions&, Table&) = nullptr;
};

/// All experiments in the order of a report.
[[nodiscard]] std::vector<Experiment> experiments();

} // namespace palpate::lab
