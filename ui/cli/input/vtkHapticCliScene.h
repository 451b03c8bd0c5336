// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliScene_h
#define vtkHapticCliScene_h

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/geometry/scene/Scene.h"
#include "haptics/session/scene/TouchedData.h"
#include "vtkHapticMaterialArrays.h"

/// What a file gives.
struct vtkHapticCliSurface
{
  palpate::SurfaceInput Input; ///< as the scene builder takes it, named after the file [scene units]
  std::shared_ptr<const palpate::TriangleMesh> Lines; ///< segments of its curves, if they were asked for
  vtkHapticMaterialResult Material;                   ///< of its arrays; Input.fields are its fields
  vtkHapticMaterialResult LineMaterial;               ///< of the arrays of its curves
};

/// Throws vtkHapticCliProblem. What a reader had to say besides goes to stderr. An array that cannot be used is a
/// problem of the result: the caller knows whether it must be there. `lines`: curves are wanted too, and a file of
/// nothing else has no Input.mesh.
[[nodiscard]] vtkHapticCliSurface vtkHapticCliReadSurface(const std::string& file, std::optional<double> iso,
  const vtkHapticMaterialSettings& materials = {}, bool lines = false);

/// The scene of several files, in their order; `iso` is for the images among them. Throws vtkHapticCliProblem when a
/// file cannot be read or touched, or an array cannot be used in any of them; what cleaning dropped from the others and
/// what their arrays give goes to stderr. Stiffness in the scene is in newtons per metre times 1 / scale, that is per
/// scene unit. Lines are tubes of that radius [scene units]; 0: they are not touched.
[[nodiscard]] std::shared_ptr<const palpate::Scene> vtkHapticCliBuildScene(const std::vector<std::string>& files,
  std::optional<double> iso, const vtkHapticMaterialSettings& materials = {}, double scale_u_per_m = 1.0,
  double lineRadius_u = 0.0);

/// Curves as tubes of that radius [scene units], named after their file, with their material.
[[nodiscard]] palpate::SurfaceInput vtkHapticCliTubesOf(
  const std::string& file, const vtkHapticCliSurface& surface, double lineRadius_u);

/// Throws vtkHapticCliProblem that names what cannot be touched.
void vtkHapticCliCheckWhole(const palpate::WholeScene& whole);

/// The scene of surfaces as they were read. Throws vtkHapticCliProblem that names what cannot be touched; what cleaning
/// dropped goes to stderr.
[[nodiscard]] std::shared_ptr<const palpate::Scene> vtkHapticCliBuild(const std::vector<palpate::SurfaceInput>& inputs);

#endif
