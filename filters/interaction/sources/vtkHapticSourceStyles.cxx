// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSourceStyles.h"

#include <stdexcept>
#include <vector>

#include "vtkHapticTextRows.h"

namespace
{
using Fields = std::vector<std::string>;
const Fields Header = { "Source", "Touched", "Stiffness", "FrictionStatic", "FrictionKinetic" };
const Fields LooseHeader = { "Source", "Touched", "Stiffness", "FrictionStatic", "FrictionKinetic", "Density" };

std::string Row(const Fields& fields)
{
  std::string row;
  for (const std::string& field : fields)
  {
    row += (row.empty() ? "" : ",") + field;
  }
  return row + "\n";
}

vtkHapticSourceStyle StyleOf(const Fields& row, std::size_t columns)
{
  if (row.size() != columns)
  {
    throw std::runtime_error("it has " + std::to_string(row.size()) + " fields instead of " + std::to_string(columns));
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
  style.Density = columns == LooseHeader.size() ? vtkHapticTextRows::Number(row[5]) : 0.0;
  const std::string ofMaterial = style.Material.validate();
  if (const std::string problem = ofMaterial.empty() ? vtkHapticRefuseDensity(style.Density) : ofMaterial;
      !problem.empty())
  {
    throw std::runtime_error(problem);
  }
  return style;
}
} // namespace

std::string vtkHapticRefuseDensity(double density)
{
  constexpr double heaviest = 1e6; // no known solid is a tenth of that
  return density >= 0.0 && density <= heaviest
           ? ""
           : "the density of a loose source must be above 0 and at most 1e6 kg/m3; 0 has the source fixed";
}

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

std::map<std::string, double> vtkHapticSourceStyles::Densities() const
{
  std::map<std::string, double> densities;
  for (const auto& [name, style] : this->Styles)
  {
    if (style.Density > 0.0)
    {
      densities[name] = style.Density;
    }
  }
  return densities;
}

std::string vtkHapticSourceStyles::ToText() const
{
  const bool loose = !this->Densities().empty();
  std::string text = this->Styles.empty() ? "" : Row(loose ? LooseHeader : Header);
  for (const auto& [name, style] : this->Styles)
  {
    const palpate::Material& material = style.Material;
    Fields row{ vtkHapticTextRows::Quoted(name), style.Touched ? "1" : "0",
      vtkHapticTextRows::Digits(material.stiffness_N_per_m), vtkHapticTextRows::Digits(material.frictionStatic),
      vtkHapticTextRows::Digits(material.frictionKinetic) };
    if (loose)
    {
      row.push_back(vtkHapticTextRows::Digits(style.Density));
    }
    text += Row(row);
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
    const Fields header = text.empty() ? Header : rows.Next();
    if (header != Header && header != LooseHeader)
    {
      throw std::runtime_error("its columns are not Source, Touched, Stiffness, FrictionStatic, FrictionKinetic and, "
                               "of loose sources, Density");
    }
    while (!rows.AtEnd())
    {
      const Fields row = rows.Next();
      name = row.front();
      read.Set(name, StyleOf(row, header.size()));
    }
  }
  catch (const std::runtime_error& error)
  {
    return name + ": " + error.what();
  }
  *this = std::move(read);
  return {};
}
