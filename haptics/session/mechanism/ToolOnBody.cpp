// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/ToolOnBody.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "haptics/mechanism/sided/SidedSurface.h"

namespace palpate
{
namespace
{

bool isNamed(const std::vector<MechanismBody>& bodies, const std::string& name)
{
  return std::ranges::find(bodies, name, &MechanismBody::name) != bodies.end();
}

/// The others keep their names, by which a person knows them.
std::string nameInHand(std::string name, const std::string& body, const std::vector<MechanismBody>& beside)
{
  while (name == body || isNamed(beside, name))
  {
    name += " in the hand";
  }
  return name;
}

std::string nameBeside(std::string name, const std::vector<MechanismBody>& others)
{
  while (name.empty() || isNamed(others, name))
  {
    name += name.empty() ? "surface" : " too";
  }
  return name;
}

} // namespace

Outcome<std::shared_ptr<const MechanismInputs>> toolOnBody(const std::string& tool, const TriangleMesh& mesh_H,
  const MechanismSoftInput& body, double friction, const std::vector<MechanismBody>& beside, double unit_m)
{
  auto held = makeRigidMesh(mesh_H);
  if (!held.ok())
  {
    return { nullptr, held.problem };
  }
  MechanismBody inHand;
  inHand.name = nameInHand(tool, body.name, beside);
  inHand.kind = MechanismBodyKind::Held;
  inHand.mesh = std::move(held.value);
  auto inputs = std::make_shared<MechanismInputs>();
  inputs->mechanism.bodies = { inHand };
  inputs->unit_m = unit_m;
  if (body.input)
  {
    MechanismBody soft;
    soft.name = body.name;
    soft.kind = MechanismBodyKind::Soft;
    inputs->mechanism.bodies.push_back(std::move(soft));
    inputs->soft = { body };
    inputs->unit_m = body.input->unit_m;
  }
  for (const MechanismBody& each : beside)
  {
    MechanismBody other = each;
    other.name = nameBeside(each.name, inputs->mechanism.bodies);
    inputs->mechanism.bodies.push_back(std::move(other));
  }
  inputs->mechanism.findsContacts = inputs->mechanism.beginsApart = true;
  inputs->mechanism.foundFriction = friction;
  return { std::move(inputs), "" };
}

std::string withUnitTaken(const std::string& refusal, const MechanismInputs& inputs, const std::string& remedy)
{
  const bool ofLoose = std::ranges::any_of(inputs.mechanism.bodies, [&refusal](const MechanismBody& body)
    { return isLoose(body) && refusal.starts_with("Body \"" + body.name + "\" "); });
  if (!ofLoose)
  {
    return refusal;
  }
  std::ostringstream text;
  text << refusal.substr(0, refusal.find_last_not_of('.') + 1) << ": one unit is taken as " << inputs.unit_m << " m; "
       << remedy;
  return text.str();
}

} // namespace palpate
