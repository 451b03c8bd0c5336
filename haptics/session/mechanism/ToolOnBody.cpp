// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/ToolOnBody.h"

#include <utility>

#include "haptics/mechanism/found/SidedSurface.h"

namespace palpate
{

Outcome<std::shared_ptr<const MechanismInputs>> toolOnBody(
  const std::string& tool, const TriangleMesh& mesh_H, const MechanismSoftInput& body, double friction)
{
  auto held = makeRigidMesh(mesh_H);
  if (!held.ok())
  {
    return { nullptr, held.problem };
  }
  MechanismBody inHand, soft;
  inHand.name = tool == body.name ? tool + " in the hand" : tool;
  inHand.kind = MechanismBodyKind::Held;
  inHand.mesh = std::move(held.value);
  soft.name = body.name;
  soft.kind = MechanismBodyKind::Soft;
  auto inputs = std::make_shared<MechanismInputs>();
  inputs->mechanism.bodies = { inHand, soft };
  inputs->mechanism.findsContacts = true;
  inputs->mechanism.foundFriction = friction;
  inputs->soft = { body };
  inputs->unit_m = body.input->unit_m;
  return { std::move(inputs), "" };
}

} // namespace palpate
