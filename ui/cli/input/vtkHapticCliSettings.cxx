// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliSettings.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "haptics/session/path/PathSettings.h"
#include "haptics/session/settings/SessionSettings.h"
#include "vtkHapticCliProblem.h"

namespace
{
/// A second name that scripts know an option by.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> OtherNames = { {
  { "FieldDetentSpacing", "every" },
  { "FieldDetentLevels", "values" },
  { "FieldOther", "with" },
} };

/// The options that give settings without an option of their own.
constexpr std::array<std::pair<std::string_view, std::string_view>, 15> GivenBy = { {
  { "FieldArray", "--field" },
  { "FieldVectors", "--field" },
  { "FieldResistance", "--field" },
  { "FieldIsosurface", "--mode" },
  { "FieldIsovalue", "--iso" },
  { "FieldYield", "--strength" },
  { "FieldFollow", "--strength" },
  { "FieldDrag", "--strength" },
  { "FieldDetent", "--strength" },
  { "FieldSnap", "--strength" },
  { "FieldCompare", "--strength" },
  { "FieldPush", "--strength" },
  { "FieldDragNone", "--range" },
  { "FieldDragFull", "--range" },
  { "LinesAsWalls", "--two-d" },
} };

/// Groups of a tool, a soft body and a mechanism.
constexpr std::array<std::string_view, 3> OfKinds = { "tool", "soft", "mechanism" };

/// Of a material, which mean nothing without its array.
constexpr std::array<std::string_view, 3> OfArray = { "Component", "DataRange", "FeltRange" };

std::string OptionsFor(const palpate::Setting& setting)
{
  const auto* const other = std::ranges::find(OtherNames, setting.name, [](const auto& each) { return each.first; });
  return "--" + std::string(setting.at.option) + (other == OtherNames.end() ? "" : ",--" + std::string(other->second));
}

/// The unit stands behind the first sentence, which names the quantity.
std::string SentenceOf(const palpate::Setting& setting, const std::string& also)
{
  std::string text(setting.sentence);
  if (!setting.unit.empty() && setting.unit != "1")
  {
    text.insert(std::min(text.find(". "), text.size()), " [" + std::string(setting.unit) + "]");
  }
  return text + (also.empty() ? "" : "; " + also);
}

/// The group of the help text.
const char* GroupOf(const palpate::Setting& setting)
{
  const std::string_view name = setting.name;
  const bool material = name.starts_with("Friction") || name.starts_with("Texture") ||
                        (name.starts_with("Stiffness") && name != "Stiffness");
  return setting.at.group == "field" || name.starts_with("Field") ? "Field" : material ? "Material" : "Contact";
}
} // namespace

void vtkHapticCliSettings::AddAll(CLI::App& command)
{
  for (const palpate::Setting& setting : palpate::sessionSettings())
  {
    const bool ofKind = std::ranges::find(OfKinds, setting.at.group) != OfKinds.end();
    if (!setting.at.option.empty() && !ofKind)
    {
      this->Add(command, std::string(setting.name).c_str()).group(GroupOf(setting));
    }
  }
}

void vtkHapticCliSettings::AddMaterials(CLI::App& command)
{
  for (const char* quantity : { "Stiffness", "Friction", "Texture" })
  {
    for (const char* part : { "Array", "Component", "DataRange", "FeltRange" })
    {
      this->Add(command, (std::string(quantity) + part).c_str());
    }
  }
}

CLI::Option& vtkHapticCliSettings::Add(CLI::App& command, const char* setting, const char* also)
{
  Entry& entry = this->Entries.emplace_back();
  entry.Described = palpate::ofPath(palpate::sessionSetting(setting));
  entry.Values = entry.Described.defaults;
  entry.Options = OptionsFor(entry.Described);
  const std::string sentence = SentenceOf(entry.Described, also);
  const int count = static_cast<int>(entry.Values.size());
  entry.Option = entry.Described.kind == palpate::SettingKind::Flag
                   ? command.add_flag(entry.Options, entry.On, sentence)
                 : count == 0 ? command.add_option(entry.Options, entry.Text, sentence)
                              : command.add_option(entry.Options, entry.Values, sentence)->capture_default_str();
  if (entry.Described.kind != palpate::SettingKind::Flag && count > 0)
  {
    count > 1 ? entry.Option->delimiter(',')->expected(count)->type_name(count == 2 ? "LOW,HIGH" : "X,Y,Z")
              : entry.Option->expected(1);
  }
  for (const std::string_view part : OfArray)
  {
    const std::string_view name = entry.Described.name;
    const Entry* const array = name.ends_with(part)
                                 ? this->FindOrNull(std::string(name.substr(0, name.size() - part.size())) + "Array")
                                 : nullptr;
    if (array)
    {
      entry.Option->needs(array->Option);
    }
  }
  return *entry.Option;
}

const vtkHapticCliSettings::Entry* vtkHapticCliSettings::FindOrNull(std::string_view setting) const
{
  const auto named = [setting](const Entry& entry) { return entry.Described.name == setting; };
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(), named);
  return found == this->Entries.end() ? nullptr : &*found;
}

const vtkHapticCliSettings::Entry& vtkHapticCliSettings::Find(std::string_view setting) const
{
  const Entry* const found = this->FindOrNull(setting);
  if (!found)
  {
    throw std::logic_error("no option was added for the setting " + std::string(setting));
  }
  return *found;
}

double vtkHapticCliSettings::Number(std::string_view setting) const
{
  const Entry& entry = this->Find(setting);
  return entry.On ? 1.0 : entry.Values.front();
}

bool vtkHapticCliSettings::IsGiven(std::string_view setting) const
{
  return this->Find(setting).Option->count() > 0;
}

std::string vtkHapticCliSettings::OptionsOf(std::string_view setting) const
{
  return this->Find(setting).Options;
}

std::string vtkHapticCliSettings::GivenBeside(std::initializer_list<std::string_view> settings) const
{
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [&](const Entry& entry)
    {
      const bool among = std::find(settings.begin(), settings.end(), entry.Described.name) != settings.end();
      return !among && entry.Option->count() > 0;
    });
  return found == this->Entries.end() ? "" : found->Options;
}

palpate::FrictionPlan vtkHapticCliSettings::Friction() const
{
  const double statical = this->Number("FrictionStatic");
  return { statical, this->IsGiven("FrictionKinetic") ? this->Number("FrictionKinetic") : statical };
}

void vtkHapticCliSettings::Check() const
{
  for (const Entry& entry : this->Entries)
  {
    const bool text = entry.Described.kind == palpate::SettingKind::Text;
    const std::string problem = text ? "" : palpate::refuse(entry.Described, entry.Values, entry.Options);
    if (!problem.empty())
    {
      throw vtkHapticCliProblem(problem);
    }
  }
  if (const std::string problem = palpate::refusePathSettings(this->Store()); !problem.empty())
  {
    throw vtkHapticCliProblem(this->Said(problem));
  }
}

palpate::SettingStore vtkHapticCliSettings::Store() const
{
  palpate::SettingStore store = palpate::pathSettings();
  for (const Entry& entry : this->Entries)
  {
    store.put(entry.Described.name, palpate::SettingValue{ entry.On ? std::vector{ 1.0 } : entry.Values, entry.Text });
  }
  store.put("FrictionKinetic", this->Friction().kinetic);
  return store;
}

std::string vtkHapticCliSettings::Said(const std::string& sentence) const
{
  return palpate::withNames(sentence,
    [this](std::string_view setting)
    {
      const Entry* const entry = this->FindOrNull(setting);
      const auto* const other = std::ranges::find(GivenBy, setting, [](const auto& each) { return each.first; });
      return entry ? entry->Options : other != GivenBy.end() ? std::string(other->second) : std::string(setting);
    });
}
