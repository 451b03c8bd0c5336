// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticHandPath_h
#define vtkHapticHandPath_h

#include <string>
#include <vector>

#include "haptics/session/path/PathInputs.h"

class vtkPolyData;

/// The arrays with the times and turns of the path's points; null or "": none.
struct vtkHapticPathArrays
{
  const char* Times = nullptr; ///< increasing [s]; none: i / Rate
  const char* Turns = nullptr; ///< unit quaternions w x y z; none: the hand does not turn
  double Rate = 1000.0;        ///< [Hz]
};

/// Points in the order of the only polyline, or all points in their order when there are no lines; one sample a point.
/// None with a problem of one line.
[[nodiscard]] std::vector<palpate::PathSample> vtkHapticReadHandPath(
  vtkPolyData& path, const vtkHapticPathArrays& arrays, std::string& problem);

#endif
