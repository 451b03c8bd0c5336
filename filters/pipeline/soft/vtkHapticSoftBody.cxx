// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSoftBody.h"

#include "vtkHapticSoftBodyData.h"
#include "vtkHapticSoftLoad.h"
#include "vtkHapticTetraFill.h"
#include "vtkHapticWholeInput.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHapticSoftBody);

namespace
{
constexpr double NearOfDiagonal = 1e-3;

/// Whose vertices are near the cells of a data set, or near its points where it has no cells.
void FixNear(vtkUnstructuredGrid& body, vtkDataSet& holds, double within)
{
  auto* const fixed = vtkIntArray::SafeDownCast(body.GetPointData()->GetArray("Fixed"));
  vtkNew<vtkStaticCellLocator> cells;
  vtkNew<vtkStaticPointLocator> points;
  const bool byCells = holds.GetNumberOfCells() > 0;
  vtkLocator* const locator = byCells ? static_cast<vtkLocator*>(cells) : static_cast<vtkLocator*>(points);
  locator->SetDataSet(&holds);
  locator->BuildLocator();
  for (vtkIdType i = 0; i < body.GetNumberOfPoints(); ++i)
  {
    double at[3], nearest[3];
    body.GetPoint(i, at);
    double distance2 = 0.0;
    vtkIdType cell = -1;
    int part = 0;
    const bool found = byCells ? cells->FindClosestPointWithinRadius(at, within, nearest, cell, part, distance2) != 0
                               : points->FindClosestPointWithinRadius(within, at, distance2) >= 0;
    if (found)
    {
      fixed->SetValue(i, 1);
    }
  }
}
} // namespace

vtkHapticSoftBody::vtkHapticSoftBody()
  : Young(vtkHapticSoftMaterial::UsualYoungPa), Poisson(vtkHapticSoftMaterial::UsualPoisson),
    Density(vtkHapticSoftMaterial::UsualDensity)
{
  this->SetNumberOfInputPorts(2);
}

vtkHapticSoftBody::~vtkHapticSoftBody()
{
  this->SetYoungArray(nullptr);
  this->SetFixed(nullptr);
  this->SetLoadArray(nullptr);
}

void vtkHapticSoftBody::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Young: " << this->Young << " Pa\n";
  os << indent << "YoungArray: " << (this->YoungArray ? this->YoungArray : "(none)") << "\n";
  os << indent << "Poisson: " << this->Poisson << "\n";
  os << indent << "Model: " << this->Model << "\n";
  os << indent << "Unit: " << this->Unit << " m\n";
  os << indent << "Fixed: " << (this->Fixed ? this->Fixed : "(none)") << "\n";
  os << indent << "FixedDistance: " << this->FixedDistance << " u\n";
  os << indent << "Density: " << this->Density << " kg/m3\n";
  os << indent << "Gravity: " << this->Gravity[0] << " " << this->Gravity[1] << " " << this->Gravity[2] << " m/s2\n";
  os << indent << "LoadArray: " << (this->LoadArray ? this->LoadArray : "(none)") << "\n";
  os << indent << "EdgeLength: " << this->EdgeLength << " u\n";
  os << indent << "SurfaceDistance: " << this->SurfaceDistance << " u\n";
  os << indent << "Text: " << this->Text << "\n";
}

int vtkHapticSoftBody::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

bool vtkHapticSoftBody::Goes(double progress)
{
  this->UpdateProgress(progress);
  return !this->CheckAbort();
}

vtkSmartPointer<vtkUnstructuredGrid> vtkHapticSoftBody::Mesh(vtkDataObject* data, double& rough, std::string& problem)
{
  auto* const surface = vtkPolyData::SafeDownCast(data);
  auto* const image = vtkImageData::SafeDownCast(data);
  if (!surface && !image)
  {
    return vtkHapticTetrahedra(data, problem);
  }
  palpate::TetraSizes sizes;
  sizes.edge_u = this->EdgeLength;
  sizes.distance_u = this->SurfaceDistance;
  const auto goes = [this](double progress) { return this->Goes(progress); };
  const vtkHapticTetraFillResult made =
    surface ? vtkHapticFillSurface(*surface, sizes, goes) : vtkHapticFillLabels(*image, sizes, goes);
  problem = made.Problem;
  rough = made.Rough;
  this->Text = made.Note.empty() ? "" : "; " + made.Note;
  return made.Grid;
}

bool vtkHapticSoftBody::Make(vtkDataObject* data, vtkDataSet* holds, vtkUnstructuredGrid* output, std::string& problem)
{
  const bool sizes = this->EdgeLength >= 0.0 && std::isfinite(this->EdgeLength) && this->SurfaceDistance >= 0.0 &&
                     std::isfinite(this->SurfaceDistance) && this->FixedDistance >= 0.0 &&
                     std::isfinite(this->FixedDistance);
  problem = sizes ? "" : "edge length and distances must be finite numbers, 0 or above";
  this->Text.clear();
  double rough = 0.0;
  const vtkSmartPointer<vtkUnstructuredGrid> body = sizes ? this->Mesh(data, rough, problem) : nullptr;
  if (!body)
  {
    return false;
  }
  vtkHapticSoftMaterial material{ this->Young, this->Poisson, static_cast<palpate::ElasticModel>(this->Model),
    this->Unit, this->Density };
  const std::string array = this->YoungArray ? this->YoungArray : "";
  if (!vtkHapticFixBody(*body, this->Fixed ? this->Fixed : "", rough, problem) ||
      !vtkHapticDescribeBody(*body, material, array, problem) ||
      !vtkHapticLoadBody(*body, palpate::Vec3(this->Gravity), this->LoadArray ? this->LoadArray : "", problem))
  {
    return false;
  }
  if (holds)
  {
    FixNear(*body, *holds, this->FixedDistance > 0.0 ? this->FixedDistance : NearOfDiagonal * body->GetLength());
  }
  const vtkHapticSoftBodyResult read = vtkHapticToSoftBody(body);
  const palpate::CheckedTetras checked =
    read.Input ? palpate::checkTetras(read.Input->mesh, read.Input->fixed) : palpate::CheckedTetras();
  problem = read.Input ? checked.refusal : read.Problem;
  if (!problem.empty())
  {
    return false;
  }
  const std::string left = checked.report.summary();
  vtkHapticBendBody(*body, *read.Input, nullptr, nullptr);
  this->Text = vtkHapticSoftBodyText(*read.Input) + this->Text + (left.empty() ? "" : "; of the ") + left;
  this->Rest = body;
  output->ShallowCopy(body);
  return true;
}

void vtkHapticSoftBody::ShowBent(vtkUnstructuredGrid* bent)
{
  const bool known = this->KnownTime == this->GetMTime();
  this->Bent = bent;
  this->Modified();
  this->KnownTime = known ? this->GetMTime() : 0;
}

bool vtkHapticSoftBody::OnlyBends(vtkMTimeType inputs)
{
  return this->Rest && this->KnownTime == this->GetMTime() && this->InputsTime == inputs;
}

/// A label image becomes one body, whichever ranks have parts of the image.
int vtkHapticSoftBody::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (vtkImageData::GetData(input[0]))
  {
    vtkHapticAskForWholeImage(input[0]);
    return 1;
  }
  return this->Superclass::RequestUpdateExtent(request, input, output);
}

int vtkHapticSoftBody::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkDataSet* const piece = vtkDataSet::GetData(input[0]);
  vtkDataSet* const held = vtkDataSet::GetData(input[1]);
  const vtkMTimeType inputs = std::max(piece->GetMTime(), held ? held->GetMTime() : 0);
  if (vtkHapticHoldsOnAllRanks(this->OnlyBends(inputs)))
  {
    vtkUnstructuredGrid::GetData(output)->ShallowCopy(this->Bent ? this->Bent : this->Rest);
    return 1;
  }
  this->Rest = nullptr;
  this->Bent = nullptr;
  const bool image = vtkImageData::SafeDownCast(piece) != nullptr; // each rank has all of it
  const vtkSmartPointer<vtkDataSet> data = image ? vtkSmartPointer<vtkDataSet>(piece) : vtkHapticGatherDataSet(piece);
  const vtkSmartPointer<vtkDataSet> holds = vtkHapticGatherDataSet(held);
  std::string problem;
  const bool first = vtkHapticRank() == 0; // which has the body
  if (first && !this->Make(data, holds, vtkUnstructuredGrid::GetData(output), problem))
  {
    vtkErrorMacro("No soft body was made: " << problem);
  }
  if (!vtkHapticHoldsOnAllRanks(problem.empty()))
  {
    return 0;
  }
  this->Rest = first ? this->Rest : vtkSmartPointer<vtkUnstructuredGrid>::New();
  this->KnownTime = this->GetMTime();
  this->InputsTime = inputs;
  return 1;
}
