// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCellBins_h
#define vtkHapticCellBins_h

#include <cstdint>
#include <functional>
#include <vector>

#include "vtkBoundingBox.h"
#include "vtkType.h"

class vtkPolyData;

/**
 * Which polygons and strips of a surface may reach into a box, among as many as fit the memory: six bytes a cell.
 *
 * A cell is in the one bin of a grid that the middle of its box is in, and each bin knows the box around all of its
 * cells: a cell that is larger than a bin makes that box larger and is found all the same.
 */
class vtkHapticCellBins
{
public:
  vtkHapticCellBins() = default;
  /// Of fewer than 2^32 cells. The surface must outlive it, unchanged.
  explicit vtkHapticCellBins(vtkPolyData* surface);

  [[nodiscard]] vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Cells.size()); }
  [[nodiscard]] const vtkBoundingBox& GetBounds() const { return this->Bounds; }

  using Visit = std::function<void(std::uint32_t cell)>;
  /// Calls visit(cell) for each whose box meets that one, polygons first, then strips: 0 is the first polygon.
  void ForEachWithin(const vtkBoundingBox& box, const Visit& visit) const;

private:
  [[nodiscard]] vtkBoundingBox BoxOf(std::uint32_t cell) const;
  [[nodiscard]] std::size_t BinOf(const vtkBoundingBox& box) const;
  void LayGrid();

  vtkPolyData* Surface = nullptr;
  vtkBoundingBox Bounds;
  int Size[3] = { 1, 1, 1 };
  std::vector<vtkBoundingBox> Boxes; ///< one a bin
  std::vector<std::size_t> First;    ///< of a bin among the cells, and the end of the last
  std::vector<std::uint32_t> Cells;
};

#endif
