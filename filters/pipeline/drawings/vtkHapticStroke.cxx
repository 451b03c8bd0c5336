// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticStroke.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkHapticConversion.h"
#include "vtkHapticStrokeProfile.h"
#include "vtkHapticWholeInput.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkHapticStroke);

namespace
{
using palpate::Vec3;

constexpr std::size_t MostPlaces = 1000000;
/// Steeper than this from one place to the next is a cliff: the hand would be led into the surface.
constexpr double SteepestSlope = 3.0;

Vec3 CentreOf(const palpate::TriangleMesh& mesh)
{
  Vec3 low_W = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high_W = -low_W;
  for (const Vec3& p_W : mesh.vertices_W)
  {
    if (p_W.allFinite())
    {
      low_W = low_W.cwiseMin(p_W);
      high_W = high_W.cwiseMax(p_W);
    }
  }
  return 0.5 * (low_W + high_W);
}

/// Unit vectors of the cut; false if the directions do not span a plane.
bool Orthonormal(const double up[3], const double along[3], vtkHapticCutFrame& frame)
{
  frame.Up_W = Vec3(up).normalized();
  const Vec3 across_W = Vec3(along) - Vec3(along).dot(frame.Up_W) * frame.Up_W;
  frame.Along_W = across_W.normalized();
  constexpr double leastAngle = 1e-6;
  return frame.Up_W.allFinite() && frame.Along_W.allFinite() && Vec3(up).norm() > 0.0 &&
         across_W.norm() > leastAngle * Vec3(along).norm();
}

/// Points of the stroke in the frame of the cut, pushed in along the profile's normal.
struct PushedPoint
{
  double S = 0.0;
  double H = 0.0;
  double Depth = 0.0;
};

std::vector<PushedPoint> PushIn(
  const vtkHapticHeights& profile, const std::vector<double>& smooth, double depth, double lift)
{
  std::vector<PushedPoint> points;
  const std::size_t last = smooth.size() - 1;
  for (std::size_t i = 0; i <= last; ++i)
  {
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = std::min(i + 1, last);
    const double slope = (smooth[after] - smooth[before]) / (static_cast<double>(after - before) * profile.Step);
    const double secant = std::sqrt(1.0 + slope * slope);
    if (i == 0 && lift > 0.0)
    {
      points.push_back({ profile.At(0) - lift * slope / secant, profile.Height[0] + lift / secant, -lift });
    }
    points.push_back({ profile.At(i) + depth * slope / secant, smooth[i] - depth / secant,
      depth + (profile.Height[i] - smooth[i]) / secant });
  }
  return points;
}

void Write(const std::vector<PushedPoint>& points, const vtkHapticCutFrame& frame, vtkPolyData* output)
{
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> depth;
  depth->SetName("Depth");
  const auto add = [&](const PushedPoint& point)
  {
    const Vec3 p_W = frame.Origin_W + point.S * frame.Along_W + point.H * frame.Up_W;
    coordinates->InsertNextPoint(p_W.data());
    depth->InsertNextValue(point.Depth);
  };
  std::for_each(points.begin(), points.end(), add);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(coordinates->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < coordinates->GetNumberOfPoints(); ++i)
  {
    lines->InsertCellPoint(i);
  }
  output->SetPoints(coordinates);
  output->SetLines(lines);
  output->GetPointData()->AddArray(depth);
}
} // namespace

void vtkHapticStroke::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [&](const char* name, const double v[3])
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  vector("Up", this->Up);
  vector("Along", this->Along);
  vector("Origin", this->Origin);
  os << indent << "UseCentre: " << this->UseCentre << "\n";
  os << indent << "Depth: " << this->Depth << " u\n";
  os << indent << "Lift: " << this->Lift << " u\n";
  os << indent << "Step: " << this->Step << " u\n";
  os << indent << "Window: " << this->Window << " u\n";
  os << indent << "Reach: " << this->Reach << "\n";
}

int vtkHapticStroke::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

const char* vtkHapticStroke::CheckNumbers() const
{
  for (const double length : { this->Depth, this->Lift, this->Window })
  {
    if (!(length >= 0.0 && std::isfinite(length)))
    {
      return "Depth, Lift and Window must be 0 or more [scene units]";
    }
  }
  if (!(this->Step > 0.0 && std::isfinite(this->Step)))
  {
    return "Step must be more than 0 [scene units]";
  }
  return this->Reach > 0.0 && this->Reach <= 1.0 ? nullptr : "Reach must be in (0, 1]";
}

int vtkHapticStroke::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  if (const char* problem = this->CheckNumbers())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  vtkHapticCutFrame frame;
  if (!Orthonormal(this->Up, this->Along, frame))
  {
    vtkErrorMacro("Up and Along must be two directions that are not parallel");
    return 0;
  }
  const vtkSmartPointer<vtkDataObject> whole = vtkHapticWholeSurface(vtkDataObject::GetData(input[0]));
  if (vtkHapticRank() > 0)
  {
    return 1; // one hand: the first rank has its path
  }
  const vtkHapticConversionResult surface = vtkHapticToMesh(whole);
  if (!surface.Mesh)
  {
    vtkErrorMacro("The surface cannot be stroked: " << surface.Problem);
    return 0;
  }
  frame.Origin_W = this->UseCentre ? CentreOf(*surface.Mesh) : Vec3(this->Origin);
  const auto profile = vtkHapticCutProfile(*surface.Mesh, frame, this->Step, MostPlaces);
  const vtkHapticHeights run = vtkHapticLongestRun(profile.value_or(vtkHapticHeights()), SteepestSlope * this->Step);
  const vtkHapticHeights stroked = vtkHapticMiddle(run, this->Reach);
  if (stroked.Height.size() < 2)
  {
    vtkErrorMacro("The plane of the stroke cuts no part of the surface longer than a step of "
                  << this->Step << " u; move the plane or choose another step");
    return 0;
  }
  // Smoothed as a whole: a window that shrinks at the ends of the stroke would bend it there.
  const double half = std::min(this->Window / (2.0 * this->Step), static_cast<double>(run.Height.size()));
  vtkHapticHeights smooth = run;
  smooth.Height = vtkHapticSmoothBelow(run.Height, static_cast<std::size_t>(half));
  Write(PushIn(stroked, vtkHapticMiddle(smooth, this->Reach).Height, this->Depth, this->Lift), frame,
    vtkPolyData::GetData(output));
  return 1;
}
