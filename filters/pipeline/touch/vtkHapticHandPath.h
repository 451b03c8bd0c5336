// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticHandPath_h
#define vtkHapticHandPath_h

#include <string>
#include <vector>

#include "haptics/core/Types.h"

class vtkPolyData;

/// Where the hand is at which time; one entry a tick.
struct vtkHapticHandPath
{
  std::vector<palpate::Vec3> Points_W; ///< [u]
  std::vector<double> Times;           ///< increasing [s]
  std::string Problem;                 ///< one line; empty when the path can be used

  /// Length of the first tick [s]: that of the second.
  [[nodiscard]] double FirstDuration() const { return this->Times.size() > 1 ? this->Times[1] - this->Times[0] : 1e-3; }
};

/// Points in the order of the only polyline, or all points in their order when there are no lines. Times from the point
/// array `timeArray` (null or "": i / rate).
[[nodiscard]] vtkHapticHandPath vtkHapticReadHandPath(vtkPolyData* path, const char* timeArray, double rate);

#endif
