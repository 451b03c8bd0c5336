// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliScene_h
#define vtkHapticCliScene_h

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/geometry/Scene.h"
#include "haptics/geometry/SceneBuilder.h"

/// The surface of one file as the scene builder takes it, named after the file [scene units].
/// Throws vtkHapticCliProblem. What a reader had to say besides goes to stderr.
[[nodiscard]] palpate::SurfaceInput vtkHapticCliReadSurface(const std::string& file, std::optional<double> iso);

/// The scene of several files, in their order; `iso` is for the images among them. Throws vtkHapticCliProblem when a
/// file cannot be read or touched; what cleaning dropped from the others goes to stderr.
[[nodiscard]] std::shared_ptr<const palpate::Scene> vtkHapticCliBuildScene(
  const std::vector<std::string>& files, std::optional<double> iso);

#endif
