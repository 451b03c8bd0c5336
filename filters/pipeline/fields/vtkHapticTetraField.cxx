// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticTetraField.h"

#include <algorithm>
#include <utility>

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkHapticFieldError.h"
#include "vtkHapticFinerField.h"
#include "vtkHapticImageField.h"
#include "vtkHapticVtkVersions.h"
#include "vtkPointData.h"

using palpate::Vec3;

namespace
{
bool FillsSpace(unsigned char type)
{
  return vtkHapticCellDimension(type) == 3;
}
} // namespace

bool vtkHapticIsTetraField(vtkDataObject* data, const vtkHapticFieldArrays& arrays)
{
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (!grid || arrays.Tensor || grid->GetCellGhostArray() || !vtkHapticAllAtPoints(*grid, arrays))
  {
    return false;
  }
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const auto type = static_cast<unsigned char>(grid->GetCellType(i));
    if (FillsSpace(type) && type != VTK_TETRA)
    {
      return false;
    }
  }
  return true;
}

vtkHapticTetraField::vtkHapticTetraField(
  vtkSmartPointer<vtkUnstructuredGrid> data, vtkHapticFieldArrays arrays, const palpate::FieldBlockGrid& lattice)
  : Data(std::move(data)), Arrays(std::move(arrays)), Lattice(lattice)
{
}

vtkHapticTetraField::Mesh vtkHapticTetraField::MakeMesh() const
{
  Mesh mesh;
  mesh.Points_W.resize(static_cast<std::size_t>(this->Data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.Points_W.size(); ++i)
  {
    this->Data->GetPoint(static_cast<vtkIdType>(i), mesh.Points_W[i].data());
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < this->Data->GetNumberOfCells(); ++i)
  {
    if (this->Data->GetCellType(i) == VTK_TETRA)
    {
      this->Data->GetCellPoints(i, corners);
      palpate::Tetrahedron tetrahedron;
      std::transform(corners->begin(), corners->end(), tetrahedron.begin(),
        [](vtkIdType id) { return static_cast<std::uint32_t>(id); });
      mesh.Tetrahedra.push_back(tetrahedron);
    }
  }
  mesh.Bins = std::make_unique<palpate::TetraBins>(mesh.Points_W, mesh.Tetrahedra);
  for (const vtkHapticFieldPart& part : vtkHapticFieldParts(this->Arrays))
  {
    mesh.Values[part.Role] = this->ValuesOf(part);
  }
  mesh.Sizes =
    std::make_unique<vtkHapticCellSizes>(std::vector<vtkDataSet*>{ this->Data }, vtkHapticFieldBounds(this->Data));
  mesh.Own = vtkHapticOwnCells::Of(this->Data, this->Arrays, this->Lattice, mesh.WhyNoCells);
  return mesh;
}

std::vector<float> vtkHapticTetraField::ValuesOf(const vtkHapticFieldPart& part) const
{
  const vtkIdType points = this->Data->GetNumberOfPoints();
  std::vector<float> values(static_cast<std::size_t>(points * palpate::componentsOf(part.Role)));
  vtkDataArray* const array = this->Data->GetPointData()->GetArray(part.Name.c_str());
  for (vtkIdType i = 0; i < points; ++i)
  {
    vtkHapticKeepTuple(array, i, part, values);
  }
  return values;
}

palpate::MadeFieldBlock vtkHapticTetraField::brickAround(const palpate::FieldBlockWish& wish) const
{
  if (!this->Made)
  {
    this->Made = std::make_unique<const Mesh>(this->MakeMesh());
  }
  const Mesh& mesh = *this->Made;
  const auto cells = [&mesh](const vtkHapticFieldPart& part, const palpate::FieldBlockGrid& grid)
  {
    const palpate::TetraField field{ mesh.Points_W, mesh.Tetrahedra, mesh.Values.at(part.Role),
      palpate::componentsOf(part.Role) };
    return palpate::rasterise(field, *mesh.Bins, grid);
  };
  palpate::MadeFieldBlock made =
    vtkHapticFieldBlockWithFiner(this->Lattice, this->Arrays, cells, *mesh.Sizes, mesh.Own.get(), wish);
  made.whyNoCells = mesh.WhyNoCells.empty() ? made.whyNoCells : mesh.WhyNoCells;
  made.error = made.brick ? vtkHapticFieldError(
                              made.brick->finestAt(wish.centre_W), vtkHapticFieldParts(this->Arrays).front(), cells)
                          : 0.0;
  this->Levels.Tell(made, wish, this->Lattice, this->Arrays,
    [&](const vtkHapticFieldPart& part, const vtkHapticFieldWindow& window)
    { return cells(part, vtkHapticGridOf(this->Lattice, window)); });
  return made;
}
