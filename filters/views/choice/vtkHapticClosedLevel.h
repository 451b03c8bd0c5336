// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticClosedLevel_h
#define vtkHapticClosedLevel_h

#include <string>

class vtkDataObject;

/**
 * A level of an array of points whose isosurface a hand can come to from outside.
 *
 * Where more than a fiftieth of the points at the border of the data are above `level`, its isosurface is open there, and
 * a hand that comes from outside is behind the surface before it has met it. The level is then halfway between the
 * highest value at the border and the highest of all, if these differ by a twentieth of the range at least. `level`
 * itself: its isosurface is closed enough, or none would be, or the data are no grid of points along three axes.
 */
[[nodiscard]] double vtkHapticClosedLevel(vtkDataObject* data, const std::string& array, double level);

#endif
