// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticViewScan.h"

#include <algorithm>

namespace
{
bool SameMatrix(vtkMatrix4x4* a, vtkMatrix4x4* b)
{
  return std::equal(a->GetData(), a->GetData() + 16, b->GetData());
}
} // namespace

bool vtkHapticViewScan::SameAs(const vtkHapticViewScan& other) const
{
  const auto same = [](const Surface& a, const Surface& b)
  { return a.Name == b.Name && a.GeometryKey == b.GeometryKey && SameMatrix(a.Matrix, b.Matrix); };
  return std::equal(this->Surfaces.begin(), this->Surfaces.end(), other.Surfaces.begin(), other.Surfaces.end(), same);
}

bool vtkHapticViewScan::SameNamesAs(const vtkHapticViewScan& other) const
{
  return std::equal(this->Surfaces.begin(), this->Surfaces.end(), other.Surfaces.begin(), other.Surfaces.end(),
    [](const Surface& a, const Surface& b) { return a.Name == b.Name; });
}

bool vtkHapticViewScan::SameArraysAs(const vtkHapticViewScan& other) const
{
  return std::equal(this->Surfaces.begin(), this->Surfaces.end(), other.Surfaces.begin(), other.Surfaces.end(),
    [](const Surface& a, const Surface& b) { return a.ArraysKey == b.ArraysKey; });
}
