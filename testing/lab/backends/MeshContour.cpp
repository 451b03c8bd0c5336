// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/backends/MeshContour.h"

#ifdef PALPATE_LAB_CONTOUR
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#endif

namespace palpate::lab
{
namespace
{

#ifdef PALPATE_LAB_CONTOUR
TriangleMesh contour(int points, const std::function<double(const Vec3&)>& function, double level)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(points, points, points);
  vtkNew<vtkFloatArray> values;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<float>(function(Vec3(image->GetPoint(i)))));
  }
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, level);
  edges->ComputeNormalsOff();
  edges->Update();
  vtkPolyData* const found = edges->GetOutput();
  TriangleMesh mesh;
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
  {
    mesh.vertices_W.emplace_back(found->GetPoint(i));
  }
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  for (found->GetPolys()->InitTraversal(); found->GetPolys()->GetNextCell(count, corners);)
  {
    mesh.triangles.push_back({ static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
      static_cast<std::uint32_t>(corners[2]) });
  }
  return mesh;
}

constexpr MeshContour found = contour;
#else
constexpr MeshContour found = nullptr;
#endif

} // namespace

MeshContour meshContour()
{
  return found;
}

} // namespace palpate::lab
