// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticShownArrays.h"

#include "vtkHapticNamedData.h"
#include "vtkHapticRemoteField.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

std::set<std::string> vtkHapticShownArrays(vtkSMProxy* view)
{
  constexpr int any = 0; // number of components
  std::set<std::string> names;
  for (vtkSMProxy* const shown : view ? vtkHapticVisibleRepresentations(view) : std::vector<vtkSMProxy*>())
  {
    if (auto* const source = vtkSMSourceProxy::SafeDownCast(vtkHapticInputOf(shown)))
    {
      const auto found = vtkHapticRemoteArrayNames(source, vtkSMPropertyHelper(shown, "Input").GetOutputPort(), any);
      names.insert(found.begin(), found.end());
    }
  }
  return names;
}
