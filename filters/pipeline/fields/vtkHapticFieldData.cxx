// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFieldData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkHapticImageField.h"
#include "vtkHapticResampledField.h"
#include "vtkHapticSnapPlaces.h"
#include "vtkHapticVtkVersions.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUniformGrid.h"
#include "vtkUniformGridAMR.h"

namespace
{
vtkDataArray* FindArray(vtkDataSet* part, const std::string& name)
{
  vtkDataArray* const atPoints = part->GetPointData()->GetArray(name.c_str());
  return atPoints ? atPoints : part->GetCellData()->GetArray(name.c_str());
}

bool HasAbstractArray(vtkDataSet* part, const std::string& name)
{
  return part->GetPointData()->HasArray(name.c_str()) || part->GetCellData()->HasArray(name.c_str());
}

bool IsTensor(int components)
{
  return components == 6 || components == 9;
}

/// "" where every array that is asked for is one of numbers and has the components that its role needs.
std::string RefuseArray(const std::vector<vtkDataSet*>& parts, const std::string& name, int components)
{
  if (name.empty())
  {
    return "";
  }
  const auto with = std::find_if(parts.begin(), parts.end(), [&](vtkDataSet* part) { return FindArray(part, name); });
  if (with == parts.end())
  {
    const bool isText =
      std::any_of(parts.begin(), parts.end(), [&](vtkDataSet* part) { return HasAbstractArray(part, name); });
    return "its array \"" + name + (isText ? "\" is not numeric" : "\" does not exist; choose another one");
  }
  const int has = FindArray(*with, name)->GetNumberOfComponents();
  return components == 3 && has != 3 && !IsTensor(has)
           ? "its array \"" + name + "\" has " + std::to_string(has) +
               " components, and directions need 3, or the 6 or 9 of a symmetric tensor"
           : "";
}

std::string RefuseArrays(const std::vector<vtkDataSet*>& parts, const vtkHapticFieldArrays& arrays)
{
  if (!arrays.Any())
  {
    return "no array is chosen; choose one for the field";
  }
  for (const auto& [name, components] : { std::pair(arrays.Scalar, 1), std::pair(arrays.Vector, 3),
         std::pair(arrays.Resistance, 1), std::pair(arrays.Beside ? std::string() : arrays.Other, 1) })
  {
    if (const std::string problem = RefuseArray(parts, name, components); !problem.empty())
    {
      return problem;
    }
  }
  return "";
}

/// The least and the largest finite value of a component, or of the length; turned round where there is none.
std::array<double, 2> EndsOf(const std::vector<vtkDataSet*>& parts, const std::string& name, int component)
{
  std::array<double, 2> ends{ std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  for (vtkDataSet* part : parts)
  {
    vtkDataArray* const array = FindArray(part, name);
    std::array<double, 2> range{};
    if (array && array->GetNumberOfTuples() > 0)
    {
      array->GetFiniteRange(range.data(), component);
      ends = { std::min(ends[0], range[0]), std::max(ends[1], range[1]) };
    }
  }
  return ends;
}

/// "" where the scalar has values that differ and that single precision reaches.
std::string RefuseValues(
  const std::vector<vtkDataSet*>& parts, const vtkHapticFieldArrays& arrays, const palpate::FieldEnds& ends)
{
  if (arrays.Scalar.empty())
  {
    return "";
  }
  const std::string array = "its array \"" + arrays.Scalar + "\"";
  const auto with =
    std::find_if(parts.begin(), parts.end(), [&](vtkDataSet* part) { return FindArray(part, arrays.Scalar); });
  if (const int has = FindArray(*with, arrays.Scalar)->GetNumberOfComponents(); arrays.Component >= has)
  {
    return array + " has " + std::to_string(has) +
           " components, counted from 0; choose one of them, or -1 for their length";
  }
  const auto [low, high] = ends;
  if (!(low <= high))
  {
    return array + " has no finite values";
  }
  const double largest = std::max(std::abs(low), std::abs(high));
  if (largest > std::numeric_limits<float>::max())
  {
    return array + " has values beyond single precision; scale them with the filter Calculator";
  }
  const bool alone = arrays.Vector.empty() && arrays.Resistance.empty() && arrays.Other.empty() && !arrays.Beside;
  return alone && low == high ? array + " has the same value everywhere: a field needs different values" : "";
}

/// Values that are far from 0 beside their range are kept less their middle: single precision then resolves the 10
/// millionth part of the range. Up to there it is the file's own, and a block has the data's numbers to the bit.
double OffsetOf(const palpate::FieldEnds& ends)
{
  constexpr double farFrom0 = 64.0;
  const auto [low, high] = ends;
  const double middle = low + 0.5 * (high - low);
  return high > low && std::abs(middle) > farFrom0 * (high - low) ? middle : 0.0;
}

bool HasTensor(const std::vector<vtkDataSet*>& parts, const std::string& name)
{
  const auto with = std::find_if(parts.begin(), parts.end(), [&](vtkDataSet* part) { return FindArray(part, name); });
  return with != parts.end() && IsTensor(FindArray(*with, name)->GetNumberOfComponents());
}

bool IsThick(vtkImageData& image)
{
  const int* const size = image.GetDimensions();
  return size[0] > 1 && size[1] > 1 && size[2] > 1;
}

/// The grids of all levels, the finest last: resampling overwrites values of grids before.
vtkSmartPointer<vtkMultiBlockDataSet> FinestLast(vtkUniformGridAMR& levels)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned level = 0; level < levels.GetNumberOfLevels(); ++level)
  {
    for (unsigned i = 0; i < vtkHapticNumberOfGrids(levels, level); ++i)
    {
      if (vtkDataObject* const grid = vtkHapticGridOf(levels, level, i))
      {
        blocks->SetBlock(blocks->GetNumberOfBlocks(), grid);
      }
    }
  }
  return blocks;
}

/// Values of cells at points, where an array that is asked for is at cells alone.
vtkSmartPointer<vtkImageData> WithPointData(vtkImageData& image)
{
  vtkNew<vtkCellDataToPointData> toPoints;
  toPoints->SetInputData(&image);
  toPoints->PassCellDataOn();
  toPoints->Update();
  return vtkImageData::SafeDownCast(toPoints->GetOutput());
}
vtkHapticFieldResult Convert(
  vtkDataObject* data, const std::vector<vtkDataSet*>& parts, const vtkHapticFieldArrays& arrays)
{
  auto* const image = vtkImageData::SafeDownCast(data);
  if (image && !IsThick(*image))
  {
    const int* const size = image->GetDimensions();
    const bool plane = std::count(size, size + 3, 1) == 1;
    return { nullptr, plane ? "the data are flat, but a field needs a volume: extract curves with Image Curves"
                            : "the data are a line or a single point, but a field needs a volume" };
  }
  if (image)
  {
    auto kept = vtkSmartPointer<vtkImageData>::Take(image->NewInstance());
    kept->ShallowCopy(image);
    return {
      std::make_shared<vtkHapticImageField>(vtkHapticAllAtPoints(*kept, arrays) ? kept : WithPointData(*kept), arrays), ""
    };
  }
  auto* const levels = vtkUniformGridAMR::SafeDownCast(data);
  return vtkHapticResampled(levels ? FinestLast(*levels).Get() : data, parts, arrays);
}
vtkHapticFieldResult ToField(vtkDataObject* data, const vtkHapticFieldArrays& asked)
{
  const std::vector<vtkDataSet*> parts = vtkHapticFieldSets(data);
  const auto filled = [](vtkDataSet* part) { return part->GetNumberOfPoints() > 0; };
  if (std::none_of(parts.begin(), parts.end(), filled))
  {
    return { nullptr, "it has no points" };
  }
  if (std::string problem = RefuseArrays(parts, asked); !problem.empty())
  {
    return { nullptr, std::move(problem) };
  }
  vtkHapticFieldArrays arrays = asked;
  arrays.Tensor = HasTensor(parts, asked.Vector);
  const palpate::FieldEnds none{ 1.0, 0.0 };
  const palpate::FieldEnds ends = arrays.Scalar.empty() ? none : EndsOf(parts, arrays.Scalar, arrays.Component);
  arrays.Offset = OffsetOf(ends);
  vtkHapticFieldResult result = Convert(data, parts, arrays);
  result.Ends = ends;
  result.Bounds = vtkHapticFieldBounds(data);
  if (std::string problem = result.Source ? RefuseValues(parts, arrays, result.Ends) : ""; !problem.empty())
  {
    return { nullptr, std::move(problem) };
  }
  return result;
}

/// Compares the scalar with an array of other data; false, with a problem, where that cannot be.
bool Compare(vtkDataObject& with, const vtkHapticFieldArrays& arrays, vtkHapticFieldResult& result)
{
  vtkHapticFieldArrays other;
  other.Scalar = arrays.Other.empty() ? arrays.Scalar : arrays.Other;
  other.Component = arrays.Component;
  other.Smoothing = arrays.Smoothing;
  vtkHapticFieldResult beside = ToField(&with, other);
  result.Problem = beside.Source ? "" : "compared data: " + beside.Problem;
  result.Source = beside.Source ? palpate::comparedWith(std::move(result.Source), std::move(beside.Source)) : nullptr;
  return result.Source != nullptr;
}
} // namespace

std::vector<vtkDataSet*> vtkHapticFieldSets(vtkDataObject* data)
{
  std::vector<vtkDataSet*> parts;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      if (auto* part = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()))
      {
        parts.push_back(part);
      }
    }
  }
  else if (auto* one = vtkDataSet::SafeDownCast(data))
  {
    parts.push_back(one);
  }
  return parts;
}

bool vtkHapticAllAtPoints(vtkDataSet& data, const vtkHapticFieldArrays& arrays)
{
  const std::vector<vtkHapticFieldPart> parts = vtkHapticFieldParts(arrays);
  return std::all_of(parts.begin(), parts.end(),
    [&data](const vtkHapticFieldPart& part) { return data.GetPointData()->GetArray(part.Name.c_str()); });
}

vtkHapticFieldResult vtkHapticToField(
  vtkDataObject* data, const vtkHapticFieldArrays& arrays, const vtkHapticComparedField& beside)
{
  vtkHapticFieldArrays own = arrays;
  own.Beside = beside.Compared != nullptr;
  vtkHapticFieldResult result = ToField(data, own);
  if (result.Source && beside.Compared && !Compare(*beside.Compared, arrays, result))
  {
    return { nullptr, std::move(result.Problem) };
  }
  if (result.Source && beside.Snap)
  {
    vtkHapticSnapPlacesResult snap = vtkHapticToSnapPlaces(beside.Snap);
    if (!snap.Problem.empty())
    {
      return { nullptr, std::move(snap.Problem) };
    }
    result.Source = palpate::snappingTo(std::move(result.Source), std::move(snap.Places));
  }
  return result;
}
std::array<double, 6> vtkHapticFieldBounds(vtkDataObject* data)
{
  vtkBoundingBox box;
  for (vtkDataSet* part : vtkHapticFieldSets(data))
  {
    std::array<double, 6> bounds{};
    part->GetBounds(bounds.data());
    box.AddBounds(bounds.data());
  }
  std::array<double, 6> bounds{};
  box.GetBounds(bounds.data());
  return bounds;
}

palpate::FieldEnds vtkHapticFieldEnds(vtkDataObject* data, const std::string& name)
{
  constexpr int length = -1;
  const std::vector<vtkDataSet*> parts = vtkHapticFieldSets(data);
  return HasTensor(parts, name) ? palpate::FieldEnds{ 1.0, 0.0 } : EndsOf(parts, name, length);
}

bool vtkHapticFitsComponents(int has, int components)
{
  return components == 0 || has == components || (components == 3 && IsTensor(has));
}

std::vector<std::string> vtkHapticFieldArrayNames(vtkDataObject* data, int components)
{
  std::set<std::string> names;
  for (vtkDataSet* part : vtkHapticFieldSets(data))
  {
    for (vtkDataSetAttributes* attributes : { static_cast<vtkDataSetAttributes*>(part->GetPointData()),
           static_cast<vtkDataSetAttributes*>(part->GetCellData()) })
    {
      for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
      {
        vtkDataArray* const array = attributes->GetArray(i);
        const bool named =
          array && array->GetName() && std::string(array->GetName()) != vtkDataSetAttributes::GhostArrayName();
        if (named && vtkHapticFitsComponents(array->GetNumberOfComponents(), components))
        {
          names.insert(array->GetName());
        }
      }
    }
  }
  return { names.begin(), names.end() };
}
