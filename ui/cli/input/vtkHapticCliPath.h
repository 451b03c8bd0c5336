// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliPath_h
#define vtkHapticCliPath_h

#include <string>
#include <vector>

#include "haptics/core/Types.h"

/// One row of a path: where the hand is at a time.
struct vtkHapticCliPathRow
{
  double Time_s = 0.0;
  palpate::Pose Pose_W; ///< position [scene units]; the identity where the file gives no orientation
};

/// Reads PATH.csv: a header with t, x, y, z [s, scene units] and, all or none of them, qw, qx, qy, qz, in any order;
/// then one line of finite numbers per tick, t growing from line to line.
/// Throws vtkHapticCliProblem naming file, line and reason; never skips a line or a column. `turned`: it must give
/// orientations.
[[nodiscard]] std::vector<vtkHapticCliPathRow> vtkHapticCliReadPath(const std::string& file, bool turned = false);

#endif
