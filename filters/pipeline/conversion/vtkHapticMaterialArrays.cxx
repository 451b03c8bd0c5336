// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMaterialArrays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

#include "haptics/core/WordHash.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkHapticConversion.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

using Values = std::vector<double>;

std::string Count(std::size_t count, const char* thing)
{
  return std::to_string(count) + ' ' + thing + (count == 1 ? "" : "s");
}

double ValueAt(vtkDataArray& array, vtkIdType tuple, int component)
{
  if (component >= 0 || array.GetNumberOfComponents() == 1)
  {
    return array.GetComponent(tuple, std::max(0, component));
  }
  double length = 0.0;
  for (int c = 0; c < array.GetNumberOfComponents(); ++c)
  {
    length = std::hypot(length, array.GetComponent(tuple, c)); // squares of large numbers overflow
  }
  return length;
}

/// The mean of the cells around each point; 0 for a point without any, which no triangle uses. Of equal values it is
/// that value to the last bit: a remainder of rounding would be stretched over the whole felt range.
Values MeanOfCells(vtkPolyData& surface, vtkDataArray& array, int component)
{
  const auto points = static_cast<std::size_t>(surface.GetNumberOfPoints());
  Values mean(points, 0.0);
  std::vector<int> cells(points, 0);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface.GetNumberOfCells(); ++cell)
  {
    const double value = ValueAt(array, cell, component);
    surface.GetCellPoints(cell, corners);
    for (const vtkIdType point : *corners)
    {
      const int count = ++cells[point];
      mean[point] += value / count - mean[point] / count;
    }
  }
  return mean;
}

/// One array of one surface, whatever it is attached to.
struct Found
{
  vtkAbstractArray* Array = nullptr;
  bool OfCells = false;
};

Found Find(vtkPolyData& surface, const std::string& name)
{
  if (vtkAbstractArray* array = surface.GetPointData()->GetAbstractArray(name.c_str()))
  {
    return { array, false };
  }
  return { surface.GetCellData()->GetAbstractArray(name.c_str()), true };
}

/// Empty, or why an array cannot be used.
std::string Check(const Found& found, vtkPolyData& surface, const vtkHapticTransfer& transfer)
{
  const std::string name = "its array '" + transfer.Array + "' ";
  if (!vtkDataArray::SafeDownCast(found.Array))
  {
    return name + "holds no numbers";
  }
  const vtkIdType wanted = found.OfCells ? surface.GetNumberOfCells() : surface.GetNumberOfPoints();
  if (found.Array->GetNumberOfTuples() != wanted)
  {
    return name + "has " + Count(static_cast<std::size_t>(found.Array->GetNumberOfTuples()), "value") + " for " +
           Count(static_cast<std::size_t>(wanted), found.OfCells ? "cell" : "point");
  }
  if (transfer.Component >= found.Array->GetNumberOfComponents())
  {
    return name + "has " + Count(static_cast<std::size_t>(found.Array->GetNumberOfComponents()), "component") +
           ", none of number " + std::to_string(transfer.Component);
  }
  return {};
}

Values Read(const Found& found, vtkPolyData& surface, int component)
{
  auto& array = *vtkDataArray::SafeDownCast(found.Array);
  if (found.OfCells)
  {
    return MeanOfCells(surface, array, component);
  }
  Values values(static_cast<std::size_t>(surface.GetNumberOfPoints()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = ValueAt(array, static_cast<vtkIdType>(i), component);
  }
  return values;
}

void AddNames(vtkFieldData& arrays, std::set<std::string>& names)
{
  for (int i = 0; i < arrays.GetNumberOfArrays(); ++i)
  {
    const char* name = arrays.GetArray(i) ? arrays.GetArray(i)->GetName() : nullptr;
    const std::string known = name ? name : "";
    if (!known.empty() && known.rfind("vtk", 0) != 0)
    {
      names.insert(known);
    }
  }
}

std::string Listed(const std::set<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "'" : ", '") + name + "'";
  }
  return list.empty() ? "none" : list;
}

/// The array's values at all vertices, NaN in parts without it; a problem if there is none or one cannot be read.
std::string Gather(
  const std::vector<vtkSmartPointer<vtkPolyData>>& parts, const vtkHapticTransfer& transfer, Values& values)
{
  bool any = false;
  for (const vtkSmartPointer<vtkPolyData>& part : parts)
  {
    const Found found = Find(*part, transfer.Array);
    if (!found.Array)
    {
      values.resize(values.size() + static_cast<std::size_t>(part->GetNumberOfPoints()), NaN);
      continue;
    }
    if (std::string problem = Check(found, *part, transfer); !problem.empty())
    {
      return problem;
    }
    const Values read = Read(found, *part, transfer.Component);
    values.insert(values.end(), read.begin(), read.end());
    any = true;
  }
  if (any)
  {
    return {};
  }
  std::set<std::string> names;
  for (const vtkSmartPointer<vtkPolyData>& part : parts)
  {
    AddNames(*part->GetPointData(), names);
    AddNames(*part->GetCellData(), names);
  }
  return "it has no array '" + transfer.Array + "'; it has " + Listed(names);
}

std::array<double, 2> RangeOf(const Values& values)
{
  constexpr double most = std::numeric_limits<double>::max();
  std::array<double, 2> range{ most, -most };
  for (const double value : values)
  {
    if (std::isfinite(value))
    {
      range = { std::min(range[0], value), std::max(range[1], value) };
    }
  }
  return range;
}

/// The property that an array gives.
struct Use
{
  const char* What;
  const char* Unit;
};

void Describe(const Use& use, const vtkHapticTransfer& transfer, const std::array<double, 2>& range,
  std::size_t unusable, std::string& note)
{
  std::ostringstream text;
  text << use.What << " from '" << transfer.Array << "', " << range[0] << " to " << range[1] << " as "
       << transfer.FeltRange[0] << " to " << transfer.FeltRange[1] << use.Unit;
  if (unusable > 0)
  {
    text << ", " << Count(unusable, "point") << " without a number keep the values of the surface";
  }
  note += (note.empty() ? "" : "; ") + text.str();
}

/// The field one array makes; empty, with a problem, when it cannot be used.
Values FieldOf(const std::vector<vtkSmartPointer<vtkPolyData>>& parts, const vtkHapticTransfer& transfer,
  const Use& use, vtkHapticMaterialResult& result)
{
  if (transfer.Array.empty())
  {
    return {};
  }
  Values values;
  std::string problem = Gather(parts, transfer, values);
  const bool automatic = transfer.DataRange[0] == transfer.DataRange[1];
  const std::array<double, 2> range = automatic ? RangeOf(values) : transfer.DataRange;
  if (problem.empty() && automatic && range[0] > range[1])
  {
    problem = "its array '" + transfer.Array + "' has no finite value";
  }
  if (!problem.empty())
  {
    result.Note += (result.Note.empty() ? "" : "; ") + std::string("its own ") + use.What + ", because " + problem;
    result.Problem = result.Problem.empty() ? problem : result.Problem;
    return {};
  }
  std::transform(
    values.begin(), values.end(), values.begin(), [&](double value) { return transfer.Felt(value, range); });
  const auto unusable = std::count_if(values.begin(), values.end(), [](double felt) { return std::isnan(felt); });
  Describe(use, transfer, range, static_cast<std::size_t>(unusable), result.Note);
  return values;
}

std::string CheckTransfer(const vtkHapticTransfer& transfer, const std::string& what, double least, double most)
{
  const auto finite = [](const std::array<double, 2>& range)
  { return std::isfinite(range[0]) && std::isfinite(range[1]); };
  if (!finite(transfer.DataRange))
  {
    return "the data range for the " + what + " must be two finite numbers";
  }
  const auto [low, high] = std::minmax(transfer.FeltRange[0], transfer.FeltRange[1]);
  if (!finite(transfer.FeltRange) || low < least || high > most)
  {
    std::ostringstream text;
    text << "the target range of the " << what << " must be two finite numbers";
    least == -most ? text << ""
    : most > 1e99  ? text << " from " << least << " on"
                   : text << " from " << least << " to " << most;
    return text.str();
  }
  return transfer.Component < -1 ? "the component for the " + what + " must be -1, the length, or a number from 0 on"
                                 : std::string();
}

/// As a share of a range from one end to the other; ends so far apart that their difference overflows are halved.
double ShareOf(double value, const std::array<double, 2>& range)
{
  constexpr double middle = 0.5; // of an array of one value
  if (range[0] == range[1])
  {
    return middle;
  }
  const double half = std::isfinite(range[1] - range[0]) ? 1.0 : 0.5;
  return std::clamp((half * value - half * range[0]) / (half * range[1] - half * range[0]), 0.0, 1.0);
}
} // namespace

double vtkHapticTransfer::Felt(double value, const std::array<double, 2>& range) const
{
  if (!std::isfinite(value))
  {
    return NaN;
  }
  const double share = ShareOf(value, range);
  return this->FeltRange[0] * (1.0 - share) + this->FeltRange[1] * share;
}

bool vtkHapticMaterialSettings::Empty() const
{
  return this->Stiffness.Array.empty() && this->Friction.Array.empty() && this->Texture.Array.empty();
}

std::string vtkHapticMaterialSettings::Check() const
{
  constexpr double unbounded = 1e100;
  for (const std::string& problem : { CheckTransfer(this->Stiffness, "stiffness [N/m]", 0.0, unbounded),
         CheckTransfer(this->Friction, "friction", 0.0, palpate::Material::largestFriction),
         CheckTransfer(this->Texture, "texture [scene units]", -unbounded, unbounded) })
  {
    if (!problem.empty())
    {
      return problem;
    }
  }
  return {};
}

vtkHapticMaterialResult vtkHapticToMaterial(
  vtkDataObject* data, const std::vector<std::size_t>& partPoints, const vtkHapticMaterialSettings& settings)
{
  vtkHapticMaterialResult result;
  if (settings.Empty())
  {
    return result;
  }
  const std::vector<vtkSmartPointer<vtkPolyData>> parts = vtkHapticSurfaceParts(data, partPoints);
  if (parts.empty())
  {
    result.Note = result.Problem = "its arrays are not those of its points";
    return result;
  }
  palpate::MaterialFields fields;
  fields.stiffness_N_per_m = FieldOf(parts, settings.Stiffness, { "stiffness", " N/m" }, result);
  fields.frictionStatic = fields.frictionKinetic = FieldOf(parts, settings.Friction, { "friction", "" }, result);
  fields.height_u = FieldOf(parts, settings.Texture, { "texture", " scene units high" }, result);
  if (!fields.empty())
  {
    result.Fields = std::make_shared<const palpate::MaterialFields>(std::move(fields));
  }
  return result;
}

std::vector<std::string> vtkHapticArrayNames(vtkDataObject* data)
{
  std::set<std::string> names;
  vtkHapticForEachDataSet(data,
    [&names](vtkDataSet& set)
    {
      AddNames(*set.GetPointData(), names);
      AddNames(*set.GetCellData(), names);
    });
  return { names.begin(), names.end() };
}

std::uint64_t vtkHapticArraysKey(vtkDataObject* data)
{
  palpate::WordHash key;
  vtkHapticForEachDataSet(data,
    [&key](vtkDataSet& set)
    {
      key.add(std::uint64_t{ set.GetPointData()->GetMTime() });
      key.add(std::uint64_t{ set.GetCellData()->GetMTime() });
    });
  return key.value();
}
