// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliSettings.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "haptics/session/settings/SessionSettings.h"
#include "haptics/session/settings/TickFields.h"
#include "vtkHapticCliProblem.h"

namespace
{
/// A second name that scripts know an option by.
constexpr std::array<std::pair<std::string_view, std::string_view>, 1> OtherNames = { {
  { "FieldDetentSpacing", "every" },
} };

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
  const bool field = setting.at.group == "field" || setting.name.starts_with("Field");
  return field ? "Field" : setting.at.group == "friction" ? "Material" : "Contact";
}
} // namespace

void vtkHapticCliSettings::AddAll(CLI::App& command)
{
  for (const palpate::Setting& setting : palpate::sessionSettings())
  {
    if (!setting.at.option.empty())
    {
      this->Add(command, std::string(setting.name).c_str());
      this->Entries.back().Option->group(GroupOf(setting));
    }
  }
}

void vtkHapticCliSettings::Add(CLI::App& command, const char* setting, const char* also)
{
  Entry& entry = this->Entries.emplace_back();
  entry.Described = palpate::ofPath(palpate::sessionSetting(setting));
  entry.Values = entry.Described.defaults;
  entry.Options = OptionsFor(entry.Described);
  const std::string sentence = SentenceOf(entry.Described, also);
  if (entry.Described.kind == palpate::SettingKind::Flag)
  {
    entry.Option = command.add_flag(entry.Options, entry.On, sentence);
    return;
  }
  const int count = static_cast<int>(entry.Values.size());
  entry.Option = command.add_option(entry.Options, entry.Values, sentence)->capture_default_str();
  count > 1 ? entry.Option->delimiter(',')->expected(count)->type_name("X,Y,Z") : entry.Option->expected(1);
}

const vtkHapticCliSettings::Entry& vtkHapticCliSettings::Find(std::string_view setting) const
{
  const auto named = [setting](const Entry& entry) { return entry.Described.name == setting; };
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(), named);
  if (found == this->Entries.end())
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
    if (const std::string problem = palpate::refuse(entry.Described, entry.Values, entry.Options); !problem.empty())
    {
      throw vtkHapticCliProblem(problem);
    }
  }
  palpate::HapticParameters parameters;
  parameters.contact.friction = this->Friction();
  if (const std::string problem = parameters.validate(); !problem.empty())
  {
    throw vtkHapticCliProblem("--mu-static, --mu-kinetic: " + problem);
  }
}

void vtkHapticCliSettings::SetFields(palpate::HapticParameters& parameters) const
{
  for (const Entry& entry : this->Entries)
  {
    if (!entry.Described.at.field.empty())
    {
      const std::vector<double> on = { 1.0 };
      palpate::setField(parameters, entry.Described, entry.On ? on : entry.Values);
    }
  }
}
