// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliPath_h
#define vtkHapticCliPath_h

#include <string>
#include <vector>

#include "haptics/session/path/PathInputs.h"

/// Reads PATH.csv: a header with t, x, y, z [s, scene units] and, all or none of them, qw, qx, qy, qz, in any order;
/// then one line of finite numbers per tick, t growing from line to line.
/// Throws vtkHapticCliProblem naming file, line and reason; never skips a line or a column. `turned`: it must give
/// orientations.
[[nodiscard]] std::vector<palpate::PathSample> vtkHapticCliReadPath(const std::string& file, bool turned = false);

/// Throws vtkHapticCliProblem for a row that is not in the plane z = 0: a hand elsewhere would feel something else.
void vtkHapticCliCheckPlanePath(const std::string& file, const std::vector<palpate::PathSample>& path);

#endif
