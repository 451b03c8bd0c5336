// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliPlane_h
#define vtkHapticCliPlane_h

#include <memory>
#include <string>
#include <vector>

#include "haptics/geometry/scene/Scene.h"
#include "vtkHapticCliPath.h"
#include "vtkHapticCliScene.h"

/// The lines of a file as walls across the plane z = 0, for discs up to that radius [scene units]. Throws
/// vtkHapticCliProblem for a file with polygons, without lines or with points out of that plane.
[[nodiscard]] palpate::SurfaceInput vtkHapticCliWallsOf(
  const std::string& file, const vtkHapticCliSurface& surface, double radius_u);

/// Plane worlds of several files as one scene. Throws vtkHapticCliProblem.
[[nodiscard]] std::shared_ptr<const palpate::Scene> vtkHapticCliBuildPlane(
  const std::vector<std::string>& files, double radius_u);

/// Throws vtkHapticCliProblem for a row that is not in the plane z = 0: a hand elsewhere would feel something else.
void vtkHapticCliCheckPlanePath(const std::string& file, const std::vector<vtkHapticCliPathRow>& path);

#endif
