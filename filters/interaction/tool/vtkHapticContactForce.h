// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticContactForce_h
#define vtkHapticContactForce_h

#include "haptics/tick/base/HapticState.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
class Scene;
struct MechanismInputs;
} // namespace palpate

class vtkPolyData;

/// A force at a contact, friction with it where a mechanism has solved it.
struct vtkHapticContactForce
{
  palpate::Vec3 At_W;    ///< [u]
  palpate::Vec3 Force_N; ///< on the tool before limits, as seen in the scene [N]
  std::string Touched;   ///< name of the surface or soft body that presses; "bone on liver" where the tool is neither
};

/// The contacts at which a tool is pressed by the surfaces of a scene: each along its normal [N].
std::vector<vtkHapticContactForce> vtkHapticToolForces(
  const palpate::HapticState& state, const palpate::Scene& scene, double scale_u_per_m);

/// The contacts of a mechanism that were found.
std::vector<vtkHapticContactForce> vtkHapticFoundForces(
  const palpate::MechanismNow& now, const palpate::MechanismInputs& inputs);

/// A point a contact, with the arrays Force (3 components) [N], Touched (string) and Pair (int): one number for each
/// name, in the order in which they come.
void vtkHapticPutForces(const std::vector<vtkHapticContactForce>& forces, vtkPolyData& points);

#endif
