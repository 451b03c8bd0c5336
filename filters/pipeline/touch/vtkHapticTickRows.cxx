// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticTickRows.h"

#include <initializer_list>

#include "vtkCellArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace
{
void Make(vtkDataArray* array, const char* name, int components, vtkIdType count)
{
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
}
} // namespace

vtkHapticTickRows::vtkHapticTickRows(std::size_t count)
{
  const auto rows = static_cast<vtkIdType>(count);
  this->Points->SetDataTypeToDouble();
  this->Points->SetNumberOfPoints(rows);
  Make(this->Force, "Force", 3, rows);
  Make(this->Depth, "Depth", 1, rows);
  Make(this->Contacts, "Contacts", 1, rows);
  Make(this->Device, "Device", 3, rows);
  Make(this->Time, "Time", 1, rows);
}

void vtkHapticTickRows::Set(std::size_t row, const vtkHapticTickRow& tick)
{
  const auto i = static_cast<vtkIdType>(row);
  this->Points->SetPoint(i, tick.Proxy_W.data());
  this->Force->SetTuple(i, tick.Force_W.data());
  this->Depth->SetValue(i, (tick.Proxy_W - tick.Device_W).norm());
  this->Contacts->SetValue(i, tick.Contacts);
  this->Device->SetTuple(i, tick.Device_W.data());
  this->Time->SetValue(i, tick.Time);
}

vtkDoubleArray* vtkHapticTickRows::Add(const char* name, int components)
{
  this->More.push_back(vtkSmartPointer<vtkDoubleArray>::New());
  Make(this->More.back(), name, components, this->Points->GetNumberOfPoints());
  return this->More.back();
}

void vtkHapticTickRows::MoveTo(vtkPolyData* output)
{
  const vtkIdType count = this->Points->GetNumberOfPoints();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    lines->InsertCellPoint(i);
  }
  output->SetPoints(this->Points);
  output->SetLines(lines);
  vtkPointData* const data = output->GetPointData();
  for (vtkDataArray* array :
    std::initializer_list<vtkDataArray*>{ this->Force, this->Depth, this->Contacts, this->Device, this->Time })
  {
    data->AddArray(array);
  }
  for (const auto& array : this->More)
  {
    data->AddArray(array);
  }
}
