// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliField.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "haptics/session/settings/SessionSettings.h"
#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticFieldData.h"
#include "vtkHapticReaders.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTouchAlongPath.h"

namespace
{
struct Mode
{
  std::string_view Name;
  const char* Array;    ///< the setting of the array that it is felt from
  const char* Strength; ///< and of the force that it is at most as strong as
};

constexpr std::array<Mode, 7> Modes = { {
  { "isosurface", "FieldArray", "FieldYield" },
  { "detent", "FieldArray", "FieldDetent" },
  { "snap", "FieldArray", "FieldSnap" },
  { "compare", "FieldArray", "FieldCompare" },
  { "follow", "FieldVectors", "FieldFollow" },
  { "push", "FieldVectors", "FieldPush" },
  { "drag", "FieldResistance", "FieldDrag" },
} };
constexpr std::string_view Isosurface = "isosurface", Compare = "compare", SnapPoints = "points", SnapLines = "lines";

/// An option that says how some modes are felt.
struct OfModes
{
  std::string Options; ///< with their dashes
  bool (*Given)(const vtkHapticCliFieldOptions&);
  std::string_view Modes; ///< as a sentence names them; empty: all
};

const std::array<OfModes, 4> OwnOptions = { {
  { "--strength", [](const auto& o) { return !o.Strengths_N.empty(); }, "" },
  { "--with-data", [](const auto& o) { return !o.OtherFile.empty(); }, "compare" },
  { "--range", [](const auto& o) { return !o.Range.empty(); }, "follow, push or drag" },
  { "--snap", [](const auto& o) { return !o.Snap.empty(); }, "snap" },
} };

constexpr std::array<std::pair<std::string_view, std::string_view>, 11> SettingsOfModes = { {
  { "FieldOther", "compare" },
  { "FieldDetentLevels", "detent" },
  { "FieldComponent", "isosurface, detent, snap or compare" },
  { "FieldSmoothing", "isosurface, detent, snap or compare" },
  { "FieldDetentOrigin", "detent" },
  { "FieldDetentSpacing", "detent" },
  { "FieldDetentClick", "detent" },
  { "FieldSnapReach", "snap" },
  { "FieldCompareFull", "compare" },
  { "FieldFullSpeed", "follow or push" },
  { "FieldEigenvector", "follow or push" },
} };

bool Has(const vtkHapticCliFieldOptions& options, std::string_view mode)
{
  return std::ranges::count(options.Modes, mode) > 0;
}

const Mode& ModeOf(const std::string& name)
{
  const auto* const found = std::ranges::find(Modes, std::string_view(name), &Mode::Name);
  if (found == Modes.end())
  {
    throw vtkHapticCliProblem("--mode " + name + ": must be isosurface, detent, snap, compare, follow, push or drag");
  }
  return *found;
}

void CheckCounts(const vtkHapticCliFieldOptions& options)
{
  if (options.Modes.empty() || options.Arrays.empty())
  {
    throw vtkHapticCliProblem("--field and --mode belong together: give an array and its force");
  }
  if (options.Arrays.size() != 1 && options.Arrays.size() != options.Modes.size())
  {
    throw vtkHapticCliProblem("--field: give one array for each --mode, in the same order, or one for all");
  }
  const bool wall = options.Modes.size() == 1 && options.Modes.front() == Isosurface;
  if (options.Strengths_N.size() != options.Modes.size() && !(wall && options.Strengths_N.empty()))
  {
    throw vtkHapticCliProblem(
      "--strength: give one force [N] for each --mode, in the same order (0 for an isosurface: a wall)");
  }
  for (const std::string& mode : options.Modes)
  {
    if (std::ranges::count(options.Modes, mode) > 1)
    {
      throw vtkHapticCliProblem("--mode " + mode + " is given more than once; a mode has one strength");
    }
  }
}

/// An option of modes that are not given is refused rather than ignored.
void CheckModesOfOptions(const vtkHapticCliFieldOptions& options, const vtkHapticCliSettings& settings)
{
  std::vector<OfModes> given;
  std::ranges::copy_if(OwnOptions, std::back_inserter(given), [&](const OfModes& one) { return one.Given(options); });
  for (const auto& [setting, modes] : SettingsOfModes)
  {
    if (settings.IsGiven(setting))
    {
      given.push_back({ settings.OptionsOf(setting), nullptr, modes });
    }
  }
  for (const OfModes& one : given)
  {
    const auto feels = [&one](const std::string& mode) { return one.Modes.find(mode) != std::string_view::npos; };
    if (!one.Modes.empty() && std::ranges::none_of(options.Modes, feels))
    {
      throw vtkHapticCliProblem(one.Options + " belongs to --mode " + std::string(one.Modes) +
                                ", which is not given; add this mode, or omit the option");
    }
  }
}

/// Refuses a mode without its needed options, and options that say the same twice.
void CheckCompanions(const vtkHapticCliFieldOptions& options, const vtkHapticCliSettings& settings)
{
  if (Has(options, Compare) && !settings.IsGiven("FieldOther") && options.OtherFile.empty())
  {
    throw vtkHapticCliProblem(
      "--mode compare: name the other array with --compare-with, or other data with --with-data");
  }
  if (settings.IsGiven("FieldDetentLevels") &&
      (settings.IsGiven("FieldDetentSpacing") || settings.IsGiven("FieldDetentOrigin")))
  {
    throw vtkHapticCliProblem(
      "--levels: they are in place of those of --between-levels and --first-level; omit one of the two");
  }
  if (!options.Snap.empty() && options.Snap != SnapPoints && options.Snap != SnapLines)
  {
    throw vtkHapticCliProblem("--snap " + options.Snap + ": must be points or lines");
  }
  if (!options.Snap.empty() && options.Surfaces.empty())
  {
    throw vtkHapticCliProblem("--snap " + options.Snap + ": name the file with --surface");
  }
}

/// From where to where the strengths of drag, follow and push rise.
void SetRange(const vtkHapticCliFieldOptions& options, const vtkHapticCliSettings& settings,
  palpate::SettingStore& felt, vtkTouchAlongPath& filter)
{
  if (options.Range.empty())
  {
    return;
  }
  const double low = options.Range.front(), high = options.Range.back();
  if (!(std::isfinite(low) && std::isfinite(high) && low < high))
  {
    throw vtkHapticCliProblem("--range LOW,HIGH: must be two finite numbers, the first below the second");
  }
  if (Has(options, "drag"))
  {
    felt.put("FieldDragNone", low);
    felt.put("FieldDragFull", high);
  }
  if (!Has(options, "follow") && !Has(options, "push"))
  {
    return;
  }
  if (low < 0.0)
  {
    throw vtkHapticCliProblem("--range LOW,HIGH: must not be below 0, because follow and push use vector lengths");
  }
  if (settings.IsGiven("FieldFullSpeed"))
  {
    throw vtkHapticCliProblem("--range and --full-length say the same of follow and push; omit one of the two");
  }
  filter.SetNoSpeed(low);
  felt.put("FieldFullSpeed", high);
}

/// A mode's array and strength.
void SetMode(const vtkHapticCliFieldOptions& options, std::size_t i, palpate::SettingStore& felt)
{
  const Mode& mode = ModeOf(options.Modes[i]);
  const std::string& name = options.Arrays[std::min(i, options.Arrays.size() - 1)];
  const std::string& array = felt.text(mode.Array);
  if (!array.empty() && array != name)
  {
    throw vtkHapticCliProblem(
      "--field: \"" + array + "\" and \"" + name + "\" need the same sampled values; choose one of them");
  }
  felt.put(mode.Array, name);
  const double strength_N = options.Strengths_N.empty() ? 0.0 : options.Strengths_N[i];
  const palpate::Setting& setting = palpate::sessionSetting(mode.Strength);
  if (const std::string problem = palpate::refuse(setting, { &strength_N, 1 }, "--strength"); !problem.empty())
  {
    throw vtkHapticCliProblem(problem);
  }
  felt.put(mode.Strength, strength_N);
}

vtkSmartPointer<vtkDataObject> VolumeOf(const std::string& file)
{
  vtkHapticReadVolumeResult read = vtkHapticReadVolume(file);
  if (!read.Volume)
  {
    throw vtkHapticCliProblem(read.Problem);
  }
  vtkHapticCliNote(file, read.Note);
  return read.Volume;
}

/// Without --range strengths rise over all values of the array; one that is the same everywhere has all of it.
void SetUsualRange(vtkDataObject& volume, const vtkHapticCliFieldOptions& options, const vtkHapticCliSettings& settings,
  palpate::SettingStore& felt, vtkTouchAlongPath& filter)
{
  if (!options.Range.empty())
  {
    return;
  }
  const palpate::FieldEnds resistances = vtkHapticFieldEnds(&volume, felt.text("FieldResistance"));
  if (resistances[0] <= resistances[1])
  {
    felt.put("FieldDragNone", resistances[0] < resistances[1] ? resistances[0] : resistances[0] - 1.0);
    felt.put("FieldDragFull", resistances[1]);
  }
  const palpate::FieldEnds lengths = vtkHapticFieldEnds(&volume, felt.text("FieldVectors"));
  if (!settings.IsGiven("FieldFullSpeed") && lengths[0] < lengths[1])
  {
    filter.SetNoSpeed(lengths[0]);
    felt.put("FieldFullSpeed", lengths[1]);
  }
}

/// The points of all surfaces, with their lines where the hand snaps to these.
vtkSmartPointer<vtkPolyData> PlacesOf(const vtkHapticCliFieldOptions& options)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdList> corners;
  for (const std::string& file : options.Surfaces)
  {
    const vtkHapticReadResult read = vtkHapticReadPlaces(file);
    if (!read.Surface)
    {
      throw vtkHapticCliProblem(read.Problem);
    }
    vtkHapticCliNote(file, read.Note);
    if ((options.Snap == SnapLines ? read.Surface->GetNumberOfLines() : read.Surface->GetNumberOfPoints()) == 0)
    {
      throw vtkHapticCliProblem(file + ": it has no " + options.Snap + " for --snap");
    }
    const vtkIdType before = points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < read.Surface->GetNumberOfPoints(); ++i)
    {
      points->InsertNextPoint(read.Surface->GetPoint(i));
    }
    for (vtkIdType i = 0; i < read.Surface->GetNumberOfLines(); ++i)
    {
      read.Surface->GetLines()->GetCellAtId(i, corners);
      std::for_each(corners->begin(), corners->end(), [before](vtkIdType& corner) { corner += before; });
      lines->InsertNextCell(corners);
    }
  }
  auto places = vtkSmartPointer<vtkPolyData>::New();
  places->SetPoints(points);
  if (options.Snap == SnapLines)
  {
    places->SetLines(lines);
  }
  return places;
}

/// An option that says how a field is felt is refused rather than ignored where there is no field.
void CheckNoneIsGiven(const vtkHapticCliFieldOptions& options, const vtkHapticCliSettings& settings)
{
  std::string given = vtkHapticCliGivenOfField(options);
  for (const palpate::Setting& setting : palpate::sessionSettings())
  {
    const bool field = setting.name.starts_with("Field") && !setting.at.option.empty();
    given = given.empty() && field && settings.IsGiven(setting.name) ? settings.OptionsOf(setting.name) : given;
  }
  if (!given.empty())
  {
    throw vtkHapticCliProblem(given + " needs a field; give --field and --mode as well");
  }
}
} // namespace

void vtkHapticCliAddField(CLI::App& command, vtkHapticCliFieldOptions& options)
{
  command
    .add_option("--field", options.Arrays,
      "Array of the first volume (vti, vtr, vts, vtu, vtm, nii) rendered as a field; one per --mode")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
    .add_option("--mode", options.Modes,
      "Field force: isosurface (at --iso), detent, snap or compare (scalars); follow or push (vectors); drag")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
    .add_option("--strength", options.Strengths_N, "Largest force of each --mode [N]; 0 with isosurface: a solid wall")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option(
    "--with-data", options.OtherFile, "Volume with the compared array (the same name, or --with) in --mode compare");
  command
    .add_option("--range", options.Range, "Resistance (drag) or vector length (follow, push) at zero and at full force")
    ->delimiter(',')
    ->expected(2)
    ->type_name("LOW,HIGH");
  command.add_option("--snap", options.Snap, "Target of --mode snap: points or lines of --surface");
  command.add_option("--surface", options.Surfaces, "File touched in addition to the field, or the target of --snap")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

std::string vtkHapticCliGivenOfField(const vtkHapticCliFieldOptions& options)
{
  const auto given = std::ranges::find_if(OwnOptions, [&](const OfModes& one) { return one.Given(options); });
  return given == OwnOptions.end() ? "" : given->Options;
}

void vtkHapticCliTakeField(const vtkHapticCliFieldOptions& options, const vtkHapticCliSettings& settings,
  palpate::SettingStore& felt, std::vector<std::string>& files, vtkTouchAlongPath& filter)
{
  const auto file = std::ranges::find_if(files, vtkHapticIsVolumeFile);
  if (file == files.end())
  {
    throw vtkHapticCliProblem(
      files.front() + ": not a volume for --field; valid types are vti, vtr, vts, vtu, vtm, nii and nii.gz");
  }
  const std::string name = *file;
  files.erase(file);
  const vtkSmartPointer<vtkDataObject> volume = VolumeOf(name);
  SetUsualRange(*volume, options, settings, felt, filter);
  const bool alone = files.empty() && (!options.Snap.empty() || options.Surfaces.empty());
  filter.AddNamed(alone ? 0 : 2, name, volume);
  if (!options.OtherFile.empty())
  {
    filter.AddNamed(4, options.OtherFile, VolumeOf(options.OtherFile));
  }
  if (!options.Snap.empty())
  {
    filter.AddNamed(5, options.Surfaces.front(), PlacesOf(options));
  }
}

void vtkHapticCliSetField(const vtkHapticCliFieldOptions& options, const vtkHapticCliSettings& settings,
  std::optional<double> iso, palpate::SettingStore& felt, vtkTouchAlongPath& filter)
{
  if (!options.Any())
  {
    CheckNoneIsGiven(options, settings);
    return;
  }
  CheckCounts(options);
  CheckModesOfOptions(options, settings);
  CheckCompanions(options, settings);
  for (std::size_t i = 0; i < options.Modes.size(); ++i)
  {
    SetMode(options, i, felt);
  }
  if (Has(options, Isosurface) && !(iso && std::isfinite(*iso)))
  {
    throw vtkHapticCliProblem("--mode isosurface: give the isovalue with --iso");
  }
  felt.put("FieldIsosurface", Has(options, Isosurface) ? 1.0 : 0.0);
  felt.put("FieldIsovalue", Has(options, Isosurface) ? *iso : 0.0);
  SetRange(options, settings, felt, filter);
}
