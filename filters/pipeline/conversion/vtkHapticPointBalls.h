// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPointBalls_h
#define vtkHapticPointBalls_h

#include <cstddef>

#include "vtkHapticConversion.h"
#include "vtkMultiBlockDataSet.h" // for vtkSmartPointer<vtkMultiBlockDataSet>

/// The points of a cloud as balls: a segment each that is a millionth of the radius long, which as a tube of that
/// radius [u] is a ball to that share. Of poly data the points of its vertex cells; placed as vtkHapticToMesh() does;
/// the radius is in W. Points that are not finite are left to cleaning. PartPoints are those of vtkHapticBallArrays().
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticConversionResult vtkHapticToBalls(
  vtkDataObject* data, vtkMatrix4x4* matrix, double radius_u);

/// The points of these balls, both ends of each segment, with the arrays of their points and vertex cells, for
/// vtkHapticToMaterial().
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkMultiBlockDataSet> vtkHapticBallArrays(vtkDataObject* data);

/// Points of vertex cells in the poly data of a data object.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::size_t vtkHapticCountPoints(vtkDataObject* data);

#endif
