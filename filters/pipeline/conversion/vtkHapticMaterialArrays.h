// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticMaterialArrays_h
#define vtkHapticMaterialArrays_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "haptics/geometry/mesh/Material.h"
#include "vtkHapticPipelineModule.h" // for the export macro

class vtkDataObject;

/// From the values of an array to something felt: a line through two points, level beyond both.
struct vtkHapticTransfer
{
  std::string Array;                           ///< of points or else of cells; empty: no array
  int Component = -1;                          ///< -1: the length of a vector; of a scalar its value
  std::array<double, 2> DataRange{ 0.0, 0.0 }; ///< equal ends: the array's own range
  std::array<double, 2> FeltRange{ 0.0, 1.0 }; ///< the values at its first and second end

  /// Of one value; NaN where that is not finite. `range`: the data range that is used.
  [[nodiscard]] double Felt(double value, const std::array<double, 2>& range) const;
  friend bool operator==(const vtkHapticTransfer&, const vtkHapticTransfer&) = default;
};

/// Arrays of a surface that set its material.
struct VTKHAPTICPIPELINE_EXPORT vtkHapticMaterialSettings
{
  vtkHapticTransfer Stiffness{ {}, -1, { 0.0, 0.0 }, { 50.0, 500.0 } }; ///< to [N/m]
  vtkHapticTransfer Friction{ {}, -1, { 0.0, 0.0 }, { 0.0, 1.0 } };     ///< to [1], at rest and sliding alike
  vtkHapticTransfer Texture{ {}, -1, { 0.0, 0.0 }, { 0.0, 1.0 } };      ///< to a height [u], felt from the largest down

  [[nodiscard]] bool Empty() const;
  /// Empty, or one sentence that names the range that cannot be used.
  [[nodiscard]] std::string Check() const;
  friend bool operator==(const vtkHapticMaterialSettings&, const vtkHapticMaterialSettings&) = default;
};

/// The material from a surface's arrays.
struct vtkHapticMaterialResult
{
  std::shared_ptr<const palpate::MaterialFields> Fields; ///< null when no array could be used
  std::string Note;    ///< for a report: the result of each array and its number of unusable values
  std::string Problem; ///< one line without a name in front: the first array that could not be used; else empty
};

/// Values for each vertex of a mesh that vtkHapticToMesh() made of `data`; `partPoints` as it gave them.
///
/// The transfer is applied at the vertices; values between them are interpolated. Point arrays go to the vertices
/// as they are. A cell array goes to them as the mean of the cells around a point, all counting the same. A value that
/// is not finite is left NaN: there the surface's own value is felt. Where a block of composite data has no such array
/// the same holds for all of it.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticMaterialResult vtkHapticToMaterial(
  vtkDataObject* data, const std::vector<std::size_t>& partPoints, const vtkHapticMaterialSettings& settings);

/// Names of the arrays of points and cells that hold numbers, each once, sorted; not VTK's own bookkeeping ("vtk...").
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::vector<std::string> vtkHapticArrayNames(vtkDataObject* data);

/// Names the contents of all arrays of a data object that settings may name: another key if any has changed.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::uint64_t vtkHapticArraysKey(vtkDataObject* data);

#endif
