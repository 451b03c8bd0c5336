// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliField.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string_view>

#include "haptics/session/settings/SessionSettings.h"
#include "vtkDataSet.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticReaders.h"

namespace
{
using FieldArrayName = std::string vtkHapticFieldArrays::*;

struct Mode
{
  std::string_view Name;
  FieldArrayName Array;                       ///< what of the field it is felt from
  const char* Setting;                        ///< whose range its strength has
  double& (*Strength_N)(palpate::FieldPlan&); ///< that it is at most as strong as
};

constexpr std::array<Mode, 7> Modes = { {
  { "isosurface", &vtkHapticFieldArrays::Scalar, "FieldYield", [](auto& p) -> double& { return p.yield_N; } },
  { "detent", &vtkHapticFieldArrays::Scalar, "FieldDetent", [](auto& p) -> double& { return p.detent.strength_N; } },
  { "snap", &vtkHapticFieldArrays::Scalar, "FieldSnap", [](auto& p) -> double& { return p.snap_N; } },
  { "compare", &vtkHapticFieldArrays::Scalar, "FieldCompare", [](auto& p) -> double& { return p.compare_N; } },
  { "follow", &vtkHapticFieldArrays::Vector, "FieldFollow", [](auto& p) -> double& { return p.follow_N; } },
  { "push", &vtkHapticFieldArrays::Vector, "FieldPush", [](auto& p) -> double& { return p.push_N; } },
  { "drag", &vtkHapticFieldArrays::Resistance, "FieldDrag", [](auto& p) -> double& { return p.drag_N; } },
} };
constexpr std::string_view Isosurface = "isosurface", Compare = "compare", Detent = "detent";

const Mode& ModeOf(const std::string& name)
{
  const auto* const found = std::ranges::find(Modes, std::string_view(name), &Mode::Name);
  if (found == Modes.end())
  {
    throw vtkHapticCliProblem("--mode " + name + ": it is isosurface, detent, snap, compare, follow, push or drag");
  }
  return *found;
}

void CheckCounts(const vtkHapticCliFieldOptions& options)
{
  if (options.Modes.empty() || options.Arrays.empty())
  {
    throw vtkHapticCliProblem("--field and --mode go together: an array, and how it is felt");
  }
  if (options.Arrays.size() != 1 && options.Arrays.size() != options.Modes.size())
  {
    throw vtkHapticCliProblem("--field: give one array for each --mode, in their order, or one for all");
  }
  const bool wall = options.Modes.size() == 1 && options.Modes.front() == Isosurface;
  if (options.Strengths_N.size() != options.Modes.size() && !(wall && options.Strengths_N.empty()))
  {
    throw vtkHapticCliProblem(
      "--strength: give one [N] for each --mode, in their order (an isosurface of 0 is a wall)");
  }
  for (const std::string& mode : options.Modes)
  {
    if (std::ranges::count(options.Modes, mode) > 1)
    {
      throw vtkHapticCliProblem("--mode " + mode + ": it is given more than once; a mode has one strength");
    }
  }
  if (std::ranges::count(options.Modes, Detent) == 0 && !options.Levels.empty())
  {
    throw vtkHapticCliProblem("--levels and --mode detent go together: values, and that they hold the hand");
  }
  if (options.Other.empty() == (std::ranges::count(options.Modes, Compare) > 0))
  {
    throw vtkHapticCliProblem("--compare-with and --mode compare go together: the other array, and that it is felt");
  }
}

double StrengthOf(const vtkHapticCliFieldOptions& options, std::size_t mode)
{
  const double strength_N = options.Strengths_N.empty() ? 0.0 : options.Strengths_N[mode];
  const palpate::Setting& setting = palpate::sessionSetting(ModeOf(options.Modes[mode]).Setting);
  if (const std::string problem = palpate::refuse(setting, { &strength_N, 1 }, "--strength"); !problem.empty())
  {
    throw vtkHapticCliProblem(problem);
  }
  return strength_N;
}

vtkHapticFieldArrays ArraysOf(const vtkHapticCliFieldOptions& options, const vtkHapticCliSettings& settings)
{
  vtkHapticFieldArrays arrays;
  for (std::size_t i = 0; i < options.Modes.size(); ++i)
  {
    const std::string& name = options.Arrays[std::min(i, options.Arrays.size() - 1)];
    std::string& array = arrays.*ModeOf(options.Modes[i]).Array;
    if (!array.empty() && array != name)
    {
      throw vtkHapticCliProblem(
        "--field: \"" + array + "\" and \"" + name + "\" are felt from the same numbers in space; choose one");
    }
    array = name;
  }
  arrays.Other = options.Other;
  arrays.Component = static_cast<int>(settings.Number("FieldComponent"));
  arrays.Smoothing = static_cast<int>(settings.Number("FieldSmoothing"));
  arrays.Eigenvector = static_cast<int>(settings.Number("FieldEigenvector"));
  return arrays;
}

/// What says how a field is felt is refused rather than ignored where none is.
void CheckNoneIsGiven(const vtkHapticCliFieldOptions& options, const vtkHapticCliSettings& settings)
{
  std::string given = !options.Strengths_N.empty() ? "strength"
                      : !options.Other.empty()     ? "compare-with"
                      : !options.Levels.empty()    ? "levels"
                                                   : "";
  for (const palpate::Setting& setting : palpate::sessionSettings())
  {
    const bool field = setting.name.starts_with("Field") && !setting.at.option.empty();
    given = given.empty() && field && settings.IsGiven(setting.name) ? setting.at.option : given;
  }
  if (!given.empty())
  {
    throw vtkHapticCliProblem("--" + given + ": it says how a field is felt; give --field and --mode as well");
  }
}
} // namespace

void vtkHapticCliAddField(CLI::App& command, vtkHapticCliFieldOptions& options)
{
  command
    .add_option(
      "--field", options.Arrays, "array of the first volume (vti, vtr, vts, vtu, nii) felt as a field, for each --mode")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
    .add_option(
      "--mode", options.Modes, "isosurface (at --iso), detent, snap, compare; follow, push (directions); drag")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
    .add_option(
      "--strength", options.Strengths_N, "force at which each --mode gives way [N]; an isosurface of 0 is a wall")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--compare-with", options.Other, "array that --mode compare compares with");
  command.add_option(
    "--levels", options.Levels, "values V,V,... at which --mode detent holds, instead of levels at equal distances");
}

std::shared_ptr<const palpate::FieldSource> vtkHapticCliTakeField(const vtkHapticCliFieldOptions& options,
  const vtkHapticCliSettings& settings, const palpate::FieldPlan& plan, std::vector<std::string>& files)
{
  if (!options.Any())
  {
    return nullptr;
  }
  const auto file = std::ranges::find_if(files, vtkHapticIsVolumeFile);
  if (file == files.end())
  {
    throw vtkHapticCliProblem(
      files.front() + ": it is no volume that --field could be felt of; known are vti, vtr, vts, vtu, nii and nii.gz");
  }
  const std::string name = *file;
  const vtkHapticReadVolumeResult read = vtkHapticReadVolume(name);
  if (!read.Volume)
  {
    throw vtkHapticCliProblem(read.Problem);
  }
  if (!read.Note.empty())
  {
    std::cerr << "palpate: " << name << ": " << read.Note << '\n';
  }
  const vtkHapticFieldResult field = vtkHapticToField(read.Volume, ArraysOf(options, settings));
  const std::string problem = field.Source ? palpate::levelProblem(plan, field.Ends) : field.Problem;
  if (!problem.empty())
  {
    throw vtkHapticCliProblem(name + ": " + problem);
  }
  if (const std::string missing = palpate::levelSentence(plan, field.Ends); !missing.empty())
  {
    std::cerr << "palpate: " << name << ": " << missing << '\n';
  }
  files.erase(file);
  return field.Source;
}

void vtkHapticCliSetField(const vtkHapticCliFieldOptions& options, const vtkHapticCliSettings& settings,
  std::optional<double> iso, palpate::FieldPlan& plan)
{
  if (!options.Any())
  {
    CheckNoneIsGiven(options, settings);
    return;
  }
  CheckCounts(options);
  for (std::size_t i = 0; i < options.Modes.size(); ++i)
  {
    ModeOf(options.Modes[i]).Strength_N(plan) = StrengthOf(options, i);
  }
  plan.isosurface = std::ranges::count(options.Modes, Isosurface) > 0;
  if (plan.isosurface && !(iso && std::isfinite(*iso)))
  {
    throw vtkHapticCliProblem("--mode isosurface: give the value of the surface with --iso");
  }
  plan.isovalue = iso.value_or(0.0);
  if (const std::string problem = palpate::setLevels(plan.detent, options.Levels); !problem.empty())
  {
    throw vtkHapticCliProblem("--" + problem);
  }
}
