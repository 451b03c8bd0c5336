// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/ToolOnBody.h"

#include <algorithm>
#include <utility>

#include "haptics/mechanism/sided/SidedSurface.h"

namespace palpate
{
namespace
{

std::string nameBeside(std::string name, const std::vector<MechanismBody>& others)
{
  while (name.empty() || std::ranges::find(others, name, &MechanismBody::name) != others.end())
  {
    name += name.empty() ? "surface" : " too";
  }
  return name;
}

} // namespace

Outcome<std::shared_ptr<const MechanismInputs>> toolOnBody(const std::string& tool, const TriangleMesh& mesh_H,
  const MechanismSoftInput& body, double friction, const std::vector<MechanismBody>& beside)
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
  for (const MechanismBody& each : beside)
  {
    MechanismBody stands = each;
    stands.name = nameBeside(each.name, inputs->mechanism.bodies);
    inputs->mechanism.bodies.push_back(std::move(stands));
  }
  inputs->mechanism.findsContacts = inputs->mechanism.beginsApart = true;
  inputs->mechanism.foundFriction = friction;
  inputs->soft = { body };
  inputs->unit_m = body.input->unit_m;
  return { std::move(inputs), "" };
}

} // namespace palpate
