// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/shown/ArmWorkSpaceMap.h"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace palpate
{

std::vector<ArmPlace> mapWorkSpace(const Arm& arm, int steps)
{
  const ArmWorkSpace& space = arm.plan().workSpace;
  std::vector<ArmPlace> places;
  const int deep = arm.directions() == 2 ? 0 : steps;
  const double half = 0.5 * steps;
  for (int z = 0; z <= deep && space.radius_m > 0.0; ++z)
  {
    for (int y = 0; y <= steps; ++y)
    {
      for (int x = 0; x <= steps; ++x)
      {
        const Vec3 way(x / half - 1.0, y / half - 1.0, deep == 0 ? 0.0 : z / half - 1.0);
        if (way.squaredNorm() > 1.0 + 1e-12)
        {
          continue;
        }
        ArmPlace place;
        place.p_D = space.centre_D + space.radius_m * way;
        const std::optional<JointVector> q = arm.inverse(place.p_D);
        place.reached = q.has_value();
        place.measures = q ? measure(arm, *q) : ArmMeasures{};
        places.push_back(place);
      }
    }
  }
  return places;
}

ArmRange rangeOf(const Arm& arm, const std::vector<ArmPlace>& places)
{
  constexpr double endless = std::numeric_limits<double>::infinity();
  ArmRange range;
  range.places = places.size();
  range.leastCondition = range.leastManipulability = range.leastForce_N = range.leastMass_kg = endless;
  for (const ArmPlace& place : places)
  {
    range.reached += place.reached ? 1 : 0;
    const ArmMeasures& at = place.measures;
    if (!place.reached || !(at.condition < arm.plan().maxCondition))
    {
      continue;
    }
    ++range.usable;
    range.best_D = at.condition < range.leastCondition ? place.p_D : range.best_D;
    range.leastCondition = std::min(range.leastCondition, at.condition);
    range.mostCondition = std::max(range.mostCondition, at.condition);
    range.leastManipulability = std::min(range.leastManipulability, at.manipulability);
    range.mostManipulability = std::max(range.mostManipulability, at.manipulability);
    range.leastForce_N = std::min(range.leastForce_N, at.leastForce_N);
    range.mostForce_N = std::max(range.mostForce_N, at.leastForce_N);
    range.leastMass_kg = std::min(range.leastMass_kg, at.leastMass_kg);
    range.mostMass_kg = std::max(range.mostMass_kg, at.mostMass_kg);
  }
  return range.usable > 0 ? range : ArmRange{ range.places, range.reached };
}

std::string noteOn(const Arm& arm, const ArmRange& range)
{
  if (range.places == 0)
  {
    return "the file has no work space";
  }
  const auto share = [&range](std::size_t count)
  { return 100.0 * static_cast<double>(count) / static_cast<double>(range.places); };
  char text[160] = "";
  if (range.reached < range.places)
  {
    std::snprintf(
      text, sizeof text, "the arm does not reach %.3g %% of its work space", share(range.places - range.reached));
  }
  std::string note = text;
  if (range.usable < range.reached)
  {
    std::snprintf(text, sizeof text,
      "%.3g %% of the work space is nearer to a singularity than a condition of %.3g: there is no force there",
      share(range.reached - range.usable), arm.plan().maxCondition);
    note += (note.empty() ? "" : "; ") + std::string(text);
  }
  return note;
}

} // namespace palpate
