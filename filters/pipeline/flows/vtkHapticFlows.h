// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFlows_h
#define vtkHapticFlows_h

#include <array>

#include "haptics/core/Types.h"
#include "vtkHapticPipelineModule.h" // for the export macro

/// A flow that is known everywhere by a formula.
struct vtkHapticFlow
{
  const char* Name;
  palpate::Vec3 Low, High;                                          ///< box that it is shown in [u]
  palpate::Vec3 (*Velocity)(const palpate::Vec3& p_W, double time); ///< [u/s]
  double Duration = 0.0;                                            ///< after which it comes again [s]; 0: it is steady
};

namespace vtkHapticFlows
{
/// Arnold, Beltrami, Childress: chaotic streamlines; A = sqrt 3, B = sqrt 2, C = 1 (Dombre et al. 1986).
/// Taylor-Green: eight cells that turn against each other (Taylor & Green 1937, at its beginning).
/// Lamb-Oseen: one vortex round the z axis whose core of radius 1 turns like a solid body; circulation 2 pi.
/// Double gyre: two that swing against each other in 10 s; 0.1, 0.25 (Shadden, Lekien & Marsden 2005).
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT const std::array<vtkHapticFlow, 4>& All();
} // namespace vtkHapticFlows

#endif
