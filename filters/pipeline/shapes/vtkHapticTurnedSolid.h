// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticTurnedSolid_h
#define vtkHapticTurnedSolid_h

#include <functional>
#include <vector>

class vtkPolyData;

/// A closed line about the z axis at one height: its distance from the axis [u] at each angle [rad].
struct vtkHapticRing
{
  double Height = 0.0;
  std::function<double(double angle)> Radius;
};

/// Triangles between each ring and the next, `around` corners a ring, that face outward when the rings run
/// counter-clockwise as seen with the axis to the left and up ahead. `bore`: the last ring leads back to the first, as
/// round a hole; else the first and the last are closed by fans to the axis.
void vtkHapticTurnSolid(const std::vector<vtkHapticRing>& rings, int around, bool bore, vtkPolyData* solid);

#endif
