// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/file/ArmFile.h"

#include <fstream>
#include <numbers>
#include <sstream>

#include <nlohmann/json.hpp>

#include "haptics/core/JsonNode.h"

namespace palpate
{
namespace
{

using Json = nlohmann::json;
using Node = JsonNode<Json>;

constexpr int newestVersion = 1;
constexpr std::streamsize mostBytes = 1 << 20;
constexpr double rad_per_deg = std::numbers::pi / 180.0;

/// Accepts the keys of every kind and those of this one.
void checkKeys(const Node& root, std::initializer_list<const char*> own)
{
  std::vector<const char*> keys{ "format", "version", "name", "source", "kind", "at_m", "turn", "joints", "masses",
    "gravity_m_per_s2", "work_space", "max_force_N", "max_stiffness_N_per_m", "max_damping_Ns_per_m", "max_condition",
    "wire" };
  keys.insert(keys.end(), own);
  if (root.has("wrist"))
  {
    keys.insert(keys.end(), { "wrist", "tip_m" });
  }
  root.knows(keys);
}

Pose poseOf(const Node& node)
{
  return { node.vector("at_m", Vec3::Zero()), node.turn("turn") };
}

/// The chain of hinges that a list says.
SerialGeometry hingesOf(const Node& root, const char* key, int most)
{
  SerialGeometry chain;
  for (const Node& node : root.list(key))
  {
    if (chain.count == most)
    {
      root.fail(key, "a chain has " + std::to_string(most) + " joints at most");
    }
    SerialGeometry::Hinge& hinge = chain.hinges[static_cast<std::size_t>(chain.count++)];
    hinge.origin = poseOf(node);
    hinge.axis = node.vector("axis", Vec3::UnitZ());
    if (!(hinge.axis.norm() > 1e-6))
    {
      node.fail("axis", "must have a direction");
    }
    hinge.axis.normalize();
  }
  chain.tip.p = root.vector("tip_m", Vec3::Zero());
  return chain;
}

SerialGeometry serialOf(const Node& root)
{
  checkKeys(root, { "tip_m" });
  return hingesOf(root, "joints", mostJoints);
}

WoodenGeometry woodenOf(const Node& root)
{
  checkKeys(root, { "column_m", "upper_m", "fore_m" });
  return { root.needsNumber("column_m"), root.needsNumber("upper_m"), root.needsNumber("fore_m") };
}

DeltaGeometry deltaOf(const Node& root)
{
  checkKeys(root, { "legs_deg", "base_m", "platform_m", "arm_m", "forearm_m", "hinge_m", "offset_m", "side" });
  DeltaGeometry delta;
  const Vec3 legs = rad_per_deg * root.vector("legs_deg", { 0.0, 120.0, 240.0 });
  using Azimuth = DeltaGeometry::Azimuth;
  delta.legs = { Azimuth::of(legs.x()), Azimuth::of(legs.y()), Azimuth::of(legs.z()) };
  delta.base_m = root.needsNumber("base_m");
  delta.platform_m = root.needsNumber("platform_m");
  delta.arm_m = root.needsNumber("arm_m");
  delta.forearm_m = root.needsNumber("forearm_m");
  delta.hinge_m = root.number("hinge_m", 0.0);
  delta.offset_m = root.number("offset_m", 0.0);
  delta.side = root.number("side", 1.0);
  root.accept("side", delta.side == 1.0 || delta.side == -1.0 ? "" : "must be 1 or -1");
  return delta;
}

FiveBarGeometry fiveBarOf(const Node& root)
{
  checkKeys(root, { "base_m", "arm_m", "forearm_m" });
  return { root.needsNumber("base_m"), root.needsNumber("arm_m"), root.needsNumber("forearm_m") };
}

ArmGeometry geometryOf(const Node& root)
{
  const std::string kind = root.needed("kind");
  if (kind == "serial")
  {
    return serialOf(root);
  }
  if (kind == "woodenhaptics")
  {
    return woodenOf(root);
  }
  if (kind == "delta")
  {
    return deltaOf(root);
  }
  if (kind == "five-bar")
  {
    return fiveBarOf(root);
  }
  root.fail("kind", "unknown kind \"" + kind + "\"; valid kinds: serial, woodenhaptics, delta, five-bar");
}

/// `motor`: whether it has one where the file does not say.
ArmJoint jointOf(const Node& node, bool isHinge, bool motor)
{
  std::vector<const char*> keys{ "low_deg", "high_deg", "zero_deg", "counts_per_turn", "gear", "follows", "share",
    "calibrated", "motor", "max_torque_Nm", "torque_step_Nm", "torque_constant_Nm_per_A", "rotor_kg_m2", "damping_Nms",
    "friction_Nm" };
  if (isHinge)
  {
    keys.insert(keys.end(), { "at_m", "turn", "axis" });
  }
  node.knows(keys);
  constexpr int mostCounts = 1 << 30;
  ArmJoint joint;
  joint.low_rad = rad_per_deg * node.number("low_deg", joint.low_rad / rad_per_deg);
  joint.high_rad = rad_per_deg * node.number("high_deg", joint.high_rad / rad_per_deg);
  joint.zero_rad = rad_per_deg * node.number("zero_deg", 0.0);
  joint.countsPerTurn = node.size("counts_per_turn");
  joint.gear = node.number("gear", 1.0);
  joint.follows = node.whole("follows", 0, 0, mostJoints) - 1;
  joint.followShare = node.number("share", 0.0);
  joint.calibrated = node.whole("calibrated", 0, -mostCounts, mostCounts);
  joint.hasMotor = node.flag("motor", motor);
  joint.maxTorque_Nm = node.number("max_torque_Nm", joint.maxTorque_Nm);
  joint.torqueStep_Nm = node.size("torque_step_Nm");
  joint.torqueConstant_Nm_per_A = node.size("torque_constant_Nm_per_A");
  joint.rotor_kg_m2 = node.size("rotor_kg_m2");
  joint.damping_Nms = node.size("damping_Nms");
  joint.friction_Nm = node.size("friction_Nm");
  return joint;
}

void readJoints(const Node& root, ArmPlan& plan)
{
  const auto wanted = static_cast<std::size_t>(jointCountOf(plan.geometry));
  const std::vector<Node> nodes = root.list("joints");
  if (nodes.size() != wanted)
  {
    root.fail("joints", "this kind of arm has " + std::to_string(wanted) + " joints");
  }
  const bool isChain = std::holds_alternative<SerialGeometry>(plan.geometry);
  for (std::size_t k = 0; k < wanted; ++k)
  {
    plan.joints[k] = jointOf(nodes[k], isChain, true);
  }
}

/// Its joints come after those of the kind.
void readWrist(const Node& root, ArmPlan& plan)
{
  if (!root.has("wrist"))
  {
    return;
  }
  plan.wrist = hingesOf(root, "wrist", mostWristHinges);
  root.accept("wrist", plan.wrist.count > 0 ? "" : "has no hinge");
  root.accept("wrist", std::holds_alternative<SerialGeometry>(plan.geometry) ? "a chain has its hinges as joints" : "");
  const std::vector<Node> nodes = root.list("wrist");
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    plan.joints[static_cast<std::size_t>(jointCountOf(plan.geometry)) + k] = jointOf(nodes[k], true, false);
  }
}

/// A point in the frame of a link between hinges, else a distance along the link.
Vec3 placeOn(const Node& node, const char* key, bool isHinged, const Vec3& usual)
{
  return isHinged ? node.vector(key, usual) : Vec3(node.number(key, usual.x()), 0.0, 0.0);
}

void readMasses(const Node& root, ArmPlan& plan)
{
  const bool isChain = std::holds_alternative<SerialGeometry>(plan.geometry);
  for (const Node& node : root.has("masses") ? root.list("masses") : std::vector<Node>())
  {
    node.knows({ "kg", "link", "at_m", "to_m" });
    ArmMass mass;
    mass.mass_kg = node.size("kg");
    mass.link = node.whole("link", 1, 1, linkCountOf(DeltaGeometry()) + mostWristHinges);
    const bool isHinged = isChain || mass.link > linkCountOf(plan.geometry);
    mass.from = placeOn(node, "at_m", isHinged, Vec3::Zero());
    mass.to = placeOn(node, "to_m", isHinged, mass.from);
    plan.masses.push_back(mass);
  }
}

void readWorkSpace(const Node& root, ArmPlan& plan)
{
  if (root.has("work_space"))
  {
    const Node node = root.part("work_space");
    node.knows({ "centre_m", "radius_m" });
    plan.workSpace.centre_D = node.vector("centre_m", Vec3::Zero());
    plan.workSpace.radius_m = node.size("radius_m");
  }
}

ArmPlan planOf(const Node& root)
{
  checkHead(root, "palpate arm", newestVersion);
  ArmPlan plan;
  plan.name = root.name();
  plan.source = root.text("source", "");
  plan.geometry = geometryOf(root);
  plan.base_D = poseOf(root);
  readJoints(root, plan);
  readWrist(root, plan);
  readMasses(root, plan);
  readWorkSpace(root, plan);
  plan.gravity_D = root.vector("gravity_m_per_s2", plan.gravity_D);
  plan.maxForce_N = root.number("max_force_N", plan.maxForce_N);
  plan.maxStiffness_N_per_m = root.number("max_stiffness_N_per_m", plan.maxStiffness_N_per_m);
  plan.maxDamping_Ns_per_m = root.number("max_damping_Ns_per_m", plan.maxDamping_Ns_per_m);
  plan.maxCondition = root.number("max_condition", plan.maxCondition);
  root.accept("", refuse(plan));
  if (root.has("wire"))
  {
    static_cast<void>(root.part("wire")); // whoever drives the arm reads it
  }
  return plan;
}

} // namespace

Outcome<ArmPlan> parseArm(const std::string& text)
{
  Outcome<ArmPlan> result;
  result.problem = jsonProblemOf<Json>(
    [&]
    {
      const Json json = Json::parse(text);
      result.value = planOf(Node(json, ""));
    });
  return result;
}

Outcome<std::string> armFileText(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  Outcome<std::string> text;
  text.value.resize(static_cast<std::size_t>(mostBytes) + 1);
  in.read(text.value.data(), static_cast<std::streamsize>(text.value.size()));
  text.value.resize(static_cast<std::size_t>(in.gcount()));
  text.problem = !in.is_open() || text.value.empty()                       ? "it cannot be read, or it is empty"
                 : text.value.size() > static_cast<std::size_t>(mostBytes) ? "an arm file has 1 MiB at most"
                                                                           : "";
  return text;
}

Outcome<ArmPlan> readArmFile(const std::string& file)
{
  const Outcome<std::string> text = armFileText(file);
  Outcome<ArmPlan> result = text.ok() ? parseArm(text.value) : Outcome<ArmPlan>{ {}, text.problem };
  result.problem = result.ok() ? "" : file + ": " + result.problem;
  return result;
}

} // namespace palpate
