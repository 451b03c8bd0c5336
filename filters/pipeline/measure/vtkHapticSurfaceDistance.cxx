// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSurfaceDistance.h"

#include <limits>
#include <sstream>

#include "haptics/geometry/measure/RayWalk.h"
#include "haptics/geometry/simplify/SurfaceDistance.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHapticMeasuredSurface.h"
#include "vtkHapticPieces.h"
#include "vtkHapticSurfaceMean.h"
#include "vtkHapticWholeInput.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

vtkStandardNewMacro(vtkHapticSurfaceDistance);

namespace
{
using palpate::PointSide;
using palpate::Vec3;

constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

double DistanceTo(const palpate::SurfaceTree& reference, const Vec3& x_W)
{
  return x_W.allFinite() ? palpate::nearestOn(reference.data(), x_W).distance_u : Unknown;
}

double SignOf(const palpate::SurfaceTree& reference, const Vec3& x_W)
{
  const PointSide side = x_W.allFinite() ? palpate::sideOf(reference, x_W) : PointSide::Unknown;
  return side == PointSide::Unknown ? Unknown : side == PointSide::Inside ? -1.0 : 1.0;
}

vtkSmartPointer<vtkDoubleArray> AddArray(vtkPolyData* data, const char* name)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(data->GetNumberOfPoints());
  data->GetPointData()->AddArray(array);
  return array;
}

/// Adds the arrays of distances and returns Distance.
vtkDataArray* Measure(vtkPolyData* data, const palpate::SurfaceTree& reference)
{
  const bool closed = palpate::isClosed(reference);
  const vtkSmartPointer<vtkDoubleArray> distance = AddArray(data, "Distance");
  const vtkSmartPointer<vtkDoubleArray> signedDistance = closed ? AddArray(data, "SignedDistance") : nullptr;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    Vec3 x_W;
    data->GetPoint(i, x_W.data());
    distance->SetValue(i, DistanceTo(reference, x_W));
    if (signedDistance)
    {
      signedDistance->SetValue(i, SignOf(reference, x_W) * distance->GetValue(i));
    }
  }
  data->GetPointData()->SetActiveScalars("Distance");
  return distance;
}

void AddNumber(vtkPolyData* data, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  data->GetFieldData()->AddArray(array);
}

std::string SentenceOf(const vtkHapticMean& distance)
{
  std::ostringstream text;
  text.precision(4);
  text << "Distance to the reference: mean " << distance.Mean << " u, root mean square " << distance.RMS
       << " u, maximum " << distance.Maximum << " u.";
  return text.str();
}
} // namespace

vtkHapticSurfaceDistance::vtkHapticSurfaceDistance()
{
  this->SetNumberOfInputPorts(2);
}

vtkHapticSurfaceDistance::~vtkHapticSurfaceDistance() = default;

void vtkHapticSurfaceDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Text: " << this->Text << "\n";
}

void vtkHapticSurfaceDistance::SetReferenceConnection(vtkAlgorithmOutput* reference)
{
  this->SetInputConnection(1, reference);
}

int vtkHapticSurfaceDistance::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkDataSet");
  if (port == 1)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  return 1;
}

int vtkHapticSurfaceDistance::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->Text.clear();
  if (const std::string refusal = vtkHapticRefusePieces(output); !refusal.empty())
  {
    vtkErrorMacro("Nothing is measured: " << refusal);
    return 0;
  }
  std::string problem;
  const auto reference = vtkHapticMeasuredSurface(vtkHapticWholeSurface(vtkDataObject::GetData(input[1])), problem);
  if (!reference)
  {
    vtkErrorMacro("Nothing can be compared with the reference: " << problem);
    return 0;
  }
  vtkPolyData* const measured = vtkPolyData::GetData(output);
  measured->ShallowCopy(vtkPolyData::GetData(input[0]));
  // A rank without points has empty arrays: where one lacks them, none are gathered.
  const vtkHapticMean distance = vtkHapticMeanOver(measured, Measure(measured, *reference));
  AddNumber(measured, "MeanDistance", distance.Mean);
  AddNumber(measured, "RMSDistance", distance.RMS);
  AddNumber(measured, "MaximumDistance", distance.Maximum);
  this->Text = SentenceOf(distance);
  return 1;
}
