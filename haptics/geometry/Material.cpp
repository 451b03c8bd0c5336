// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/Material.h"

#include <cmath>

namespace palpate
{
namespace
{

struct Range
{
  double least, most;

  [[nodiscard]] bool holds(double value) const { return value >= this->least && value <= this->most; }
};

constexpr Range factors{ 0.0, 1.0 }, frictions{ 0.0, Material::largestFriction };

/// Picks the values of the cleaned vertices; what cannot be used becomes `own`.
void fit(const std::vector<double>& raw, double own, const Range& range, const std::vector<std::uint32_t>& sourceVertex,
  std::vector<double>& fitted, std::size_t& replaced)
{
  if (raw.empty())
  {
    return;
  }
  fitted.reserve(sourceVertex.size());
  for (const std::uint32_t source : sourceVertex)
  {
    const bool usable = std::isfinite(raw[source]) && range.holds(raw[source]);
    replaced += usable ? 0 : 1;
    fitted.push_back(usable ? raw[source] : own);
  }
}

} // namespace

std::string Material::validate() const
{
  if (!factors.holds(this->stiffnessFactor))
  {
    return "the stiffness factor of a surface must be a number from 0 to 1";
  }
  const bool asPlan = this->frictionStatic < 0.0 && this->frictionKinetic < 0.0;
  if (!asPlan && !(frictions.holds(this->frictionStatic) && frictions.holds(this->frictionKinetic) &&
                   this->frictionKinetic <= this->frictionStatic))
  {
    return "the friction of a surface must be from 0 to 10, the kinetic no more than the static one";
  }
  return {};
}

FittedFields fitFields(const MaterialFields& raw, const Material& own, const std::vector<std::uint32_t>& sourceVertex,
  std::size_t rawVertices)
{
  FittedFields result;
  for (const std::vector<double>* const field :
    { &raw.stiffnessFactor, &raw.frictionStatic, &raw.frictionKinetic, &raw.height_u })
  {
    if (!field->empty() && field->size() != rawVertices)
    {
      result.refusal = "a material array has " + std::to_string(field->size()) + " values for " +
                       std::to_string(rawVertices) + " points";
      return result;
    }
  }
  const Range anyHeight{ -1e300, 1e300 };
  MaterialFields& fields = result.fields;
  fit(raw.stiffnessFactor, own.stiffnessFactor, factors, sourceVertex, fields.stiffnessFactor, result.replaced);
  fit(raw.frictionStatic, own.frictionStatic, frictions, sourceVertex, fields.frictionStatic, result.replaced);
  fit(raw.frictionKinetic, own.frictionKinetic, frictions, sourceVertex, fields.frictionKinetic, result.replaced);
  fit(raw.height_u, 0.0, anyHeight, sourceVertex, fields.height_u, result.replaced);
  return result;
}

} // namespace palpate
