// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticConversionAhead.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "haptics/core/WordHash.h"
#include "vtkDataSet.h"
#include "vtkMatrix4x4.h"

namespace
{
bool IsLarge(vtkDataObject* data)
{
  vtkIdType cells = 0, points = 0;
  vtkHapticForEachDataSet(data,
    [&](vtkDataSet& set)
    {
      cells += set.GetNumberOfCells();
      points += set.GetNumberOfPoints();
    });
  return std::max(cells, points) >= vtkHapticConversionAhead::LeastCells;
}

std::uint64_t KeyOf(vtkHapticConversionAhead::Part part, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  palpate::WordHash key;
  key.add(static_cast<std::uint64_t>(part));
  key.add(vtkHapticContentKey(data, matrix));
  return key.value();
}

bool IsDone(const std::shared_future<vtkHapticConversionResult>& made)
{
  return made.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}
} // namespace

vtkSmartPointer<vtkDataObject> vtkHapticSharedCopy(vtkDataObject* data)
{
  auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  return copy;
}

bool vtkHapticConversionAhead::Ready(Part part, vtkDataObject* data, vtkMatrix4x4* matrix, const Reading& read)
{
  if (!IsLarge(data))
  {
    return true;
  }
  const std::uint64_t key = KeyOf(part, data, matrix);
  const auto found = this->Made.find(key);
  if (found != this->Made.end())
  {
    return IsDone(found->second);
  }
  std::erase_if(this->Left, IsDone);
  const auto working =
    std::count_if(this->Made.begin(), this->Made.end(), [](const auto& made) { return !IsDone(made.second); });
  if (working + static_cast<std::ptrdiff_t>(this->Left.size()) >= Threads)
  {
    return false;
  }
  auto place = vtkSmartPointer<vtkMatrix4x4>::New();
  matrix ? place->DeepCopy(matrix) : place->Identity();
  this->Made[key] = std::async(std::launch::async,
    [copy = vtkHapticSharedCopy(data), place, read] {
      return read(copy, place);
    }).share();
  return false;
}

std::optional<vtkHapticConversionResult> vtkHapticConversionAhead::Take(
  Part part, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  const auto found = this->Made.find(KeyOf(part, data, matrix));
  return found == this->Made.end() || !IsDone(found->second) ? std::nullopt : std::optional(found->second.get());
}

bool vtkHapticConversionAhead::Busy() const
{
  return !this->Made.empty();
}

void vtkHapticConversionAhead::Forget()
{
  for (auto& [key, made] : this->Made)
  {
    this->Left.push_back(std::move(made));
  }
  this->Made.clear();
  std::erase_if(this->Left, IsDone);
}
