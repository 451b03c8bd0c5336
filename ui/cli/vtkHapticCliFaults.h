// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliFaults_h
#define vtkHapticCliFaults_h

#include <string>

#include "haptics/geometry/measure/SurfaceFaults.h"
#include "vtkHapticJson.h"

/// All of them, by the numbers of the file's points and of its triangles, both from 0 on; polygons and strips count as
/// the triangles they are cut into.
[[nodiscard]] nlohmann::ordered_json vtkHapticCliToJson(
  const palpate::SurfaceFaults& faults, const palpate::TriangleMesh& mesh);

/// How many there are, and the worst of each; "" where there are none.
[[nodiscard]] std::string vtkHapticCliHoles(const palpate::SurfaceFaults& faults);
[[nodiscard]] std::string vtkHapticCliFlipped(const palpate::SurfaceFaults& faults);
[[nodiscard]] std::string vtkHapticCliThin(const palpate::SurfaceFaults& faults);

#endif
