// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticColourRange.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace
{
vtkSMProxy* ProxyOf(vtkSMProxy* owner, const char* property)
{
  return owner->GetProperty(property) ? vtkSMPropertyHelper(owner, property).GetAsProxy() : nullptr;
}

/// Tuples of a function: the value first.
std::vector<double> NumbersOf(vtkSMProxy* owner, const char* property)
{
  return owner && owner->GetProperty(property) ? vtkSMPropertyHelper(owner, property).GetDoubleArray()
                                               : std::vector<double>();
}

/// Along straight lines between points of value, opacity, middle and sharpness.
double OpaqueFrom(const std::vector<double>& points, double otherwise)
{
  constexpr std::size_t each = 4;
  double most = 0.0;
  for (std::size_t i = 1; i < points.size(); i += each)
  {
    most = std::max(most, points[i]);
  }
  for (std::size_t i = each; i + 1 < points.size(); i += each)
  {
    const double before = points[i - each + 1], after = points[i + 1], half = 0.5 * most;
    if (before < half && after >= half)
    {
      return points[i - each] + (half - before) / (after - before) * (points[i] - points[i - each]);
    }
  }
  return otherwise;
}

} // namespace

vtkHapticColourMap vtkHapticColourMapOf(vtkSMProxy* representation)
{
  vtkHapticColourMap map;
  if (!representation)
  {
    return map;
  }
  vtkSMProxy* const colours = ProxyOf(representation, "LookupTable");
  const std::vector<double> points = NumbersOf(colours, "RGBPoints");
  constexpr std::size_t each = 4; // value, red, green, blue
  const bool shown = vtkSMPropertyHelper(representation, "Visibility", true).GetAsInt() != 0;
  if (shown && points.size() >= 2 * each && representation->GetProperty("ColorArrayName"))
  {
    map.Array = vtkSMPropertyHelper(representation, "ColorArrayName").GetInputArrayNameToProcess();
    map.Low = points.front();
    map.High = points[points.size() - each];
    const std::vector<double> opacity = NumbersOf(ProxyOf(representation, "ScalarOpacityFunction"), "Points");
    map.Drawn = opacity.size() > 2 * each;
    map.Opaque = OpaqueFrom(opacity, 0.5 * (map.Low + map.High));
  }
  return map;
}

namespace
{
void Put(vtkSMProxy* session, const std::string& name, const std::vector<double>& numbers)
{
  vtkSMPropertyHelper(session, name.c_str()).Set(numbers.data(), static_cast<unsigned int>(numbers.size()));
}

std::string Give(const vtkHapticColourMap& map, vtkSMProxy* session)
{
  std::ostringstream said;
  const auto isOf = [&](const char* array) { return map.Array == vtkSMPropertyHelper(session, array).GetAsString(); };
  for (const std::string felt : { "Stiffness", "Friction", "Texture" })
  {
    if (isOf((felt + "Array").c_str()))
    {
      Put(session, felt + "DataRange", { map.Low, map.High });
      said << felt << ": " << map.Low << " to " << map.High << " of " << map.Array << "\n";
    }
  }
  if (isOf("FieldArray"))
  {
    constexpr double levels = 8.0;
    Put(session, "FieldIsovalue", { map.Opaque });
    Put(session, "FieldDetentOrigin", { map.Low });
    Put(session, "FieldDetentSpacing", { (map.High - map.Low) / levels });
    said << "Field: isovalue " << map.Opaque << ", levels from " << map.Low << " on, " << (map.High - map.Low) / levels
         << " apart, of " << map.Array << "\n";
  }
  return said.str();
}
} // namespace

std::string vtkHapticTakeColourRange(vtkSMProxy* view, vtkSMProxy* session)
{
  std::string said;
  if (!view || !session || !view->GetProperty("Representations"))
  {
    return said;
  }
  vtkSMPropertyHelper representations(view, "Representations");
  for (unsigned int i = 0; i < representations.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* const representation = representations.GetAsProxy(i);
    const vtkHapticColourMap map = vtkHapticColourMapOf(representation);
    said += !map.Array.empty() && map.High > map.Low ? Give(map, session) : "";
  }
  session->UpdateVTKObjects();
  return said;
}
