// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "haptics/core/Outcome.h"
#include "haptics/session/mechanism/MechanismBodies.h"

namespace palpate
{

struct TriangleMesh;

/// The mechanism of a rigid mesh in the hand that presses a soft body, among surfaces that both touch, standing or
/// loose (SurfacesBeside): contacts are found, with Coulomb's `friction` where a surface has none of its own, and
/// nothing else joins them. `mesh_H`: in the frame of the hand [u]. `body`: without an input there is none, and a unit
/// is `unit_m` metres. A tool or a surface that has the name of another body is called otherwise there. Refuses in one
/// sentence a mesh that cannot be held (makeRigidMesh()). Takes milliseconds where the mesh is large; not real-time
/// safe.
[[nodiscard]] Outcome<std::shared_ptr<const MechanismInputs>> toolOnBody(const std::string& tool,
  const TriangleMesh& mesh_H, const MechanismSoftInput& body, double friction,
  const std::vector<MechanismBody>& beside = {}, double unit_m = 1.0);

/// The refusal of such a mechanism, which names one of its bodies, with the remedy where that is a loose one: of the
/// right mass and size it passes no limit, so its unit is another one. `remedy`: the way to choose the unit.
[[nodiscard]] std::string withUnitTaken(
  const std::string& refusal, const MechanismInputs& inputs, const std::string& remedy);

} // namespace palpate
