// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliSettings_h
#define vtkHapticCliSettings_h

#include <CLI/CLI.hpp>
#include <deque>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/session/settings/SettingStore.h"

/// Settings of a session as options of a command: option, sentence, unit, range and default are those of the table
/// (haptics/session/settings/), with the default of one who feels along a path.
class vtkHapticCliSettings
{
public:
  /// Every setting that has an option, but for those of a tool, a soft body and a mechanism.
  void AddAll(CLI::App& command);
  /// One of them by its name; `also`: its further meaning for this command.
  CLI::Option& Add(CLI::App& command, const char* setting, const char* also = "");
  /// Arrays of surfaces.
  void AddMaterials(CLI::App& command);

  /// The value of a setting that was added, by its name: as given, else the default.
  double Number(std::string_view setting) const;
  bool IsGiven(std::string_view setting) const;
  /// Its options, with their dashes: "--one", or "--one,--other" where it has two names.
  std::string OptionsOf(std::string_view setting) const;
  /// The option of one that was given and is none of these settings; empty: there is none.
  std::string GivenBeside(std::initializer_list<std::string_view> settings) const;
  /// The kinetic one that was not given is the static one.
  palpate::FrictionPlan Friction() const;

  /// Throws vtkHapticCliProblem that names the option with a value that the setting does not allow.
  void Check() const;
  /// All settings of a path, as given or by default.
  palpate::SettingStore Store() const;
  /// A sentence with an option in place of each setting in braces.
  std::string Said(const std::string& sentence) const;

private:
  struct Entry
  {
    palpate::Setting Described;
    std::string Options; ///< with their dashes
    std::vector<double> Values;
    std::string Text;
    bool On = false; ///< of a switch
    CLI::Option* Option = nullptr;
  };
  const Entry* FindOrNull(std::string_view setting) const;
  const Entry& Find(std::string_view setting) const;

  std::deque<Entry> Entries; ///< options point at their values
};

#endif
