// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticImageField_h
#define vtkHapticImageField_h

#include "vtkHapticFieldWindow.h"
#include "vtkHapticLevelScan.h"
#include "vtkSmartPointer.h"

class vtkDataArray;
class vtkImageData;

/// The voxels of an image, copied as they are: no value between points is made up.
class vtkHapticImageField : public palpate::FieldSource
{
public:
  /// An image of at least two points along each axis, whose arrays are at its points.
  vtkHapticImageField(vtkSmartPointer<vtkImageData> image, vtkHapticFieldArrays arrays);

  palpate::MadeFieldBlock brickAround(const palpate::FieldBlockWish& wish) const override;

private:
  std::vector<float> Read(const vtkHapticFieldPart& part, const vtkHapticFieldWindow& window) const;
  vtkIdType PointId(int i, int j, int k) const;
  bool IsHidden(vtkIdType point) const;

  vtkSmartPointer<vtkImageData> Image;
  vtkHapticFieldArrays Arrays;
  palpate::FieldBlockGrid Lattice;
  bool Mirrored = false;    ///< the lattice counts the first axis backwards: its axes are right-handed
  std::vector<bool> Hidden; ///< points without a value; empty: none is
  vtkHapticLevelScan Levels;
};

/// Writes the part of a point's tuple that a role keeps to the same point of `values`: of a scalar one component or
/// their length, of an axis the eigenvector of a symmetric tensor, as long as its eigenvalue is large.
void vtkHapticKeepTuple(
  vtkDataArray* array, vtkIdType point, const vtkHapticFieldPart& part, std::vector<float>& values);

#endif
