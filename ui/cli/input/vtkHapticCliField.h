// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliField_h
#define vtkHapticCliField_h

#include <optional>
#include <string>
#include <vector>

#include "vtkHapticCliSettings.h"

class vtkTouchAlongPath;

/// Numbers in space as a command line has them: a mode, its array and its strength in the same place of each list.
struct vtkHapticCliFieldOptions
{
  std::vector<std::string> Arrays; ///< one a mode, or one for all
  std::vector<std::string> Modes;
  std::vector<double> Strengths_N;   ///< one a mode; an isosurface alone needs none: then it is a wall
  std::string OtherFile;             ///< volume that the scalar is compared with; empty: the same
  std::vector<double> Range;         ///< values at which drag, follow and push begin and are full; empty: settings
  std::string Snap;                  ///< snap targets of the surfaces: "points" or "lines"; empty: none
  std::vector<std::string> Surfaces; ///< files beside the field: touched, or snapped to

  bool Any() const { return !this->Arrays.empty() || !this->Modes.empty(); }
};

/// --field, --mode, --strength and the other options that say how a field is felt, and --surface of a command.
void vtkHapticCliAddField(CLI::App& command, vtkHapticCliFieldOptions& options);

/// The option that says how a field is felt and was given, with its dashes; empty: there is none.
[[nodiscard]] std::string vtkHapticCliGivenOfField(const vtkHapticCliFieldOptions& options);

/// Sets the modes of the filter. `iso`: the value of an isosurface. Throws vtkHapticCliProblem, also for settings of a
/// field where none is asked for.
void vtkHapticCliSetField(const vtkHapticCliFieldOptions& options, const vtkHapticCliSettings& settings,
  std::optional<double> iso, palpate::SettingStore& felt, vtkTouchAlongPath& filter);

/// Takes the file that is felt as a field, the first volume among them, out of `files` and gives it to the filter, with
/// the data to compare with and the snap targets; as port 0 where nothing else is touched. Without --range settings get
/// that of the arrays. Throws vtkHapticCliProblem.
void vtkHapticCliTakeField(const vtkHapticCliFieldOptions& options, const vtkHapticCliSettings& settings,
  palpate::SettingStore& felt, std::vector<std::string>& files, vtkTouchAlongPath& filter);

#endif
