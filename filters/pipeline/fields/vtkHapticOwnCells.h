// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticOwnCells_h
#define vtkHapticOwnCells_h

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "haptics/field/cells/FieldCells.h"
#include "vtkHapticFieldWindow.h"
#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkDataSet;

/// The cells of data themselves, those near a hand at a time: tetrahedra, pyramids, wedges, hexahedra and voxels. A
/// lattice has one spacing; cells of a boundary layer are short across it and long along it, and turn with it.
class vtkHapticOwnCells
{
public:
  /// Memory of those that are handed out at a time, and how many cells data may have.
  static constexpr std::size_t mostBytes = palpate::FieldBlock::mostBytes / 2;
  static constexpr std::size_t mostCells = 4'000'000;

  /// Null where the scalar of data cannot be had by its cells; `why` becomes the reason. Null too where there is no
  /// scalar, or where a lattice of that spacing resolves the cells: more of them than are handed out at a time, none of
  /// which is flat, hidden or without a value.
  static std::unique_ptr<const vtkHapticOwnCells> Of(
    vtkDataObject* data, const vtkHapticFieldArrays& arrays, const palpate::FieldBlockGrid& lattice, std::string& why);

  /// Whether some are flat: a lattice of the mean cell takes their detail for noise.
  bool AreFlat() const { return this->Flat; }

  /// Those that are nearest to a place.
  std::shared_ptr<const palpate::FieldCells> Around(const palpate::Vec3& centre_W) const;

private:
  struct Cell
  {
    std::uint32_t Part;
    std::uint32_t Id;
  };
  using Box = std::array<float, 6>; ///< low and high x, y, z, rounded outwards

  std::string Add(vtkDataSet* part, const vtkHapticFieldPart& scalar);
  palpate::CellCorners CornersOf(const Cell& cell) const;
  palpate::Vec3 PointOf(std::uint32_t point) const;
  bool IsLevel(double edge_u) const;
  std::shared_ptr<const palpate::FieldCells> Make(
    const std::vector<std::uint32_t>& cells, const palpate::Vec3& centre_W, double reach_u) const;

  std::vector<vtkSmartPointer<vtkDataSet>> Parts;
  std::vector<std::uint32_t> FirstPoint; ///< of each part in Values, and the end
  std::vector<float> Values;
  std::vector<Cell> Cells;
  std::vector<Box> Boxes;
  double Offset = 0.0;
  bool Flat = false;
  bool Holes = false;                                     ///< cells are hidden, or points have no value
  mutable std::vector<std::uint32_t> Local;               ///< of each point; asked for by one thread at a time
  mutable std::shared_ptr<const palpate::FieldCells> All; ///< where that is all of them
};

#endif
