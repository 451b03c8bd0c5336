// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticTetraFill.h"

#include <cmath>

#include "haptics/session/settings/Setting.h"
#include "vtkCellData.h"
#include "vtkHapticConversion.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace
{
constexpr double EdgesAcross = 12.0;
constexpr double DistanceOfEdge = 0.25;

palpate::TetraSizes Chosen(palpate::TetraSizes sizes, double diagonal_u)
{
  sizes.edge_u = sizes.edge_u > 0.0 ? sizes.edge_u : diagonal_u / EdgesAcross;
  sizes.distance_u = sizes.distance_u > 0.0 ? sizes.distance_u : DistanceOfEdge * sizes.edge_u;
  return sizes;
}

vtkSmartPointer<vtkUnstructuredGrid> GridOf(const palpate::TetraMeshResult& made)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const palpate::Vec3& v : made.mesh.vertices_W)
  {
    points->InsertNextPoint(v.data());
  }
  grid->SetPoints(points);
  grid->Allocate(static_cast<vtkIdType>(made.mesh.tetras.size()));
  for (const palpate::Tetra& t : made.mesh.tetras)
  {
    const vtkIdType corners[] = { t[0], t[1], t[2], t[3] };
    grid->InsertNextCell(VTK_TETRA, 4, corners);
  }
  return grid;
}

vtkHapticTetraFillResult ResultOf(const palpate::TetraMeshResult& made, const palpate::TetraSizes& sizes)
{
  vtkHapticTetraFillResult result;
  result.Problem = made.refusal;
  result.Rough = sizes.distance_u;
  result.Grid = made.refusal.empty() ? GridOf(made) : nullptr;
  return result;
}

/// The values of an image as labels; empty where they are none.
std::vector<std::uint32_t> LabelsOf(vtkImageData& image)
{
  std::vector<std::uint32_t> labels;
  vtkDataArray* const scalars = image.GetPointData()->GetScalars();
  for (vtkIdType i = 0; scalars && scalars->GetNumberOfComponents() == 1 && i < scalars->GetNumberOfTuples(); ++i)
  {
    const double value = scalars->GetTuple1(i);
    labels.push_back(value > 0.0 && value < 4294967295.0 ? static_cast<std::uint32_t>(std::lround(value)) : 0);
  }
  return labels;
}
} // namespace

vtkHapticTetraFillResult vtkHapticFillSurface(
  vtkPolyData& surface, palpate::TetraSizes sizes, const palpate::Goes& goes)
{
  const vtkHapticConversionResult read = vtkHapticToMesh(&surface);
  palpate::CleanResult clean = read.Mesh ? palpate::cleanMesh(*read.Mesh) : palpate::CleanResult{};
  if (!read.Mesh || !clean.ok())
  {
    return { nullptr, read.Mesh ? clean.refusal : read.Problem, "", 0.0 };
  }
  sizes = Chosen(sizes, surface.GetLength());
  const palpate::TetraMeshResult made = palpate::meshInside(palpate::SurfaceTree(std::move(clean.mesh)), sizes, goes);
  vtkHapticTetraFillResult result = ResultOf(made, sizes);
  result.Note = std::isfinite(made.bound_u)
                  ? "the border of the tetrahedra is within " + palpate::quantity(made.bound_u, "u") + " of the surface"
                  : "the border of the tetrahedra could not be proven to be near the surface: inspect the result";
  return result;
}

vtkHapticTetraFillResult vtkHapticFillLabels(vtkImageData& image, palpate::TetraSizes sizes, const palpate::Goes& goes)
{
  if (!image.GetDirectionMatrix()->IsIdentity())
  {
    return { nullptr, "the label image is rotated: resample the image along the axes first", "", 0.0 };
  }
  palpate::LabelImage labels;
  image.GetDimensions(labels.counts.data());
  image.GetSpacing(labels.step_u.data());
  labels.labels = LabelsOf(image);
  const int* const extent = image.GetExtent();
  for (int axis = 0; axis < 3; ++axis)
  {
    labels.first_W[axis] = image.GetOrigin()[axis] + extent[2 * axis] * labels.step_u[axis];
  }
  sizes = Chosen(sizes, image.GetLength());
  const palpate::TetraMeshResult made = palpate::meshLabels(labels, sizes, goes);
  vtkHapticTetraFillResult result = ResultOf(made, sizes);
  if (result.Grid)
  {
    vtkNew<vtkIntArray> array;
    array->SetName("Label");
    for (const std::uint32_t label : made.labels)
    {
      array->InsertNextValue(static_cast<int>(label));
    }
    result.Grid->GetCellData()->AddArray(array);
  }
  return result;
}
