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

  /// Length of tick i [s]: the time since the tick before; the first is as long as the second.
  [[nodiscard]] double Duration(std::size_t i) const
  {
    const std::size_t after = i > 0 ? i : 1;
    return this->Times.size() > 1 ? this->Times[after] - this->Times[after - 1] : 1e-3;
  }
};

/// Points in the order of the only polyline, or all points in their order when there are no lines. Times from the point
/// array `timeArray` (null or "": i / rate).
[[nodiscard]] vtkHapticHandPath vtkHapticReadHandPath(vtkPolyData* path, const char* timeArray, double rate);

#endif
