// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSurfaceMean_h
#define vtkHapticSurfaceMean_h

class vtkDataArray;
class vtkPolyData;

/// Statistics of a value over a surface, in the unit of the value; all are NaN where there is no value.
struct vtkHapticMean
{
  double Mean = 0.0;
  double RMS = 0.0;     ///< root mean square
  double Maximum = 0.0; ///< at a point of the data
};

/// Statistics of the first component of a point array over the area of the polygons of all ranks. The mean is the
/// integral of the value over the surface, divided by the area; the RMS is the root of the same mean of the square. The
/// value is linear on each triangle, so both are exact for a linear value, and of second order in the size of the
/// triangles for a smooth one. A triangle with a corner whose value is not finite is left out, as is one of a ghost
/// cell. Data without area have the mean over their points. All ranks call.
[[nodiscard]] vtkHapticMean vtkHapticMeanOver(vtkPolyData* surface, vtkDataArray* values);

#endif
