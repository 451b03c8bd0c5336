// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/benchmarks/Reference.h"

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

namespace palpate::test
{
namespace
{

class VtkReference final : public Reference
{
public:
  explicit VtkReference(const TriangleMesh& mesh)
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
    this->surface_->SetPoints(points);
    this->surface_->SetPolys(cells);
    this->locator_->SetDataSet(this->surface_);
    this->locator_->BuildLocator();
  }

  [[nodiscard]] const char* name() const override { return "vtkStaticCellLocator IntersectWithLine"; }
  [[nodiscard]] bool meets(const Vec3& from_W, const Vec3& to_W) override
  {
    double t = 0.0, x[3], coordinates[3];
    int part = 0;
    vtkIdType cell = -1;
    return this->locator_->IntersectWithLine(
             from_W.data(), to_W.data(), 0.0, t, x, coordinates, part, cell, this->cell_) != 0;
  }

private:
  vtkNew<vtkPolyData> surface_;
  vtkNew<vtkStaticCellLocator> locator_;
  vtkNew<vtkGenericCell> cell_;
};

} // namespace

std::unique_ptr<Reference> vtkReference(const TriangleMesh& mesh)
{
  return std::make_unique<VtkReference>(mesh);
}

} // namespace palpate::test
