// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticTetraField_h
#define vtkHapticTetraField_h

#include <map>
#include <string>

#include "haptics/field/build/Rasteriser.h"
#include "vtkHapticCellSizes.h"
#include "vtkHapticFieldWindow.h"
#include "vtkHapticLevelScan.h"
#include "vtkHapticOwnCells.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

/// Whether all cells that fill space are tetrahedra of four points, and all arrays that are asked for are at points:
/// then no probe is needed, which is hundreds of times slower.
bool vtkHapticIsTetraField(vtkDataObject* data, const vtkHapticFieldArrays& arrays);

/// A mesh of tetrahedra, scan-converted near the hand.
class vtkHapticTetraField : public palpate::FieldSource
{
public:
  vtkHapticTetraField(
    vtkSmartPointer<vtkUnstructuredGrid> data, vtkHapticFieldArrays arrays, const palpate::FieldBlockGrid& lattice);

  palpate::MadeFieldBlock brickAround(const palpate::FieldBlockWish& wish) const override;

private:
  /// The mesh as the core takes it; made by the worker, with the first block.
  struct Mesh
  {
    std::vector<palpate::Vec3> Points_W;
    std::vector<palpate::Tetrahedron> Tetrahedra;
    std::unique_ptr<palpate::TetraBins> Bins;
    std::map<palpate::FieldBlockRole, std::vector<float>> Values;
    std::unique_ptr<vtkHapticCellSizes> Sizes;
    std::unique_ptr<const vtkHapticOwnCells> Own;
    std::string WhyNoCells; ///< "": there are some, or the lattice tells the same
  };
  Mesh MakeMesh() const;
  std::vector<float> ValuesOf(const vtkHapticFieldPart& part) const;

  vtkSmartPointer<vtkUnstructuredGrid> Data;
  vtkHapticFieldArrays Arrays;
  palpate::FieldBlockGrid Lattice;
  mutable std::unique_ptr<const Mesh> Made; ///< asked for by one thread at a time
  vtkHapticLevelScan Levels;
};

#endif
