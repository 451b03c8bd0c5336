// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSourceStyles.h"

#include <stdexcept>
#include <vector>

#include "vtkHapticTextRows.h"

namespace
{
const std::vector<std::string> Header = { "Source", "Touched", "Stiffness", "FrictionStatic", "FrictionKinetic" };

std::string Row(const std::vector<std::string>& fields)
{
  std::string row;
  for (const std::string& field : fields)
  {
    row += (row.empty() ? "" : ",") + field;
  }
  return row + "\n";
}

vtkHapticSourceStyle StyleOf(const std::vector<std::string>& row)
{
  if (row.size() != Header.size())
  {
    throw std::runtime_error(
      "it has " + std::to_string(row.size()) + " fields instead of " + std::to_string(Header.size()));
  }
  const double touched = vtkHapticTextRows::Number(row[1]);
  if (touched != 0.0 && touched != 1.0)
  {
    throw std::runtime_error("Touched must be 0 or 1, not '" + row[1] + "'");
  }
  vtkHapticSourceStyle style;
  style.Touched = touched != 0.0;
  style.Material = { vtkHapticTextRows::Number(row[2]), vtkHapticTextRows::Number(row[3]),
    vtkHapticTextRows::Number(row[4]) };
  if (const std::string problem = style.Material.validate(); !problem.empty())
  {
    throw std::runtime_error(problem);
  }
  return style;
}
} // namespace

vtkHapticSourceStyle vtkHapticSourceStyles::Of(const std::string& name) const
{
  const auto found = this->Styles.find(name);
  return found != this->Styles.end() ? found->second : vtkHapticSourceStyle();
}

void vtkHapticSourceStyles::Set(const std::string& name, const vtkHapticSourceStyle& style)
{
  this->Styles[name] = style;
  std::erase_if(this->Styles, [](const auto& each) { return each.second == vtkHapticSourceStyle(); });
}

std::string vtkHapticSourceStyles::ToText() const
{
  std::string text = this->Styles.empty() ? "" : Row(Header);
  for (const auto& [name, style] : this->Styles)
  {
    const palpate::Material& material = style.Material;
    text += Row({ vtkHapticTextRows::Quoted(name), style.Touched ? "1" : "0",
      vtkHapticTextRows::Digits(material.stiffness_N_per_m), vtkHapticTextRows::Digits(material.frictionStatic),
      vtkHapticTextRows::Digits(material.frictionKinetic) });
  }
  return text;
}

std::string vtkHapticSourceStyles::FromText(std::string_view text)
{
  vtkHapticSourceStyles read;
  std::string name = "the list of sources";
  try
  {
    vtkHapticTextRows rows(text);
    if (!text.empty() && rows.Next() != Header)
    {
      throw std::runtime_error("its columns are not Source, Touched, Stiffness, FrictionStatic and FrictionKinetic");
    }
    while (!rows.AtEnd())
    {
      const std::vector<std::string> row = rows.Next();
      name = row.front();
      read.Set(name, StyleOf(row));
    }
  }
  catch (const std::runtime_error& error)
  {
    return name + ": " + error.what();
  }
  *this = std::move(read);
  return {};
}
