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
  std::vector<palpate::Quat> Turns;    ///< empty where the path names none
  std::vector<double> Times;           ///< increasing [s]
  std::string Problem;                 ///< one line; empty when the path can be used

  /// With the identity where the path names no turns.
  [[nodiscard]] palpate::Pose Hand(std::size_t row) const
  {
    return { this->Points_W[row], this->Turns.empty() ? palpate::Quat::Identity() : this->Turns[row] };
  }
  /// Length of the first tick [s]: that of the second.
  [[nodiscard]] double FirstDuration() const { return this->Times.size() > 1 ? this->Times[1] - this->Times[0] : 1e-3; }
};

/// Which arrays of the path's points say what; null or "": none.
struct vtkHapticPathArrays
{
  const char* Times = nullptr; ///< [s]; none: i / Rate
  const char* Turns = nullptr; ///< unit quaternions w x y z
  double Rate = 1000.0;        ///< [Hz]
};

/// Points in the order of the only polyline, or all points in their order when there are no lines.
[[nodiscard]] vtkHapticHandPath vtkHapticReadHandPath(vtkPolyData* path, const vtkHapticPathArrays& arrays);

#endif
