// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkImageCurves.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "haptics/geometry/curves/CurveChains.h"
#include "haptics/geometry/curves/CurveSimplification.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHapticImageLines.h"
#include "vtkHapticImagePlane.h"
#include "vtkHapticWholeInput.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkImageCurves);

namespace
{
using palpate::Vec3;

/// Shares of the work, for progress: lines found, laid in space, joined; the rest to simplify.
constexpr double LinesShare = 0.6, PlacedShare = 0.65, JoinedShare = 0.75;
constexpr std::size_t ReportEvery = 64;

/// The points of a chain, without those that coincide with the one before: contours through a pixel make such.
std::vector<Vec3> PointsOf(const palpate::CurveChain& chain, const std::vector<Vec3>& points_W)
{
  std::vector<Vec3> curve_W;
  for (const std::uint32_t i : chain.points)
  {
    if (curve_W.empty() || curve_W.back() != points_W[i])
    {
      curve_W.push_back(points_W[i]);
    }
  }
  return curve_W;
}

double LengthOf(const std::vector<Vec3>& curve_W)
{
  double length = 0.0;
  for (std::size_t i = 1; i < curve_W.size(); ++i)
  {
    length += (curve_W[i] - curve_W[i - 1]).norm();
  }
  return length;
}

/// The output while it grows.
class Curves
{
public:
  Curves()
  {
    this->Points->SetDataTypeToDouble();
    this->Error->SetName("Error");
    this->Closed->SetName("Closed");
  }

  void Add(const std::vector<Vec3>& curve_W, double tolerance)
  {
    const palpate::SimplifiedCurve simple = palpate::simplify(curve_W, tolerance);
    const bool closed = curve_W.size() > 2 && curve_W.front() == curve_W.back();
    const vtkIdType first = this->Points->GetNumberOfPoints();
    const auto count = static_cast<vtkIdType>(simple.kept.size());
    this->Lines->InsertNextCell(static_cast<int>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      const bool again = closed && i == count - 1;
      this->Lines->InsertCellPoint(
        again ? first : this->Points->InsertNextPoint(curve_W[simple.kept[static_cast<std::size_t>(i)]].data()));
    }
    this->Error->InsertNextValue(simple.error_u);
    this->Closed->InsertNextValue(closed ? 1 : 0);
  }

  void MoveTo(vtkPolyData* output, double tolerance)
  {
    output->SetPoints(this->Points);
    output->SetLines(this->Lines);
    output->GetCellData()->AddArray(this->Error);
    output->GetCellData()->AddArray(this->Closed);
    vtkNew<vtkDoubleArray> asked;
    asked->SetName("Tolerance");
    asked->InsertNextValue(tolerance);
    output->GetFieldData()->AddArray(asked);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkDoubleArray> Error;
  vtkNew<vtkIntArray> Closed;
};
} // namespace

vtkImageCurves::vtkImageCurves()
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

void vtkImageCurves::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kind: " << this->Kind << "\n";
  os << indent << "UseMiddle: " << this->UseMiddle << "\n";
  os << indent << "Value: " << this->Value << "\n";
  os << indent << "InkIsDark: " << this->InkIsDark << "\n";
  os << indent << "Gap: " << this->Gap << " u\n";
  os << indent << "ShortestCurve: " << this->ShortestCurve << " u\n";
  os << indent << "SimplifyBy: " << this->SimplifyBy << "\n";
  os << indent << "Tolerance: " << this->Tolerance << " u\n";
  os << indent << "LeastForce: " << this->LeastForce << " N\n";
  os << indent << "Stiffness: " << this->Stiffness << " N/m\n";
  os << indent << "Scale: " << this->Scale << " u/m\n";
}

int vtkImageCurves::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

double vtkImageCurves::GetAllowedError() const
{
  return this->SimplifyBy == ByFeel ? this->LeastForce / this->Stiffness * this->Scale : this->Tolerance;
}

const char* vtkImageCurves::CheckNumbers() const
{
  for (const double length : { this->Gap, this->ShortestCurve, this->Tolerance })
  {
    if (!(length >= 0.0 && std::isfinite(length)))
    {
      return "Gap, ShortestCurve and Tolerance must be 0 or more [scene units]";
    }
  }
  if (!(this->LeastForce >= 0.0 && this->Stiffness > 0.0 && this->Scale > 0.0 &&
        std::isfinite(this->GetAllowedError())))
  {
    return "LeastForce [N] must be 0 or more, Stiffness [N/m] and Scale [scene units per metre] above 0";
  }
  return std::isfinite(this->Value) ? nullptr : "Value must be a finite number";
}

double vtkImageCurves::ChooseValue(const vtkHapticImagePlane& plane) const
{
  double range[2];
  plane.GetRange(range);
  const double value = this->UseMiddle ? 0.5 * (range[0] + range[1]) : this->Value;
  if (!(value > range[0] && value <= range[1]))
  {
    std::ostringstream message;
    message << "the value " << value << " meets no curve; the image holds values from " << range[0] << " to "
            << range[1];
    throw std::runtime_error(message.str());
  }
  return value;
}

bool vtkImageCurves::Goes(double progress)
{
  if (!this->GetAbortExecute())
  {
    this->UpdateProgress(progress);
  }
  return !this->GetAbortExecute();
}

palpate::LooseLines vtkImageCurves::FindLines(const vtkHapticImagePlane& plane)
{
  const auto goes = [this](double share) { return this->Goes(LinesShare * share); };
  if (this->Kind == Labels)
  {
    return vtkHapticImageLines::Labels(plane, goes);
  }
  const double value = this->ChooseValue(plane);
  if (this->Kind == Contour)
  {
    return vtkHapticImageLines::Contour(plane, value, goes);
  }
  vtkHapticImageLines::Drawn drawn = vtkHapticImageLines::Drawing(plane, value, this->InkIsDark, this->Gap, goes);
  this->InkShare = drawn.InkShare;
  return std::move(drawn.Lines);
}

void vtkImageCurves::MakeCurves(vtkImageData* image, vtkDataArray* values, vtkPolyData* output)
{
  const vtkHapticImagePlane plane(image, values, this->Kind != Labels);
  palpate::LooseLines lines = this->FindLines(plane);
  if (!this->Goes(LinesShare))
  {
    return;
  }
  for (Vec3& p_W : lines.points_W)
  {
    p_W = plane.ToWorld(p_W.x(), p_W.y());
  }
  if (!this->Goes(PlacedShare))
  {
    return;
  }
  const std::vector<palpate::CurveChain> chains = palpate::joinSegments(lines.segments, lines.points_W.size());
  Curves curves;
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    const double share = static_cast<double>(i) / static_cast<double>(chains.size());
    if (i % ReportEvery == 0 && !this->Goes(JoinedShare + (1.0 - JoinedShare) * share))
    {
      return;
    }
    const std::vector<Vec3> curve_W = PointsOf(chains[i], lines.points_W);
    if (curve_W.size() > 1 && LengthOf(curve_W) >= this->ShortestCurve)
    {
      curves.Add(curve_W, this->GetAllowedError());
    }
  }
  curves.MoveTo(output, this->GetAllowedError());
}

vtkDataArray* vtkImageCurves::ValuesOf(vtkImageData* image, vtkInformationVector** input)
{
  // A proxy made before its input was ever run has no array to choose: its name is empty.
  const char* name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  vtkDataArray* chosen = this->GetInputArrayToProcess(0, input);
  return chosen || (name && *name) ? chosen : image->GetPointData()->GetScalars();
}

int vtkImageCurves::RequestUpdateExtent(vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  vtkHapticAskForWholeImage(input[0]);
  return 1;
}

int vtkImageCurves::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  if (const char* problem = this->CheckNumbers())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  if (vtkHapticRank() > 0)
  {
    return 1; // the first rank has the curves
  }
  this->InkShare = 0.0;
  try
  {
    vtkImageData* image = vtkImageData::GetData(input[0]);
    this->MakeCurves(image, this->ValuesOf(image, input), vtkPolyData::GetData(output));
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("No curves: " << error.what());
    return 0;
  }
  if (this->InkShare > MostInk)
  {
    vtkWarningMacro(<< std::lround(100.0 * this->InkShare)
                    << " % of the image count as strokes: if the lines are the rest, turn \"Ink is dark\" "
                    << (this->InkIsDark ? "off" : "on"));
  }
  return 1;
}
