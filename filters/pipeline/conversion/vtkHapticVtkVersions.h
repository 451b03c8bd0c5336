// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All that the releases of VTK which Palpate is built with have under different names, or kept differently: VTK 9.2 of
// ParaView 5.11, 9.3.20240617 of 5.13, 9.6 of 6.1.

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkStructuredData.h"
#include "vtkUniformGrid.h"
#include "vtkUniformGridAMR.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <vector>

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
#include "vtkCellTypeUtilities.h"
#else
#include "vtkCellTypes.h"
#endif

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
inline constexpr int vtkHapticThreeAxes = vtkStructuredData::VTK_STRUCTURED_XYZ_GRID;
#else
inline constexpr int vtkHapticThreeAxes = VTK_XYZ_GRID;
#endif

/// The type of each cell; null without cells.
inline vtkDataArray* vtkHapticCellTypes(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return grid->GetCellTypes();
#else
  return grid->GetCellTypesArray();
#endif
}

/// 0 to 3; -1: VTK has no such type.
inline int vtkHapticCellDimension(unsigned char type)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return vtkCellTypeUtilities::GetDimension(type);
#else
  return vtkCellTypes::GetDimension(type);
#endif
}

inline unsigned vtkHapticNumberOfGrids(vtkUniformGridAMR& levels, unsigned level)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return levels.GetNumberOfBlocks(level);
#else
  return levels.GetNumberOfDataSets(level);
#endif
}

/// Names the number of grids of each level, which lie along three axes.
inline void vtkHapticSizeLevels(vtkOverlappingAMR& levels, const std::vector<unsigned int>& grids)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  levels.Initialize(grids);
#else
  levels.Initialize(static_cast<int>(grids.size()), std::vector<int>(grids.begin(), grids.end()).data());
#endif
  levels.SetGridDescription(vtkHapticThreeAxes);
}

/// Null where a level has a hole.
inline vtkDataObject* vtkHapticGridOf(vtkUniformGridAMR& levels, unsigned level, unsigned grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return levels.GetDataSetAsImageData(level, grid);
#else
  return levels.GetDataSet(level, grid);
#endif
}

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240617)
/// The faces of the polyhedra of a grid, which may be broken: cells of one array, named by those of another one.
class vtkHapticPolyhedra
{
public:
  explicit vtkHapticPolyhedra(vtkUnstructuredGrid* grid)
    : Faces(grid->GetPolyhedronFaces()), Places(grid->GetPolyhedronFaceLocations()), Points(grid->GetNumberOfPoints()),
      Sound(this->Faces && this->Places && this->Faces->IsValid() && this->Places->IsValid())
  {
  }

  /// Whether each face of a polyhedron names points of the grid.
  bool IsValid(vtkIdType cell)
  {
    return this->Sound && cell < this->Places->GetNumberOfCells() &&
           this->AllOf(this->Places, cell, this->OfCell,
             [this](vtkIdType face)
             {
               return face >= 0 && face < this->Faces->GetNumberOfCells() && this->Faces->GetCellSize(face) > 0 &&
                      this->AllOf(this->Faces, face, this->OfFace,
                        [this](vtkIdType point) { return point >= 0 && point < this->Points; });
             });
  }

private:
  template<class Holds>
  static bool AllOf(vtkCellArray* lists, vtkIdType list, vtkIdList* ids, Holds holds)
  {
    lists->GetCellAtId(list, ids);
    bool all = true;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      all = all && holds(ids->GetId(i));
    }
    return all;
  }

  vtkCellArray* Faces;
  vtkCellArray* Places;
  vtkIdType Points;
  bool Sound;
  vtkNew<vtkIdList> OfCell, OfFace;
};
#else
/// The faces of the polyhedra of a grid, which may be broken: [number of faces, {number of points, points...}...] at
/// the place of each in one array.
class vtkHapticPolyhedra
{
public:
  explicit vtkHapticPolyhedra(vtkUnstructuredGrid* grid)
    : Faces(grid->GetFaces()), Places(grid->GetFaceLocations()), Points(grid->GetNumberOfPoints())
  {
  }

  /// Whether each face of a polyhedron names points of the grid.
  bool IsValid(vtkIdType cell)
  {
    if (!this->Faces || !this->Places || cell >= this->Places->GetNumberOfTuples())
    {
      return false;
    }
    const vtkIdType at = this->Places->GetValue(cell);
    const vtkIdType size = this->Faces->GetNumberOfTuples();
    if (at < 0 || at >= size)
    {
      return false;
    }
    vtkIdType next = at + 1;
    for (vtkIdType left = this->Faces->GetValue(at); left > 0; --left)
    {
      const vtkIdType corners = next < size ? this->Faces->GetValue(next) : -1;
      if (corners < 1 || corners > size - next - 1 || !this->ArePoints(next + 1, next + corners))
      {
        return false;
      }
      next += corners + 1;
    }
    return true;
  }

private:
  [[nodiscard]] bool ArePoints(vtkIdType first, vtkIdType last) const
  {
    bool all = true;
    for (vtkIdType i = first; i <= last; ++i)
    {
      all = all && this->Faces->GetValue(i) >= 0 && this->Faces->GetValue(i) < this->Points;
    }
    return all;
  }

  vtkIdTypeArray* Faces;
  vtkIdTypeArray* Places;
  vtkIdType Points;
};
#endif
