// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticLengthUnit.h"

#include "vtkHapticNamedData.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>
#include <string_view>

namespace
{
/// Parts that a machine makes, from pin to ship [mm].
constexpr double smallestPart_mm = 1.0, largestPart_mm = 1e5;

constexpr std::array<std::string_view, 8> medical{ ".nii", ".nii.gz", ".dcm", ".mha", ".mhd", ".nrrd", ".nhdr",
  ".hdr" };

bool EndsWith(std::string name, std::string_view end)
{
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name.ends_with(end);
}

double DiagonalOf(vtkSMSourceProxy& source)
{
  double b[6];
  source.GetDataInformation(0)->GetBounds(b);
  return std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
}

std::string NameOf(const std::string& path)
{
  return path.substr(path.find_last_of("/\\") + 1);
}

vtkHapticLengthUnit UnitOfFile(const std::string& path, vtkSMSourceProxy& reader)
{
  const auto isOf = [&path](std::string_view end) { return EndsWith(path, end); };
  if (std::any_of(medical.begin(), medical.end(), isOf))
  {
    return { "mm", "Lengths are in mm, the unit of the format of " + NameOf(path) + "." };
  }
  const double size = isOf(".stl") ? DiagonalOf(reader) : 0.0;
  if (size >= smallestPart_mm && size <= largestPart_mm)
  {
    return { "mm", "Lengths are taken for mm, as in most STL files: " + NameOf(path) + " names no unit." };
  }
  return {};
}

std::string FileOf(vtkSMProxy& proxy)
{
  for (const char* const name : { "FileName", "FileNames" })
  {
    if (proxy.GetProperty(name) && vtkSMPropertyHelper(&proxy, name).GetNumberOfElements() > 0)
    {
      const char* const path = vtkSMPropertyHelper(&proxy, name).GetAsString();
      return path ? path : "";
    }
  }
  return {};
}

/// The first unit among the sources that a filter's data come from. A pipeline has no cycles, but may be wide.
vtkHapticLengthUnit UnitOf(vtkSMProxy* proxy, std::set<vtkSMProxy*>& seen)
{
  auto* const source = vtkSMSourceProxy::SafeDownCast(proxy);
  if (!source || !seen.insert(proxy).second)
  {
    return {};
  }
  const std::string file = FileOf(*source);
  vtkHapticLengthUnit found = file.empty() ? vtkHapticLengthUnit() : UnitOfFile(file, *source);
  if (found.Reason.empty() && source->GetProperty("Input"))
  {
    const vtkSMPropertyHelper inputs(source, "Input", true);
    for (unsigned int i = 0; i < inputs.GetNumberOfElements() && found.Reason.empty(); ++i)
    {
      found = UnitOf(inputs.GetAsProxy(i), seen);
    }
  }
  return found;
}
} // namespace

vtkHapticLengthUnit vtkHapticLengthUnitOf(vtkSMProxy* view)
{
  vtkHapticLengthUnit found;
  std::set<vtkSMProxy*> seen;
  for (vtkSMProxy* const shown : view ? vtkHapticVisibleRepresentations(view) : std::vector<vtkSMProxy*>())
  {
    found = found.Reason.empty() ? UnitOf(vtkHapticInputOf(shown), seen) : found;
  }
  return found;
}
