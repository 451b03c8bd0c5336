// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFieldData_h
#define vtkHapticFieldData_h

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "haptics/session/scene/FeltField.h"
#include "vtkHapticPipelineModule.h" // for the export macro

class vtkDataObject;
class vtkDataSet;

/// Which arrays of a data set are felt, by name; "": none.
struct vtkHapticFieldArrays
{
  std::string Scalar;
  std::string Vector; ///< three components, or the 6 or 9 of a symmetric tensor
  std::string Resistance;
  std::string Other;   ///< compared with the scalar
  int Component = -1;  ///< of the scalar, where it has several; -1: their length
  int Eigenvector = 0; ///< of a tensor: of its largest, middle or least eigenvalue
  bool Tensor = false; ///< Vector is one: vtkHapticToField() sees to it
  bool Beside = false; ///< Other is an array of other data: it does too
  double Offset = 0.0; ///< that the scalar, and Other, are less in a block: it does too
  int Smoothing = -1;  ///< passes over the scalar (haptics/field/Smoothing.h); -1: one where its noise traps a hand

  /// Whether there is anything to feel.
  bool Any() const { return !this->Scalar.empty() || !this->Vector.empty() || !this->Resistance.empty(); }
  friend bool operator==(const vtkHapticFieldArrays&, const vtkHapticFieldArrays&) = default;
};

/// Other data that have to do with a field; null: there are none.
struct vtkHapticComparedField
{
  vtkDataObject* Compared = nullptr; ///< whose array Other is; without a name the one that is called as the scalar
  vtkDataObject* Snap = nullptr;     ///< whose points and lines the hand snaps to
};

struct vtkHapticFieldResult
{
  std::shared_ptr<const palpate::FieldSource> Source; ///< null: it cannot be felt as a field
  std::string Problem;                                ///< why
  palpate::FieldEnds Ends{ 1.0, 0.0 };                ///< of the scalar
  std::array<double, 6> Bounds{};                     ///< low and high x, y, z of all data [u]
};

/// A data set as a field: the voxels of an image as they are, also turned, mirrored and of uneven spacing; every other
/// data set, composite ones and clouds of points too, on a lattice of half the length of its cells: tetrahedra
/// scan-converted, others by VTK's own probes. Values of cells go to points first. Blanked, ghost and empty places have
/// no value. `data` is copied shallowly and then read by the worker thread.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticFieldResult vtkHapticToField(
  vtkDataObject* data, const vtkHapticFieldArrays& arrays, const vtkHapticComparedField& beside = {});

/// The box of all data sets in it, low and high x, y, z [u]; low above high where there are no points.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::array<double, 6> vtkHapticFieldBounds(vtkDataObject* data);

/// Least and largest finite value of an array in any of the data sets in it, of several components their lengths;
/// turned round where it has none or is a tensor.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT palpate::FieldEnds vtkHapticFieldEnds(
  vtkDataObject* data, const std::string& name);

/// The data sets in a data object.
VTKHAPTICPIPELINE_EXPORT std::vector<vtkDataSet*> vtkHapticFieldSets(vtkDataObject* data);

/// Names of the arrays of numbers that a data set has at points or cells, those of `components` alone; 0: all. With 3,
/// for fields that are followed, symmetric tensors of 6 and 9 as well.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::vector<std::string> vtkHapticFieldArrayNames(
  vtkDataObject* data, int components = 0);

/// Whether an array of that many is one of those names.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticFitsComponents(int has, int components);

#endif
