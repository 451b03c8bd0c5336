// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticShownArrays.h"

#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkType.h"

namespace
{
void AddNames(vtkPVDataSetAttributesInformation* attributes, std::set<std::string>& names)
{
  for (int i = 0; attributes && i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkPVArrayInformation* const array = attributes->GetArrayInformation(i);
    if (array && array->GetDataType() != VTK_STRING && array->GetName())
    {
      names.insert(array->GetName());
    }
  }
}
} // namespace

std::set<std::string> vtkHapticShownArrays(vtkSMProxy* view)
{
  std::set<std::string> names;
  if (!view || !view->GetProperty("Representations"))
  {
    return names;
  }
  const vtkSMPropertyHelper representations(view, "Representations");
  for (unsigned int i = 0; i < representations.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* const shown = representations.GetAsProxy(i);
    if (!shown->GetProperty("Input") || vtkSMPropertyHelper(shown, "Visibility", true).GetAsInt() == 0)
    {
      continue;
    }
    const vtkSMPropertyHelper input(shown, "Input");
    auto* const source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
    vtkPVDataInformation* const data = source ? source->GetDataInformation(input.GetOutputPort()) : nullptr;
    AddNames(data ? data->GetPointDataInformation() : nullptr, names);
    AddNames(data ? data->GetCellDataInformation() : nullptr, names);
  }
  return names;
}
