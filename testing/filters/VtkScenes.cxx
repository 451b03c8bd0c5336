// SPDX-License-Identifier: GPL-3.0-or-later
#include "VtkScenes.h"

#include "testing/haptics/compliance/Blocks.h"
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkExecutive.h"
#include "vtkHapticSoftBody.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkUnstructuredGrid.h"

namespace palpate::testing
{

namespace
{
vtkSmartPointer<vtkPoints> makePoints(const std::vector<Vec3>& points_W)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (const Vec3& p_W : points_W)
  {
    points->InsertNextPoint(p_W.data());
  }
  return points;
}
} // namespace

vtkSmartPointer<vtkPolyData> makePlane(double size, double tilt)
{
  const double high = tilt * size;
  auto plane = vtkSmartPointer<vtkPolyData>::New();
  plane->SetPoints(
    makePoints({ { -size, -size, -high }, { size, -size, -high }, { size, size, high }, { -size, size, high } }));
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 0, 2, 3 });
  plane->SetPolys(triangles);
  return plane;
}

vtkSmartPointer<vtkPolyData> makeSphere(double radius, int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> makeSoftBlock(double side, double unit_m)
{
  TetraMesh mesh = test::blockOf({ 4, 4, 2 }, { side, side, 0.5 * side });
  for (Vec3& p : mesh.vertices_W)
  {
    p -= 0.5 * Vec3::Constant(side);
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(makePoints(mesh.vertices_W));
  for (const Tetra& t : mesh.tetras)
  {
    const vtkIdType corners[4] = { t[0], t[1], t[2], t[3] };
    grid->InsertNextCell(VTK_TETRA, 4, corners);
  }
  vtkNew<vtkHapticSoftBody> body;
  body->SetInputData(grid);
  body->SetUnit(unit_m);
  body->SetFixed("zmin");
  body->SetModel(vtkHapticSoftBody::Linear);
  body->Update();
  return body->GetOutput();
}

vtkSmartPointer<vtkPolyData> makePath(const std::vector<Vec3>& points_W)
{
  auto path = vtkSmartPointer<vtkPolyData>::New();
  path->SetPoints(makePoints(points_W));
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(points_W.size()));
  for (std::size_t i = 0; i < points_W.size(); ++i)
  {
    line->InsertCellPoint(static_cast<vtkIdType>(i));
  }
  path->SetLines(line);
  return path;
}

double enclosedVolume(const TriangleMesh& mesh)
{
  double volume = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    volume += mesh.vertices_W[a].cross(mesh.vertices_W[b]).dot(mesh.vertices_W[c]) / 6.0;
  }
  return volume;
}

std::vector<std::string> errorsOf(vtkObject* object, const std::function<void()>& change)
{
  std::vector<std::string> errors;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&errors);
  listener->SetCallback([](vtkObject*, unsigned long, void* list, void* text)
    { static_cast<std::vector<std::string>*>(list)->emplace_back(static_cast<const char*>(text)); });
  const unsigned long tag = object->AddObserver(vtkCommand::ErrorEvent, listener);
  change();
  object->RemoveObserver(tag);
  return errors;
}

std::vector<std::string> errorsOf(vtkAlgorithm* algorithm)
{
  std::vector<std::string> executives; // which reports the algorithm's errors of before
  std::vector<std::string> errors = errorsOf(algorithm,
    [&] { executives = errorsOf(static_cast<vtkObject*>(algorithm->GetExecutive()), [&] { algorithm->Update(); }); });
  errors.insert(errors.end(), executives.begin(), executives.end());
  return errors;
}

} // namespace palpate::testing
