// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <vtkCellArray.h>
#include <vtkCellLocator.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include "testing/lab/backends/Backend.h"

namespace palpate::lab
{
namespace
{

void fill(vtkPolyData& surface, const TriangleMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& v : mesh.vertices_W)
  {
    points->InsertNextPoint(v.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    cells->InsertNextCell({ a, b, c });
  }
  surface.SetPoints(points);
  surface.SetPolys(cells);
}

template<class Locator>
class VtkLocator final : public Backend
{
public:
  explicit VtkLocator(const TriangleMesh& mesh)
  {
    fill(*this->surface_, mesh);
    this->locator_->SetDataSet(this->surface_);
    this->locator_->BuildLocator();
  }

  [[nodiscard]] bool meets(const Vec3& from_W, const Vec3& to_W) override
  {
    return this->firstHit(from_W, to_W).has_value();
  }

  [[nodiscard]] std::optional<double> firstHit(const Vec3& from_W, const Vec3& to_W) override
  {
    double t = 0.0, x[3], coordinates[3];
    int part = 0;
    vtkIdType cell = -1;
    const int hit =
      this->locator_->IntersectWithLine(from_W.data(), to_W.data(), 0.0, t, x, coordinates, part, cell, this->cell_);
    return hit != 0 ? std::optional(t) : std::nullopt;
  }

  [[nodiscard]] std::optional<double> distance_u(const Vec3& p_W) override
  {
    double x[3], distance2 = 0.0;
    int part = 0;
    vtkIdType cell = -1;
    this->locator_->FindClosestPoint(p_W.data(), x, this->cell_, cell, part, distance2);
    return std::sqrt(distance2);
  }

private:
  vtkNew<vtkPolyData> surface_;
  vtkNew<Locator> locator_;
  vtkNew<vtkGenericCell> cell_;
};

} // namespace

std::unique_ptr<Backend> makeVtkStaticCellLocator(const TriangleMesh& mesh)
{
  return std::make_unique<VtkLocator<vtkStaticCellLocator>>(mesh);
}

std::unique_ptr<Backend> makeVtkCellLocator(const TriangleMesh& mesh)
{
  return std::make_unique<VtkLocator<vtkCellLocator>>(mesh);
}

} // namespace palpate::lab
