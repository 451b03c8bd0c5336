// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticWholeInput.h"

#include <vector>

#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace
{
/// Null where there is one rank.
vtkMultiProcessController* Others()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}

std::vector<vtkSmartPointer<vtkDataObject>> PiecesOf(vtkDataObject* piece, vtkMultiProcessController& others)
{
  std::vector<vtkSmartPointer<vtkDataObject>> pieces, filled;
  others.AllGather(piece, pieces);
  for (const vtkSmartPointer<vtkDataObject>& each : pieces)
  {
    if (each && each->GetNumberOfElements(vtkDataObject::POINT) > 0)
    {
      filled.push_back(each);
    }
  }
  return filled;
}
} // namespace

int vtkHapticRank()
{
  vtkMultiProcessController* others = Others();
  return others ? others->GetLocalProcessId() : 0;
}

vtkSmartPointer<vtkDataObject> vtkHapticWholeSurface(vtkDataObject* piece)
{
  vtkMultiProcessController* others = Others();
  if (!others || !piece)
  {
    return piece;
  }
  const std::vector<vtkSmartPointer<vtkDataObject>> pieces = PiecesOf(piece, *others);
  if (pieces.size() == 1)
  {
    return pieces.front();
  }
  vtkNew<vtkMultiBlockDataSet> whole;
  for (const vtkSmartPointer<vtkDataObject>& each : pieces)
  {
    whole->SetBlock(whole->GetNumberOfBlocks(), each);
  }
  return whole;
}

vtkSmartPointer<vtkPolyData> vtkHapticWholePath(vtkPolyData* piece)
{
  vtkMultiProcessController* others = Others();
  if (!others || !piece)
  {
    return piece;
  }
  const std::vector<vtkSmartPointer<vtkDataObject>> pieces = PiecesOf(piece, *others);
  if (pieces.size() > 1)
  {
    return nullptr;
  }
  return pieces.empty() ? piece : vtkPolyData::SafeDownCast(pieces.front());
}
