// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticWholeInput.h"

#include <array>
#include <vector>

#include "vtkAppendFilter.h"
#include "vtkAppendPolyData.h"
#include "vtkBoundingBox.h"
#include "vtkCleanPolyData.h"
#include "vtkCommunicator.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

namespace
{
/// Null where there is one rank.
vtkMultiProcessController* Others()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}

double Reduced(double own, int operation)
{
  vtkMultiProcessController* others = Others();
  double reduced = own;
  if (others)
  {
    others->AllReduce(&own, &reduced, 1, operation);
  }
  return reduced;
}

/// Those that have anything.
std::vector<vtkSmartPointer<vtkDataObject>> FilledOf(const std::vector<vtkSmartPointer<vtkDataObject>>& pieces)
{
  std::vector<vtkSmartPointer<vtkDataObject>> filled;
  for (const vtkSmartPointer<vtkDataObject>& each : pieces)
  {
    if (each && each->GetNumberOfElements(vtkDataObject::POINT) + each->GetNumberOfElements(vtkDataObject::ROW) > 0)
    {
      filled.push_back(each);
    }
  }
  return filled;
}

std::vector<vtkSmartPointer<vtkDataObject>> PiecesOf(vtkDataObject* piece, vtkMultiProcessController& others)
{
  std::vector<vtkSmartPointer<vtkDataObject>> pieces;
  others.AllGather(piece, pieces);
  return FilledOf(pieces);
}

/// Polygons of several pieces, which have a point each along their seams, as one surface.
vtkSmartPointer<vtkDataSet> Joined(const std::vector<vtkSmartPointer<vtkDataObject>>& pieces)
{
  if (vtkPolyData::SafeDownCast(pieces.front()))
  {
    vtkNew<vtkAppendPolyData> append;
    vtkNew<vtkCleanPolyData> clean;
    for (const vtkSmartPointer<vtkDataObject>& each : pieces)
    {
      append->AddInputData(vtkPolyData::SafeDownCast(each));
    }
    clean->SetInputConnection(append->GetOutputPort());
    clean->SetTolerance(0.0);
    clean->ConvertPolysToLinesOff();
    clean->Update();
    return clean->GetOutput();
  }
  vtkNew<vtkAppendFilter> append;
  append->MergePointsOn();
  append->SetTolerance(0.0);
  for (const vtkSmartPointer<vtkDataObject>& each : pieces)
  {
    append->AddInputData(each);
  }
  append->Update();
  return append->GetOutput();
}
} // namespace

int vtkHapticRank()
{
  vtkMultiProcessController* others = Others();
  return others ? others->GetLocalProcessId() : 0;
}

int vtkHapticRanks()
{
  vtkMultiProcessController* others = Others();
  return others ? others->GetNumberOfProcesses() : 1;
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

void vtkHapticGatherSurface(vtkPolyData* piece, vtkPolyData* whole)
{
  vtkMultiProcessController* others = Others();
  if (!others)
  {
    whole->ShallowCopy(piece);
    return;
  }
  std::vector<vtkSmartPointer<vtkDataObject>> pieces;
  others->Gather(piece, pieces, 0);
  if (others->GetLocalProcessId() > 0)
  {
    return;
  }
  vtkNew<vtkAppendPolyData> append;
  for (const vtkSmartPointer<vtkDataObject>& each : pieces)
  {
    append->AddInputData(vtkPolyData::SafeDownCast(each));
  }
  append->Update();
  whole->ShallowCopy(append->GetOutput());
}

vtkSmartPointer<vtkDataSet> vtkHapticGatherDataSet(vtkDataSet* piece)
{
  vtkMultiProcessController* others = Others();
  if (!others || !piece)
  {
    return piece;
  }
  std::vector<vtkSmartPointer<vtkDataObject>> pieces;
  others->Gather(piece, pieces, 0);
  if (others->GetLocalProcessId() > 0)
  {
    return vtkSmartPointer<vtkDataSet>::Take(piece->NewInstance());
  }
  const std::vector<vtkSmartPointer<vtkDataObject>> filled = FilledOf(pieces);
  return filled.empty()       ? vtkSmartPointer<vtkDataSet>(piece)
         : filled.size() == 1 ? vtkSmartPointer<vtkDataSet>(vtkDataSet::SafeDownCast(filled.front()))
                              : Joined(filled);
}

double vtkHapticSumOfRanks(double own)
{
  return Reduced(own, vtkCommunicator::SUM_OP);
}

double vtkHapticLargestOfRanks(double own)
{
  return Reduced(own, vtkCommunicator::MAX_OP);
}

bool vtkHapticHoldsOnAllRanks(bool own)
{
  return vtkHapticSumOfRanks(own ? 0.0 : 1.0) == 0.0;
}

vtkBoundingBox vtkHapticBoxOfRanks(const vtkBoundingBox& own)
{
  vtkMultiProcessController* others = Others();
  vtkBoundingBox all = own;
  if (others)
  {
    others->AllReduce(own, all);
  }
  return all;
}

vtkSmartPointer<vtkDataObject> vtkHapticOnePiece(vtkDataObject* piece)
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
  return pieces.empty() ? vtkSmartPointer<vtkDataObject>(piece) : pieces.front();
}

void vtkHapticAskForWholeImage(vtkInformationVector* input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const info = input->GetInformationObject(0);
  std::array<int, 6> extent{};
  if (info->Has(Pipeline::WHOLE_EXTENT()))
  {
    info->Get(Pipeline::WHOLE_EXTENT(), extent.data());
    info->Set(Pipeline::UPDATE_EXTENT(), extent.data(), 6);
  }
  info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
}
